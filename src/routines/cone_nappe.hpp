#pragma once

#include <optional>

#include "routines/first_root.hpp"

namespace rayaudit {

/// How far the points of a ray lie below the apex of a cone: from + t slope, and full at the base.
template <class N>
struct Depth {
  N from, slope, full;
};

/// The first root between the apex and the base for which a condition holds, of the cone's
/// quadratic with leading coefficient a.
///
/// Where a < 0 the line is steeper than the cone and meets each nappe once: the slope alone tells
/// which root is ours. The sign of its depth, which rounding takes away near the apex, need not be
/// asked, only its size. Elsewhere both roots lie on the same nappe.
template <class N, class Condition>
std::optional<N> first_on_nappe(const N& a, const Roots<N>& roots, const Depth<N>& depth,
                                const Condition& holds) {
  const bool steep = a < N(0);
  const N least = steep ? -depth.full : N(0);
  const auto on_nappe = [&](const N& t) {
    const N at_t = depth.from + t * depth.slope;
    return least <= at_t && at_t <= depth.full && holds(t);
  };
  if (!steep) return first_root(roots, on_nappe);
  const bool smaller = depth.slope < N(0);
  const N& t = (roots.one < roots.other) == smaller ? roots.one : roots.other;
  if (!on_nappe(t)) return {};
  return t;
}

}  // namespace rayaudit
