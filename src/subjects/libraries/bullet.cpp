#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <btBulletCollisionCommon.h>

#include <string>

#include "rayaudit/plugin.h"

/// Bullet as a plugin, compiled once for its floats and once for its doubles: the ray test of a
/// sphere, a cylinder and a cone, which are solids. What is relied on is quoted from the comments
/// of its headers.
namespace {

/// "SubSimplexConvexCastRaytest is the default", and "Uses an approximate but faster ray versus
/// convex intersection algorithm" (btRaycastCallback.h): how near it comes is said nowhere, so no
/// sentence in programs/ makes a defect of a t that is off, nor of a hit that is passed by.
constexpr unsigned subsimplex = btTriangleRaycastCallback::kF_None;
constexpr unsigned gjk = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;

btVector3 vector(const rayaudit_vec3& of) {
  return {static_cast<btScalar>(of.x), static_cast<btScalar>(of.y), static_cast<btScalar>(of.z)};
}
btTransform at(const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); }

/// "rayTestSingle performs a raycast call and calls the resultCallback. It is used internally by
/// rayTest." (btCollisionWorld.h) It takes the ends of a segment, and tells how far along it hits.
rayaudit_answer hit(const rayaudit_ray& ray, const btVector3& place, const btCollisionShape& shape,
                    unsigned caster) {
  const btVector3 from = vector(ray.origin), to = from + vector(ray.direction);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  met.m_flags = caster;
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(place), met);
  return met.hasHit() ? rayaudit_hit(met.m_closestHitFraction) : rayaudit_miss();
}

template <unsigned caster>
void spheres(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [centre, radius] = cases[i].is.sphere;
    const btSphereShape sphere(static_cast<btScalar>(radius));
    answers[i] = hit(cases[i].ray, vector(centre), sphere, caster);
  }
}

/// The same of a solid that is "centered around the origin" and "around the Z axis"
/// (btCylinderShape.h, btConeShape.h).
template <class Shape>
rayaudit_answer upright(const rayaudit_ray& ray, Shape shape) {
  // "you need to make sure to set a smaller collision margin, using the 'setMargin' API"
  // (btCollisionMargin.h), where objects are small. A cone grows by its margin, and a cylinder's
  // edges are rounded by it. But "zero margin might introduce problems" (the user manual, Collision
  // Margin): so no sentence in programs/ makes a defect of what these answer, and GJK is not asked.
  shape.setMargin(0);
  return hit(ray, {0, 0, 0}, shape, subsimplex);
}

void cylinders(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [base, top, radius] = cases[i].is.capped_cylinder;
    const btVector3 half = vector({radius, radius, top.z});
    answers[i] = upright(cases[i].ray, btCylinderShapeZ(half));
  }
}

void cones(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [base, apex, radius] = cases[i].is.capped_cone;
    const auto height = static_cast<btScalar>(apex.z - base.z);
    answers[i] = upright(cases[i].ray, btConeShapeZ(static_cast<btScalar>(radius), height));
  }
}

/// "Objects should not start in overlap, otherwise results are not defined."
/// (btSubSimplexConvexCast.h): from inside anything is right.
rayaudit_subject subject(const std::string& name, const std::string& about) {
  rayaudit_subject made = {};
  made.name = name.c_str(), made.about = about.c_str();
  made.format = btIsDoublePrecision() ? "double" : "float";
  made.convention.inside = RAYAUDIT_INSIDE_IS_ANY;
  made.convention.stand = RAYAUDIT_UPRIGHT_Z;
  made.convention.segment = 1;
  return made;
}

/// A sphere has no margin but its radius.
template <unsigned caster>
rayaudit_subject of_spheres(const std::string& name, const std::string& about) {
  rayaudit_subject made = subject(name, about);
  made.sphere = spheres<caster>;
  return made;
}

rayaudit_subject of_solids(const std::string& name, const std::string& about) {
  rayaudit_subject made = subject(name, about);
  made.capped_cylinder = cylinders, made.capped_cone = cones;
  return made;
}

const std::string version =
    std::to_string(btGetVersion() / 100) + '.' + std::to_string(btGetVersion() % 100);
const std::string about = "Bullet " + version + ", rayTestSingle";
const std::string about_gjk = about + " with kF_UseGjkConvexCastRaytest";
const std::string about_bare = about + ", setMargin(0)";

const std::string name = btIsDoublePrecision() ? "bullet64" : "bullet";
const std::string name_gjk = name + "_gjk";
const std::string name_bare = name + "_no_margin";

const rayaudit_subject subjects[] = {of_spheres<subsimplex>(name, about),
                                     of_spheres<gjk>(name_gjk, about_gjk),
                                     of_solids(name_bare, about_bare)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
