#include <SimTKmath.h>

#include <limits>
#include <string>

#include "rayaudit/plugin.h"

/// Simbody as a plugin: ContactGeometry::intersectsRay of a sphere, of an ellipsoid whose half-axes
/// are one radius, and of a cylinder without ends. What is relied on is quoted from the comments of
/// simmath/internal/ContactGeometry.h.
namespace {

using SimTK::ContactGeometry;
using SimTK::Vec3;

Vec3 vector(const rayaudit_vec3& of) { return {of.x, of.y, of.z}; }

/// "The position at which the ray begins", in the frame of the shape. "The ray direction" is a
/// UnitVec3, which normalises what it is made of; "the distance from the ray origin to the
/// intersection point" counts in its units.
rayaudit_answer hit(const rayaudit_ray& ray, const Vec3& from, const ContactGeometry& shape) {
  const Vec3 along = vector(ray.direction);
  SimTK::Real distance;
  SimTK::UnitVec3 normal;
  if (!shape.intersectsRay(from, SimTK::UnitVec3(along), distance, normal)) return rayaudit_miss();
  return rayaudit_hit(distance / along.norm());
}

/// "a sphere centered at the origin", "half-axis dimensions a,b,c [...] along the local x,y,z
/// directions": either is moved by a Transform, as the library's users move it, which subtracts its
/// centre from where the ray begins and rounds. That is audited with it.
template <class Shape>
void spheres(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [centre, radius] = cases[i].is.sphere;
    const SimTK::Transform place(vector(centre));
    answers[i] = hit(cases[i].ray, place.shiftBaseStationToFrame(vector(cases[i].ray.origin)),
                     Shape(typename Shape::Size(radius)));
  }
}

struct Sphere : ContactGeometry::Sphere {
  using Size = SimTK::Real;
  using ContactGeometry::Sphere::Sphere;
};
struct Ellipsoid : ContactGeometry::Ellipsoid {
  using Size = Vec3;
  using ContactGeometry::Ellipsoid::Ellipsoid;
};

/// "a cylinder centered at the origin, with radius r in the x-y plane, and infinite length along z"
void cylinders(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i)
    answers[i] = hit(cases[i].ray, vector(cases[i].ray.origin),
                     ContactGeometry::Cylinder(cases[i].is.cylinder.radius));
}

/// Of a ray that begins inside, and of touches, nothing is said.
rayaudit_subject subject(const char* name, const char* about, rayaudit_batch sphere,
                         rayaudit_batch cylinder) {
  rayaudit_subject made = {};
  made.name = name, made.format = "double", made.about = about;
  made.convention.extent = RAYAUDIT_UNBOUNDED;
  made.convention.stand = RAYAUDIT_UPRIGHT_Z;
  // Whatever the case has: its range begins at 0 and has no end.
  made.convention.line = 1;
  made.convention.t_min = 0;
  made.convention.t_max = std::numeric_limits<double>::infinity();
  made.sphere = sphere, made.cylinder = cylinder;
  return made;
}

std::string version() {
  int major, minor, build;
  SimTK_version_simmath(&major, &minor, &build);
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(build);
}

const std::string about = "Simbody " + version() + ", ContactGeometry::intersectsRay";
const std::string about_ellipsoid = about + " of an ellipsoid";

const rayaudit_subject subjects[] = {
    subject("simbody", about.c_str(), spheres<Sphere>, cylinders),
    subject("simbody_ellipsoid", about_ellipsoid.c_str(), spheres<Ellipsoid>, nullptr)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
