#include <nanovdb/util/Ray.h>

#include <string>

#include "rayaudit/plugin.h"

/// NanoVDB as a plugin: its ray, asked about a sphere and about a plane, in float and in double.
/// What is relied on is quoted from the comments of <nanovdb/util/Ray.h>.
namespace {

template <class T>
nanovdb::Vec3<T> vector(const rayaudit_vec3& of) {
  return {static_cast<T>(of.x), static_cast<T>(of.y), static_cast<T>(of.z)};
}

template <class T>
nanovdb::Ray<T> built(const rayaudit_ray& ray) {
  return {vector<T>(ray.origin), vector<T>(ray.direction), static_cast<T>(ray.t_min),
          static_cast<T>(ray.t_max)};
}

/// "The first intersection point if an intersection exists" and the second. "If the return value is
/// true, i.e. a hit, and t0 = this->t0() or t1 == this->t1() only one true intersection exist":
/// such a t is an end of the ray.
template <class T>
rayaudit_answer sphere(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const nanovdb::Ray<T> asked = built<T>(ray);
  T t0 = 0, t1 = 0;
  if (!asked.intersects(vector<T>(sphere.centre), static_cast<T>(sphere.radius), t0, t1))
    return rayaudit_miss();
  if (t0 != asked.t0()) return rayaudit_hit(t0);
  return t1 != asked.t1() ? rayaudit_hit(t1) : rayaudit_miss();
}

/// "Return true if the Ray intersects the plane specified by a normal and point."
template <class T>
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  T t = 0;
  const bool meets = built<T>(ray).intersects(vector<T>(disk.normal), vector<T>(disk.centre), t);
  return meets ? rayaudit_hit(t) : rayaudit_miss();
}

template <auto hit, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = hit(cases[i].ray, cases[i].is.*shape);
}

using Shapes = decltype(rayaudit_case::is);

std::string version() {
  const auto text = [](int number) { return std::to_string(number); };
  return "NanoVDB " + text(NANOVDB_MAJOR_VERSION_NUMBER) + "." +
         text(NANOVDB_MINOR_VERSION_NUMBER) + "." + text(NANOVDB_PATCH_VERSION_NUMBER) +
         ", Ray::intersects";
}
const std::string about = version();

/// From "t0 = Delta<RealT>::value()" to "t1 = Maximum<RealT>::value()", what a ray has if nothing
/// is said. Neither the direction nor the normal is said to be of length 1.
template <class T>
rayaudit_subject subject(const char* format) {
  rayaudit_subject made = {};
  made.name = "nanovdb", made.format = format, made.about = about.c_str();
  made.convention.extent = RAYAUDIT_UNBOUNDED;
  made.convention.t_min = nanovdb::Delta<T>::value();
  made.convention.t_max = nanovdb::Maximum<T>::value();
  made.disk = batch<plane<T>, &Shapes::disk>;
  made.sphere = batch<sphere<T>, &Shapes::sphere>;
  return made;
}

const rayaudit_subject subjects[] = {subject<float>("float"), subject<double>("double")};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
