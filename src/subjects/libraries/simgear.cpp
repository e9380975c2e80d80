#include <simgear/compiler.h>
#include <simgear/version.h>

#include <limits>
#include <simgear/math/SGGeometry.hxx>

#include "rayaudit/plugin.h"

/// SimGear as a plugin: its ray against its sphere and its plane, in float and in double. What is
/// relied on is quoted from <simgear/math/SGIntersect.hxx>.
namespace {

template <class T>
SGVec3<T> vector(const rayaudit_vec3& of) {
  return {static_cast<T>(of.x), static_cast<T>(of.y), static_cast<T>(of.z)};
}

template <class T>
SGRay<T> built(const rayaudit_ray& ray) {
  return {vector<T>(ray.origin), vector<T>(ray.direction)};
}

template <class T>
rayaudit_answer sphere(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const SGSphere<T> body(vector<T>(sphere.centre), static_cast<T>(sphere.radius));
  return intersects(built<T>(ray), body) ? rayaudit_yes() : rayaudit_miss();
}

/// "For 0 <= \alpha the ray intersects the infinite plane", "normalized" neither the direction nor,
/// as told here, the normal.
template <class T>
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const SGPlane<T> infinite(vector<T>(disk.normal), vector<T>(disk.centre));
  SGVec3<T> at;
  if (!intersects(at, built<T>(ray), infinite)) return rayaudit_miss();
  return rayaudit_at(at[0], at[1], at[2]);
}

template <auto hit, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = hit(cases[i].ray, cases[i].is.*shape);
}

using Shapes = decltype(rayaudit_case::is);

/// "from the ray origin and non nomalized direction"
template <class T>
rayaudit_subject subject(const char* format, const char* about) {
  rayaudit_subject made = {};
  made.name = "simgear", made.format = format, made.about = about;
  made.convention.extent = RAYAUDIT_UNBOUNDED;
  // It knows no range: whatever the ray has, it answers from its start on, without end.
  made.convention.line = 1;
  made.convention.t_max = std::numeric_limits<double>::infinity();
  made.disk = batch<plane<T>, &Shapes::disk>;
  made.sphere = batch<sphere<T>, &Shapes::sphere>;
  return made;
}

constexpr auto about = "SimGear, intersects of an SGRay";

const rayaudit_subject subjects[] = {subject<float>("float", about),
                                     subject<double>("double", about)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
