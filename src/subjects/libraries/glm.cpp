#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
#include <limits>

#include "rayaudit/plugin.h"

/// GLM as a plugin: the functions of its extension GLM_GTX_intersect that ask about a sphere or a
/// plane, in float and in double. What is relied on is quoted from their comments in
/// <glm/gtx/intersect.hpp>.
namespace {

template <class T>
using Vector = glm::vec<3, T>;

template <class T>
Vector<T> vector(const rayaudit_vec3& of) {
  return Vector<T>(of.x, of.y, of.z);
}

template <class T>
rayaudit_answer at(const Vector<T>& point) {
  return rayaudit_at(point.x, point.y, point.z);
}

/// "Ray direction and plane normal must be unit length": the normal of a disk is of any.
template <class T>
Vector<T> unit(const rayaudit_vec3& of) {
  const double length = std::hypot(of.x, of.y, of.z);
  return Vector<T>(of.x / length, of.y / length, of.z / length);
}

/// "Compute the intersection of a ray and a plane."
template <class T>
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  T distance = 0;
  const bool meets = glm::intersectRayPlane(vector<T>(ray.origin), vector<T>(ray.direction),
                                            vector<T>(disk.centre), unit<T>(disk.normal), distance);
  return meets ? rayaudit_hit(distance) : rayaudit_miss();
}

/// "Compute the intersection distance of a ray and a sphere", which is told the square of its
/// radius, rounded as the product of two T is.
template <class T>
rayaudit_answer distance(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const T radius = static_cast<T>(sphere.radius);
  T distance = 0;
  const bool meets = glm::intersectRaySphere(vector<T>(ray.origin), vector<T>(ray.direction),
                                             vector<T>(sphere.centre), radius * radius, distance);
  return meets ? rayaudit_hit(distance) : rayaudit_miss();
}

/// "Compute the intersection of a ray and a sphere", which is told its radius.
template <class T>
rayaudit_answer position(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  Vector<T> position, normal;
  const bool meets = glm::intersectRaySphere(vector<T>(ray.origin), vector<T>(ray.direction),
                                             vector<T>(sphere.centre),
                                             static_cast<T>(sphere.radius), position, normal);
  return meets ? at(position) : rayaudit_miss();
}

/// "Compute the intersection of a line and a sphere", in no said order: the point that comes first
/// along the line is told.
template <class T>
rayaudit_answer line(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const auto from = vector<T>(ray.origin), along = vector<T>(ray.direction);
  Vector<T> one, one_normal, other, other_normal;
  if (!glm::intersectLineSphere(from, from + along, vector<T>(sphere.centre),
                                static_cast<T>(sphere.radius), one, one_normal, other,
                                other_normal))
    return rayaudit_miss();
  return at(glm::dot(other - one, along) < 0 ? other : one);
}

template <auto hit, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = hit(cases[i].ray, cases[i].is.*shape);
}

/// "The ray direction vector is unit length", t within "ray": from its start on. Of touches and of
/// a start inside nothing is said.
rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.unit_direction = 1;
  made.extent = RAYAUDIT_UNBOUNDED;
  // It knows no range: whatever the ray has, it answers from its start on, without end.
  made.line = 1, made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

/// "line", through point0 and point1: both ways, and its direction is their difference.
rayaudit_convention declared_line() {
  rayaudit_convention made = {};
  made.line = made.segment = 1;
  return made;
}

rayaudit_subject subject(const char* name, const char* format, const rayaudit_convention& declared,
                         const char* about, rayaudit_batch sphere, rayaudit_batch disk = nullptr) {
  rayaudit_subject made = {};
  made.name = name, made.format = format, made.convention = declared, made.about = about;
  made.sphere = sphere, made.disk = disk;
  return made;
}

using Shapes = decltype(rayaudit_case::is);

constexpr auto distances = GLM_VERSION_MESSAGE ", intersectRaySphere and intersectRayPlane";
constexpr auto positions = GLM_VERSION_MESSAGE ", intersectRaySphere for a position";
constexpr auto lines = GLM_VERSION_MESSAGE ", intersectLineSphere";

const rayaudit_subject subjects[] = {
    subject("glm", "float", declared(), distances, batch<distance<float>, &Shapes::sphere>,
            batch<plane<float>, &Shapes::disk>),
    subject("glm", "double", declared(), distances, batch<distance<double>, &Shapes::sphere>,
            batch<plane<double>, &Shapes::disk>),
    subject("glm_position", "float", declared(), positions,
            batch<position<float>, &Shapes::sphere>),
    subject("glm_position", "double", declared(), positions,
            batch<position<double>, &Shapes::sphere>),
    subject("glm_line", "float", declared_line(), lines, batch<line<float>, &Shapes::sphere>),
    subject("glm_line", "double", declared_line(), lines, batch<line<double>, &Shapes::sphere>)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
