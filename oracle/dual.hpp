#pragma once

#include <array>

#include "oracle/bounded.hpp"

namespace rayaudit::oracle {

/// The number that the derivatives beside a value of V are held in.
template <class V>
struct SlopeOf {
  using type = V;
};
template <>
struct SlopeOf<Bounded> {
  using type = double;
};

/// A value and its derivatives by n variables (forward differentiation). Derivatives of double-word
/// values are doubles, taken from values in which nothing was lost to cancellation.
template <class V, std::size_t n>
struct Dual {
  using Slope = typename SlopeOf<V>::type;

  V value = V(0);
  std::array<Slope, n> by = {};

  Dual() = default;
  explicit Dual(const V& constant) : value(constant) {}
  Dual(const V& v, std::size_t variable) : value(v) { by[variable] = Slope(1); }
};

[[gnu::always_inline]] inline double leading(const Bounded& x) { return x.high; }
template <class V>
[[gnu::always_inline]] inline const V& leading(const V& x) {
  return x;
}

template <class V, std::size_t n>
[[gnu::always_inline]] inline Dual<V, n> operator+(const Dual<V, n>& a, const Dual<V, n>& b) {
  Dual<V, n> sum(a.value + b.value);
  for (std::size_t i = 0; i < n; ++i) sum.by[i] = a.by[i] + b.by[i];
  return sum;
}

template <class V, std::size_t n>
[[gnu::always_inline]] inline Dual<V, n> operator-(const Dual<V, n>& a) {
  Dual<V, n> negative(-a.value);
  for (std::size_t i = 0; i < n; ++i) negative.by[i] = -a.by[i];
  return negative;
}

template <class V, std::size_t n>
[[gnu::always_inline]] inline Dual<V, n> operator-(const Dual<V, n>& a, const Dual<V, n>& b) {
  Dual<V, n> difference(a.value - b.value);
  for (std::size_t i = 0; i < n; ++i) difference.by[i] = a.by[i] - b.by[i];
  return difference;
}

template <class V, std::size_t n>
[[gnu::always_inline]] inline Dual<V, n> operator*(const Dual<V, n>& a, const Dual<V, n>& b) {
  Dual<V, n> product(a.value * b.value);
  for (std::size_t i = 0; i < n; ++i)
    product.by[i] = leading(a.value) * b.by[i] + leading(b.value) * a.by[i];
  return product;
}

}  // namespace rayaudit::oracle
