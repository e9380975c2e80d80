#pragma once

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "rayaudit/case.h"

/// Cases and answers as plain C has them (rayaudit/case.h), and back.
namespace rayaudit {

/// The parts of a flat case, in any number.
template <class N>
Vec3<N> in(const rayaudit_vec3& v) {
  return {N(v.x), N(v.y), N(v.z)};
}
template <class N>
Ray<N> in(const rayaudit_ray& ray) {
  return {in<N>(ray.origin), in<N>(ray.direction), N(ray.t_min), N(ray.t_max)};
}
template <class N>
Disk<N> in(const rayaudit_disk& disk) {
  return {in<N>(disk.centre), in<N>(disk.normal), N(disk.radius)};
}
template <class N>
Sphere<N> in(const rayaudit_sphere& sphere) {
  return {in<N>(sphere.centre), N(sphere.radius)};
}
template <class N>
Cylinder<N> in(const rayaudit_cylinder& cylinder) {
  return {in<N>(cylinder.base), in<N>(cylinder.top), N(cylinder.radius)};
}
template <class N>
Cone<N> in(const rayaudit_cone& cone) {
  return {in<N>(cone.base), in<N>(cone.apex), N(cone.radius)};
}

rayaudit_case flat(const Case& question);
/// Its shape must be one of rayaudit_shape.
Case from_flat(const rayaudit_case& question);

/// A t or a point to two doubles.
rayaudit_answer flat(const Answer& answer);
/// What an answer says: `garbage` where its form is none of rayaudit_form.
Answer from_flat(const rayaudit_answer& answer);

}  // namespace rayaudit
