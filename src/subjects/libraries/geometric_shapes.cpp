#include <geometric_shapes/bodies.h>

#include <limits>

#include "rayaudit/plugin.h"

/// ROS's geometric_shapes as a plugin: Body::intersectsRay of a sphere and of a cylinder, which has
/// its caps. (There is no body for its cone.) What is relied on is quoted from the comments of
/// geometric_shapes/bodies.h and shapes.h.
namespace {

Eigen::Vector3d vector(const rayaudit_vec3& of) { return {of.x, of.y, of.z}; }

/// "find the set of intersections, in order, along the ray [...] If that number is 0, all
/// intersections are returned": the first is told.
rayaudit_answer hit(const rayaudit_ray& ray, const bodies::Body& body) {
  EigenSTL::vector_Vector3d points;
  if (!body.intersectsRay(vector(ray.origin), vector(ray.direction), &points, 0))
    return rayaudit_miss();
  if (points.empty()) return rayaudit_yes();
  return rayaudit_at(points[0].x(), points[0].y(), points[0].z());
}

/// "Set the pose of the body. Default is identity"
void spheres(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [centre, radius] = cases[i].is.sphere;
    const shapes::Sphere shape(radius);
    bodies::Sphere body(&shape);
    body.setPose(Eigen::Isometry3d(Eigen::Translation3d(vector(centre))));
    answers[i] = hit(cases[i].ray, body);
  }
}

/// "Length is along z axis. Origin is at center of mass."
void cylinders(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [base, top, radius] = cases[i].is.capped_cylinder;
    const shapes::Cylinder shape(radius, top.z - base.z);
    answers[i] = hit(cases[i].ray, bodies::Cylinder(&shape));
  }
}

/// "Passing dir as a unit vector will result in faster computation": it may be of any length. Of a
/// ray that begins inside, and of touches, nothing is said.
constexpr rayaudit_convention declared() {
  rayaudit_convention made = {};
  made.stand = RAYAUDIT_UPRIGHT_Z;
  // Whatever the case has: its range begins at 0 and has no end.
  made.line = 1, made.t_min = 0, made.t_max = std::numeric_limits<double>::infinity();
  return made;
}

const rayaudit_subject subjects[] = {
    {.name = "geometric_shapes",
     .format = "double",
     .convention = declared(),
     .disk = nullptr,
     .sphere = spheres,
     .cylinder = nullptr,
     .cone = nullptr,
     .capped_cylinder = cylinders,
     .capped_cone = nullptr,
     .about = "geometric_shapes " GEOMETRIC_SHAPES_VERSION ", Body::intersectsRay"}};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
