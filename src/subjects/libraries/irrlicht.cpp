#include <irrlicht/line3d.h>

#include <cmath>

#include "rayaudit/plugin.h"

/// Irrlicht as a plugin: its line against a sphere, in float and in double. What is relied on is
/// quoted from the comments of <irrlicht/line3d.h>.
namespace {

template <class T>
using Vector = irr::core::vector3d<T>;

template <class T>
Vector<T> vector(const rayaudit_vec3& of) {
  return {static_cast<T>(of.x), static_cast<T>(of.y), static_cast<T>(of.z)};
}

/// "The distance to the first intersection point", from the start of the line: in units of the
/// direction only after a division.
template <class T>
rayaudit_answer sphere(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const auto from = vector<T>(ray.origin), along = vector<T>(ray.direction);
  const irr::core::line3d<T> line(from, from + along);
  irr::f64 distance = 0;
  if (!line.getIntersectionWithSphere(vector<T>(sphere.centre), static_cast<T>(sphere.radius),
                                      distance))
    return rayaudit_miss();
  return rayaudit_hit(distance / std::hypot(along.X, along.Y, along.Z));
}

template <class T>
void spheres(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = sphere<T>(cases[i].ray, cases[i].is.sphere);
}

/// "3D line between two points" that "intersects with a shpere": the function knows no ends, so the
/// line is taken for all of it, both ways.
template <class T>
rayaudit_subject subject(const char* format) {
  rayaudit_subject made = {};
  made.name = "irrlicht", made.format = format;
  made.about = "Irrlicht " IRRLICHT_SDK_VERSION ", line3d::getIntersectionWithSphere";
  made.convention.line = made.convention.segment = 1;
  made.sphere = spheres<T>;
  return made;
}

const rayaudit_subject subjects[] = {subject<float>("float"), subject<double>("double")};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
