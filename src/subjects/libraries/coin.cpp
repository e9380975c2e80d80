#include <Inventor/SbCylinder.h>
#include <Inventor/SbLine.h>
#include <Inventor/SbPlane.h>
#include <Inventor/SbSphere.h>
#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoCone.h>
#include <Inventor/nodes/SoCylinder.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTranslation.h>

#include <cmath>
#include <limits>

#include "rayaudit/plugin.h"

/// Coin as a plugin, by both ways in which it answers: its classes for lines and simple bodies, and
/// a ray that picks in a scene. What is relied on is quoted from its class documentation (4.0.0)
/// that says so.
namespace {

SbVec3f vector(const rayaudit_vec3& of) {
  return {static_cast<float>(of.x), static_cast<float>(of.y), static_cast<float>(of.z)};
}

rayaudit_answer at(const SbVec3f& point) { return rayaudit_at(point[0], point[1], point[2]); }

/// "Be aware that the direction vector will be normalized" (SbLine::setPosDir).
SbLine line(const rayaudit_ray& ray) {
  SbLine made;
  made.setPosDir(vector(ray.origin), vector(ray.direction));
  return made;
}

/// "Find the point on given line l intersecting the plane. ... If the line is parallel to the
/// plane, we return FALSE" (SbPlane::intersect); from "a normal and a point laying in the plane"
/// (SbPlane::SbPlane), of any length: it "must not be a null vector".
struct Plane {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_disk& disk) {
    SbVec3f met;
    const SbPlane plane(vector(disk.normal), vector(disk.centre));
    return plane.intersect(line(ray), met) ? at(met) : rayaudit_miss();
  }
};

/// "return these in enter and exit. ... If the ray does not intersect ..., FALSE is returned"
/// (SbSphere::intersect, SbCylinder::intersect)
template <class Body>
rayaudit_answer entered(const Body& body, const rayaudit_ray& ray) {
  SbVec3f enter, exit;
  return body.intersect(line(ray), enter, exit) ? at(enter) : rayaudit_miss();
}

struct Sphere {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
    return entered(SbSphere(vector(sphere.centre), static_cast<float>(sphere.radius)), ray);
  }
};

/// "it is treated as of infinite length" (SbCylinder). Its axis goes through two points.
struct Cylinder {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cylinder& cylinder) {
    const SbLine axis(vector(cylinder.base), vector(cylinder.top));
    return entered(SbCylinder(axis, static_cast<float>(cylinder.radius)), ray);
  }
};

/// A distance along a ray; below 0, as the default is (SoRayPickAction.h), is none.
float distance(double t, const rayaudit_ray& ray) {
  const long double x = ray.direction.x, y = ray.direction.y, z = ray.direction.z;
  return std::isfinite(t) ? static_cast<float>(t * std::sqrt(x * x + y * y + z * z)) : -1;
}

/// The point that a ray picks in a scene, of "only the closest object" unless all are asked for
/// (SoRayPickAction::isPickAll), from near to far, which are distances.
rayaudit_answer picked(SoNode& scene, const rayaudit_ray& ray) {
  static SoRayPickAction action(SbViewportRegion(100, 100));
  action.setRay(vector(ray.origin), vector(ray.direction), distance(ray.t_min, ray),
                distance(ray.t_max, ray));
  action.apply(&scene);
  const SoPickedPoint* const point = action.getPickedPoint();
  return point == nullptr ? rayaudit_miss() : at(point->getPoint());
}

/// The nodes are those of a process, as long as it lives.
template <class Node>
Node& kept() {
  SoDB::init();
  auto* const node = new Node;
  node->ref();
  return *node;
}

struct PickedSphere {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
    static auto& scene = kept<SoSeparator>();
    static auto& place = kept<SoTranslation>();
    static auto& node = kept<SoSphere>();
    if (scene.getNumChildren() == 0) scene.addChild(&place), scene.addChild(&node);
    place.translation.setValue(vector(sphere.centre));
    node.radius.setValue(static_cast<float>(sphere.radius));
    return picked(scene, ray);
  }
};

/// About the y axis, "parts: the parts to use for the ... shape" (SoCylinder, SoCone).
template <int parts>
struct PickedCylinder {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cylinder& cylinder) {
    static auto& node = kept<SoCylinder>();
    node.parts.setValue(parts);
    node.radius.setValue(static_cast<float>(cylinder.radius));
    node.height.setValue(static_cast<float>(cylinder.top.y - cylinder.base.y));
    return picked(node, ray);
  }
};

template <int parts>
struct PickedCone {
  static rayaudit_answer hit(const rayaudit_ray& ray, const rayaudit_cone& cone) {
    static auto& node = kept<SoCone>();
    node.parts.setValue(parts);
    node.bottomRadius.setValue(static_cast<float>(cone.radius));
    node.height.setValue(static_cast<float>(cone.apex.y - cone.base.y));
    return picked(node, ray);
  }
};

/// The batch of what stands for a shape, which is a member of what a case is.
template <class Body, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = Body::hit(cases[i].ray, cases[i].is.*shape);
}

/// "for the given line" (SbSphere::intersect): both ways, though the text says ray beside it.
/// "If the ray just grazes the sphere, the enter and exit points have equal values" is no promise
/// that a ray that grazes is seen to do so once it is rounded: either is right.
constexpr rayaudit_convention lines() {
  rayaudit_convention made = {};
  made.line = 1;
  made.extent = RAYAUDIT_UNBOUNDED;
  return made;
}

/// The documentation tells nothing of a ray's ends, nor of touches: either is right.
constexpr rayaudit_convention rays() {
  rayaudit_convention made = {};
  made.stand = RAYAUDIT_UPRIGHT_Y;
  made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

using Shapes = decltype(rayaudit_case::is);
const rayaudit_subject subjects[] = {
    {.name = "coin",
     .format = "float",
     .convention = lines(),
     .disk = batch<Plane, &Shapes::disk>,
     .sphere = batch<Sphere, &Shapes::sphere>,
     .cylinder = batch<Cylinder, &Shapes::cylinder>,
     .cone = nullptr,
     .capped_cylinder = nullptr,
     .capped_cone = nullptr,
     .about = "Coin " COIN_VERSION ", SbPlane, SbSphere and SbCylinder"},
    {.name = "coin_pick",
     .format = "float",
     .convention = rays(),
     .disk = nullptr,
     .sphere = batch<PickedSphere, &Shapes::sphere>,
     .cylinder = batch<PickedCylinder<SoCylinder::SIDES>, &Shapes::cylinder>,
     .cone = batch<PickedCone<SoCone::SIDES>, &Shapes::cone>,
     .capped_cylinder = batch<PickedCylinder<SoCylinder::ALL>, &Shapes::capped_cylinder>,
     .capped_cone = batch<PickedCone<SoCone::ALL>, &Shapes::capped_cone>,
     .about = "Coin " COIN_VERSION ", SoRayPickAction"}};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
