#pragma once

#include <cmath>
#include <optional>

#include "routines/first_root.hpp"

namespace rayaudit {

/// The roots (-b +- sqrt(b^2 - 4ac)) / 2a of a t^2 + b t + c, as at school; of b t + c where a = 0.
template <class N>
std::optional<Roots<N>> quadratic_formula(const N& a, const N& b, const N& c) {
  using std::sqrt;
  if (a == N(0)) {
    if (b == N(0)) return {};
    const N t = -c / b;
    return Roots<N>{t, t};
  }
  const N discriminant = b * b - N(4) * a * c;
  if (discriminant < N(0)) return {};
  const N root = sqrt(discriminant);
  return Roots<N>{(-b - root) / (N(2) * a), (-b + root) / (N(2) * a)};
}

}  // namespace rayaudit
