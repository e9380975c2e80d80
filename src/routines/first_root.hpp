#pragma once

#include <optional>

#include "geometry/ray.hpp"

namespace rayaudit {

/// The roots of a quadratic in any order; twice the same where there is but one.
template <class N>
struct Roots {
  N one, other;
};

/// Is t inside the open range of the ray?
template <class N>
bool in_range(const Ray<N>& ray, const N& t) {
  return ray.t_min < t && t < ray.t_max;
}

/// The smaller root for which a condition holds.
template <class N, class Condition>
std::optional<N> first_root(const Roots<N>& roots, const Condition& holds) {
  const bool in_order = roots.one < roots.other;
  const N& near = in_order ? roots.one : roots.other;
  const N& far = in_order ? roots.other : roots.one;
  if (holds(near)) return near;
  if (holds(far)) return far;
  return {};
}

/// The smaller root in the range of the ray for which the side conditions hold.
template <class N, class Condition>
std::optional<N> first_root(const Ray<N>& ray, const Roots<N>& roots, const Condition& holds) {
  return first_root(roots, [&](const N& t) { return in_range(ray, t) && holds(t); });
}

template <class N>
std::optional<N> first_root(const Ray<N>& ray, const Roots<N>& roots) {
  return first_root(roots, [&](const N& t) { return in_range(ray, t); });
}

}  // namespace rayaudit
