#include <Wm5IntrLine3Cone3.h>
#include <Wm5IntrRay3Cylinder3.h>
#include <Wm5IntrRay3Plane3.h>
#include <Wm5IntrRay3Sphere3.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "rayaudit/plugin.h"

/// Wild Magic 5 as a plugin, in float and in double. What is relied on is quoted from the comments
/// of its headers (5.17) that say so.
namespace {

template <class Real>
Wm5::Vector3<Real> vector(const rayaudit_vec3& of) {
  return {static_cast<Real>(of.x), static_cast<Real>(of.y), static_cast<Real>(of.z)};
}

template <class Real>
rayaudit_vec3 in_double(const Wm5::Vector3<Real>& of) {
  return {of.X(), of.Y(), of.Z()};
}

/// "The ray is represented as P+t*D, where P is the ray origin, D is a unit-length direction
/// vector, and t >= 0" (Wm5Ray3.h), and the line likewise, of "any real number" t (Wm5Line3.h).
template <class Of, class Real>
Of placed(const rayaudit_ray& ray) {
  return {vector<Real>(ray.origin), vector<Real>(ray.direction)};
}

/// The first of the points found, for which no order is told, as it is.
template <class Found>
rayaudit_answer first(const Found& found, int count, const rayaudit_ray& ray) {
  double first = std::numeric_limits<double>::infinity();
  rayaudit_answer answer = rayaudit_miss();
  for (int i = 0; i < count; ++i) {
    const auto [x, y, z] = in_double(found.GetPoint(i));
    const auto& [ox, oy, oz] = ray.origin;
    const auto& [dx, dy, dz] = ray.direction;
    const double t = (x - ox) * dx + (y - oy) * dy + (z - oz) * dz;
    if (t > first) continue;
    first = t;
    answer = rayaudit_at(x, y, z);
  }
  return answer;
}

/// "The user must ensure that the normal vector is unit length" (Wm5Plane3.h). One that is not is
/// normalised by the library's own function; one that is stays.
template <class Real>
struct Plane {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_disk& disk) {
    Wm5::Vector3<Real> normal = vector<Real>(disk.normal);
    const Real off = normal.SquaredLength() - 1;
    if (!(std::fabs(off) <= 4 * std::numeric_limits<Real>::epsilon())) normal.Normalize();
    const auto asked = placed<Wm5::Ray3<Real>, Real>(ray);
    const Wm5::Plane3<Real> plane(normal, vector<Real>(disk.centre));
    Wm5::IntrRay3Plane3<Real> met(asked, plane);
    // "P = origin + t*direction, with t >= 0" (Wm5IntrRay3Plane3.h)
    if (!met.Find()) return rayaudit_miss();
    return rayaudit_hit(met.GetRayParameter());
  }
};

template <class Real>
struct Sphere {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
    const auto asked = placed<Wm5::Ray3<Real>, Real>(ray);
    const Wm5::Sphere3<Real> body(vector<Real>(sphere.centre), static_cast<Real>(sphere.radius));
    Wm5::IntrRay3Sphere3<Real> met(asked, body);
    if (!met.Find()) return rayaudit_miss();
    rayaudit_answer answer = rayaudit_miss();
    for (int i = met.GetQuantity() - 1; i >= 0; --i) {
      const Real t = met.GetRayParameter(i);
      if (!(answer.form == RAYAUDIT_HIT && t > answer.t)) answer = rayaudit_hit(t);
    }
    return answer;
  }
};

/// One without ends "has infinite height", which is told nowhere how to say: it is not asked. "A
/// finite cylinder has center C at the line origin" (Wm5Cylinder3.h) and, as nothing says but
/// the points that are found, caps.
template <class Real>
struct CappedCylinder {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cylinder& cylinder) {
    const auto asked = placed<Wm5::Ray3<Real>, Real>(ray);
    const Wm5::Line3<Real> axis({0, 0, 0}, {0, 0, 1});
    const Wm5::Cylinder3<Real> body(axis, static_cast<Real>(cylinder.radius),
                                    static_cast<Real>(cylinder.top.z - cylinder.base.z));
    Wm5::IntrRay3Cylinder3<Real> met(asked, body);
    if (!met.Find()) return rayaudit_miss();
    return first(met, met.GetQuantity(), ray);
  }
};

/// "This is an infinite, single-sided cone"; "For an infinite cone, set 'height' to
/// Math<Real>::MAX_FLOAT"; by "The pair (cosAngle,sinAngle)" (Wm5Cone3.h). Of an intersection ray
/// the second point is a direction, which "point[0]+t*point[1] is the intersection ray"
/// (Wm5IntrLine3Cone3.h) says.
template <class Real>
struct Cone {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cone& cone) {
    const long double tangent = cone.radius / (cone.apex.z - cone.base.z);
    const long double cosine = 1 / std::sqrt(1 + tangent * tangent);
    const Wm5::Cone3<Real> body(vector<Real>(cone.apex), {0, 0, -1}, static_cast<Real>(cosine),
                                static_cast<Real>(tangent * cosine),
                                std::numeric_limits<Real>::max());
    const auto asked = placed<Wm5::Line3<Real>, Real>(ray);
    Wm5::IntrLine3Cone3<Real> met(asked, body);
    if (!met.Find()) return rayaudit_miss();
    using Kind = Wm5::Intersector<Real, Wm5::Vector3<Real>>;
    const bool is_segment = met.GetIntersectionType() == Kind::IT_SEGMENT;
    return first(met, is_segment ? 2 : 1, ray);
  }
};

/// The batch of what stands for a shape, which is a member of what a case is.
template <class Body, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = Body::hit(cases[i].ray, cases[i].is.*shape);
}

constexpr rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.unit_direction = 1;  // "The user must ensure that D is indeed unit length" (Wm5Ray3.h)
  made.extent = RAYAUDIT_UNBOUNDED;
  made.stand = RAYAUDIT_UPRIGHT_Z;
  return made;
}

/// Of touches the headers say nothing.
constexpr rayaudit_convention rays() {
  rayaudit_convention made = declared();
  // Whatever the case has: a ray "has t >= 0" (Wm5Ray3.h) and no other range.
  made.line = 1, made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

/// A cone meets lines only.
constexpr rayaudit_convention lines() {
  rayaudit_convention made = declared();
  made.line = 1;
  made.opening = RAYAUDIT_BY_COSINE;
  return made;
}

using Shapes = decltype(rayaudit_case::is);

template <class Real>
constexpr rayaudit_subject subject_of_rays(const char* format) {
  return {.name = "wild_magic",
          .format = format,
          .convention = rays(),
          .disk = batch<Plane<Real>, &Shapes::disk>,
          .sphere = batch<Sphere<Real>, &Shapes::sphere>,
          .cylinder = nullptr,
          .cone = nullptr,
          .capped_cylinder = batch<CappedCylinder<Real>, &Shapes::capped_cylinder>,
          .capped_cone = nullptr,
          .about = "Wild Magic " WILD_MAGIC_VERSION
                   ", IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3"};
}

template <class Real>
constexpr rayaudit_subject subject_of_lines(const char* format) {
  return {.name = "wild_magic_line",
          .format = format,
          .convention = lines(),
          .disk = nullptr,
          .sphere = nullptr,
          .cylinder = nullptr,
          .cone = batch<Cone<Real>, &Shapes::cone>,
          .capped_cylinder = nullptr,
          .capped_cone = nullptr,
          .about = "Wild Magic " WILD_MAGIC_VERSION ", IntrLine3Cone3"};
}

const rayaudit_subject subjects[] = {
    subject_of_rays<float>("float"), subject_of_rays<double>("double"),
    subject_of_lines<float>("float"), subject_of_lines<double>("double")};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
