#include <Imath/ImathLine.h>
#include <Imath/ImathPlane.h>
#include <Imath/ImathSphere.h>

#include <limits>

#include "rayaudit/plugin.h"

/// Imath as a plugin: its sphere, asked for t and for the point, and its plane, in float and in
/// double. What is relied on is quoted from the comments of its headers.
namespace {

template <class T>
Imath::Vec3<T> vector(const rayaudit_vec3& of) {
  return {static_cast<T>(of.x), static_cast<T>(of.y), static_cast<T>(of.z)};
}

/// Its "point on the line" and "direction of the line" (ImathLine.h), as they are.
template <class T>
Imath::Line3<T> line(const rayaudit_ray& ray) {
  Imath::Line3<T> made;
  made.pos = vector<T>(ray.origin), made.dir = vector<T>(ray.direction);
  return made;
}

template <class T>
Imath::Sphere3<T> solid(const rayaudit_sphere& sphere) {
  return {vector<T>(sphere.centre), static_cast<T>(sphere.radius)};
}

/// "compute the smallest `t` with `t>=0` so that `l(t)` is a point on the sphere" (ImathSphere.h)
template <class T>
rayaudit_answer parameter(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  T t = 0;
  return solid<T>(sphere).intersectT(line<T>(ray), t) ? rayaudit_hit(t) : rayaudit_miss();
}

/// The same as "The point of intersection" (ImathSphere.h).
template <class T>
rayaudit_answer point(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  Imath::Vec3<T> at;
  if (!solid<T>(sphere).intersect(line<T>(ray), at)) return rayaudit_miss();
  return rayaudit_at(at.x, at.y, at.z);
}

/// "Initialize with a point and a normal", "True if the line intersects the plane" (ImathPlane.h)
template <class T>
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const Imath::Plane3<T> plane(vector<T>(disk.centre), vector<T>(disk.normal));
  T t = 0;
  return plane.intersectT(line<T>(ray), t) ? rayaudit_hit(t) : rayaudit_miss();
}

template <auto hit, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = hit(cases[i].ray, cases[i].is.*shape);
}

/// That the direction is of length 1 no comment says; the constructors of a line and its set() make
/// it so ("dir.normalize ()", ImathLine.h), and the sphere counts on it ("A = 1", ImathSphere.h).
rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.unit_direction = 1;
  // It knows no range: whatever the ray has, it answers for "t>=0", without end.
  made.line = 1, made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

/// "Determine if a line intersects the plane": both ways, and no bound to the plane.
rayaudit_convention declared_plane() {
  rayaudit_convention made = {};
  made.line = 1;
  made.extent = RAYAUDIT_UNBOUNDED;
  return made;
}

rayaudit_subject spheres(const char* name, const char* format, const char* about,
                         rayaudit_batch sphere) {
  rayaudit_subject made = {};
  made.name = name, made.format = format, made.convention = declared(), made.about = about;
  made.sphere = sphere;
  return made;
}

rayaudit_subject planes(const char* format, rayaudit_batch disk) {
  rayaudit_subject made = {};
  made.name = "imath_plane", made.format = format, made.convention = declared_plane();
  made.about = "Imath " IMATH_VERSION_STRING ", Plane3::intersectT";
  made.disk = disk;
  return made;
}

using Shapes = decltype(rayaudit_case::is);
constexpr auto parameters = "Imath " IMATH_VERSION_STRING ", Sphere3::intersectT";
constexpr auto points = "Imath " IMATH_VERSION_STRING ", Sphere3::intersect";

const rayaudit_subject subjects[] = {
    spheres("imath", "float", parameters, batch<parameter<float>, &Shapes::sphere>),
    spheres("imath", "double", parameters, batch<parameter<double>, &Shapes::sphere>),
    spheres("imath_point", "float", points, batch<point<float>, &Shapes::sphere>),
    spheres("imath_point", "double", points, batch<point<double>, &Shapes::sphere>),
    planes("float", batch<plane<float>, &Shapes::disk>),
    planes("double", batch<plane<double>, &Shapes::disk>)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
