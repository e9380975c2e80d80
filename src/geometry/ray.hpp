#pragma once

#include <limits>

#include "geometry/vec3.hpp"

namespace rayaudit {

/// The points origin + t direction with t_min < t < t_max, t in units of the direction as given,
/// whatever its length. The default range is the open half-line.
template <class N>
struct Ray {
  Vec3<N> origin, direction;
  N t_min = N(0);
  N t_max = N(std::numeric_limits<double>::infinity());

  friend bool operator==(const Ray&, const Ray&) = default;
};

template <class M, class N>
Ray<M> in(const Ray<N>& ray) {
  return {in<M>(ray.origin), in<M>(ray.direction), M(ray.t_min), M(ray.t_max)};
}

}  // namespace rayaudit
