#include <mujoco/mujoco.h>

#include <limits>
#include <string>

#include "rayaudit/plugin.h"

/// MuJoCo as a plugin: mju_rayGeom of a sphere, of an ellipsoid whose half-axes are one radius, and
/// of a cylinder, which has its caps. What is relied on is quoted from mujoco.h and from its API
/// reference (Ray collisions).
namespace {

/// "Intersect ray (pnt+x*vec, x>=0)" (mujoco.h): x is in units of the direction. "Return distance
/// (x) to nearest surface, or -1 if no intersection" (mujoco.h).
rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_vec3& at, const mjtNum (&size)[3],
                    mjtGeom type) {
  const mjtNum position[] = {at.x, at.y, at.z};
  const mjtNum upright[] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  const mjtNum from[] = {ray.origin.x, ray.origin.y, ray.origin.z};
  const mjtNum along[] = {ray.direction.x, ray.direction.y, ray.direction.z};
  const mjtNum x = mju_rayGeom(position, upright, size, from, along, type);
  return x == -1 ? rayaudit_miss() : rayaudit_hit(x);
}

void spheres(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [centre, radius] = cases[i].is.sphere;
    answers[i] = hit(cases[i].ray, centre, {radius, 0, 0}, mjGEOM_SPHERE);
  }
}

void ellipsoids(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [centre, radius] = cases[i].is.sphere;
    answers[i] = hit(cases[i].ray, centre, {radius, radius, radius}, mjGEOM_ELLIPSOID);
  }
}

/// Radius and half the length, along z.
void cylinders(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [base, top, radius] = cases[i].is.capped_cylinder;
    answers[i] = hit(cases[i].ray, {0, 0, 0}, {radius, top.z, 0}, mjGEOM_CYLINDER);
  }
}

/// "if p is inside a geom, the ray will intersect the surface from the inside which still counts as
/// an intersection" (API reference). Of touches nothing is said.
rayaudit_subject subject(const char* name, const char* about, rayaudit_batch sphere,
                         rayaudit_batch capped_cylinder) {
  rayaudit_subject made = {};
  made.name = name, made.format = "double", made.about = about;
  made.convention.stand = RAYAUDIT_UPRIGHT_Z;
  // Whatever the case has: its range begins at 0 and has no end.
  made.convention.line = 1;
  made.convention.t_min = 0;
  made.convention.t_max = std::numeric_limits<double>::infinity();
  made.sphere = sphere, made.capped_cylinder = capped_cylinder;
  return made;
}

const std::string about = std::string("MuJoCo ") + mj_versionString() + ", mju_rayGeom";
const std::string about_ellipsoid = about + " of an ellipsoid";

const rayaudit_subject subjects[] = {
    subject("mujoco", about.c_str(), spheres, cylinders),
    subject("mujoco_ellipsoid", about_ellipsoid.c_str(), ellipsoids, nullptr)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
