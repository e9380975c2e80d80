#include <ode/ode.h>

#include <cmath>
#include <limits>

#include "rayaudit/plugin.h"

/// ODE as a plugin: dCollide of a ray with a sphere and with a cylinder, which has its caps. What
/// is relied on is quoted from its manual (Collision Detection, Geometry Classes).
namespace {

/// A ray, which is another for every case; the library is made ready for it.
class Ray {
 public:
  Ray() {
    dInitODE2(0);
    geometry_ = dCreateRay(nullptr, 1);
  }

  /// The first hit on the other: "at most one contact point".
  rayaudit_answer hit(const rayaudit_ray& ray, dGeomID other) {
    const auto& [from, along, near, far] = ray;
    const dReal length = std::hypot(along.x, along.y, along.z);
    // "Set the starting position (px,py,pz) and direction (dx,dy,dz)": of any length, for the ray
    // has one of its own, "the given length".
    dGeomRaySetLength(geometry_, std::isinf(far) ? dInfinity : far * length);
    dGeomRaySet(geometry_, from.x, from.y, from.z, along.x, along.y, along.z);
    dContactGeom contact;
    if (dCollide(geometry_, other, 1, &contact, sizeof contact) == 0) return rayaudit_miss();
    // "depth - This is the distance from the start of the ray to the contact point."
    return rayaudit_hit(contact.depth / length);
  }

 private:
  dGeomID geometry_;
};

void spheres(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  static Ray ray;
  static const dGeomID sphere = dCreateSphere(nullptr, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [centre, radius] = cases[i].is.sphere;
    dGeomSphereSetRadius(sphere, radius);
    dGeomSetPosition(sphere, centre.x, centre.y, centre.z);
    answers[i] = ray.hit(cases[i].ray, sphere);
  }
}

/// "The cylinder's length is along the geom's local Z axis", which is the world's.
void cylinders(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  static Ray ray;
  static const dGeomID cylinder = dCreateCylinder(nullptr, 1, 1);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [base, top, radius] = cases[i].is.capped_cylinder;
    dGeomCylinderSetParams(cylinder, radius, top.z - base.z);
    answers[i] = ray.hit(cases[i].ray, cylinder);
  }
}

/// "pos - This is the point at which the ray intersects the surface of the other geom, regardless
/// of whether the ray starts from inside or outside the geom." Of touches nothing is said.
constexpr rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.stand = RAYAUDIT_UPRIGHT_Z;
  // Whatever the case has: its range begins at 0 and has no end.
  made.line = 1, made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

const rayaudit_subject subjects[] = {
    {.name = "ode",
     .format = sizeof(dReal) == sizeof(double) ? "double" : "float",
     .convention = declared(),
     .disk = nullptr,
     .sphere = spheres,
     .cylinder = nullptr,
     .cone = nullptr,
     .capped_cylinder = cylinders,
     .capped_cone = nullptr,
     .about = "ODE " dODE_VERSION ", dCollide"}};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
