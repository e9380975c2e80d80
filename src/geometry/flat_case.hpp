#pragma once

#include <type_traits>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"
#include "rayaudit/case.h"

/// Cases and answers as plain C has them (rayaudit/case.h), and back.
namespace rayaudit {

/// The parts of a flat ray, in any number.
template <class N>
Vec3<N> in(const rayaudit_vec3& v) {
  return {N(v.x), N(v.y), N(v.z)};
}
template <class N>
Ray<N> in(const rayaudit_ray& ray) {
  return {in<N>(ray.origin), in<N>(ray.direction), N(ray.t_min), N(ray.t_max)};
}

/// The parts of a flat case of a shape, in any number.
template <class N, template <class> class S>
S<N> part(const rayaudit_case& question) {
  const auto& is = question.is;
  if constexpr (std::is_same_v<S<N>, Disk<N>>)
    return {in<N>(is.disk.centre), in<N>(is.disk.normal), N(is.disk.radius)};
  else if constexpr (std::is_same_v<S<N>, Sphere<N>>)
    return {in<N>(is.sphere.centre), N(is.sphere.radius)};
  else if constexpr (std::is_same_v<S<N>, Cone<N>> || std::is_same_v<S<N>, CappedCone<N>>)
    return {in<N>(is.cone.base), in<N>(is.cone.apex), N(is.cone.radius)};
  else
    return {in<N>(is.cylinder.base), in<N>(is.cylinder.top), N(is.cylinder.radius)};
}

rayaudit_case flat(const Case& question);
/// Its shape must be one of rayaudit_shape.
Case from_flat(const rayaudit_case& question);

/// A t or a point to two doubles.
rayaudit_answer flat(const Answer& answer);
/// What an answer says: `garbage` where its form is none of rayaudit_form.
Answer from_flat(const rayaudit_answer& answer);

}  // namespace rayaudit
