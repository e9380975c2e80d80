#pragma once

#include <cmath>
#include <optional>

#include "routines/first_root.hpp"

namespace rayaudit {

/// a t^2 + b t + c and its discriminant, which is told apart from the coefficients.
template <class N>
struct Quadratic {
  N a, b, c, discriminant;
};

/// The roots of a t^2 + b t + c without cancellation: q = -(b + sign(b) sqrt(D)) / 2, then q/a and
/// c/q (Press, Teukolsky, Vetterling & Flannery, "Numerical Recipes", sec. 5.6), with sign(0) = 1.
/// Where a = 0 or q = 0 the root that would be divided by it is left out.
///
/// Among our shapes only the cone has a < 0, and every line so steep meets it: a discriminant below
/// 0 is rounding there, and taken for 0.
template <class N>
std::optional<Roots<N>> stable_roots(const N& a, const N& b, const N& c, const N& discriminant) {
  using std::sqrt;
  if (discriminant < N(0) && a >= N(0)) return {};
  const N root = discriminant < N(0) ? N(0) : sqrt(discriminant);
  const N q = -(b < N(0) ? b - root : b + root) / N(2);
  if (a == N(0) && q == N(0)) return {};
  if (a == N(0)) return Roots<N>{c / q, c / q};
  if (q == N(0)) return Roots<N>{q / a, q / a};
  return Roots<N>{q / a, c / q};
}

template <class N>
std::optional<Roots<N>> stable_roots(const Quadratic<N>& of) {
  return stable_roots(of.a, of.b, of.c, of.discriminant);
}

}  // namespace rayaudit
