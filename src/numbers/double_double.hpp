#pragma once

#include <cmath>

#include "geometry/error_free.hpp"
#include "geometry/real.hpp"

namespace rayaudit {

/// The unevaluated sum of two doubles, high the sum rounded to nearest: about 106 bits, in the
/// range of double. An infinity, also of an overflow, is one in high and 0 in low.
///
/// Sum, product and quotient are algorithms 6, 10 and 17 of Joldes, Muller and Popescu, "Tight and
/// rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017
/// (the quotient with algorithm 8 in it), the root is that of Lefevre, Louvet, Muller, Picot and
/// Rideau, "Accurate calculation of Euclidean norms using double-word arithmetic", ACM TOMS 49(1),
/// 2023.
struct DoubleDouble {
  double high = 0, low = 0;

  /// Relative errors: what is proved (3, 7, 15 + 3 and 25/8 u^2, u = 2^-53, plus higher terms),
  /// rounded up. A product, a quotient or a root also loses up to `underflow`.
  static constexpr double sum_error = 0x1.9p-105;
  static constexpr double product_error = 0x1.dp-104;
  static constexpr double quotient_error = 0x1.3p-102;
  static constexpr double root_error = 0x1.ap-105;
  static constexpr double underflow = 0x1p-1068;

  DoubleDouble() = default;
  explicit DoubleDouble(int x) : high(x) {}
  explicit DoubleDouble(double x) : high(x) {}
  /// Nothing of low may overlap high.
  DoubleDouble(double h, double l) : high(h), low(l) {}

  explicit operator double() const { return high; }

  friend bool operator==(const DoubleDouble&, const DoubleDouble&) = default;
};

namespace double_double {
/// high + low as a number; where they are NaN, what plain doubles make of the operation.
[[gnu::always_inline]] inline DoubleDouble number(double high, double low, double plain) {
  const Unrounded<double> z = fast_two_sum(high, low);
  if (z.high != z.high) [[unlikely]]
    return DoubleDouble(plain);
  return {z.high, z.low};
}
}  // namespace double_double

[[gnu::always_inline]] inline DoubleDouble operator-(const DoubleDouble& a) {
  return {-a.high, -a.low};
}

[[gnu::always_inline]] inline DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
  const Unrounded<double> s = two_sum(a.high, b.high);
  const Unrounded<double> t = two_sum(a.low, b.low);
  const Unrounded<double> v = fast_two_sum(s.high, s.low + t.high);
  return double_double::number(v.high, t.low + v.low, s.high);
}

[[gnu::always_inline]] inline DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
  return a + -b;
}

[[gnu::always_inline]] inline DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
  const Unrounded<double> p = two_product(a.high, b.high);
  return double_double::number(p.high, p.low + (a.high * b.low + a.low * b.high), p.high);
}

[[gnu::always_inline]] inline DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
  const double high = a.high / b.high;
  const Unrounded<double> p = two_product(b.high, high);
  const Unrounded<double> r = fast_two_sum(p.high, p.low + b.low * high);
  const double rest = (a.high - r.high) + (a.low - r.low);
  return double_double::number(high, rest / b.high, high);
}

[[gnu::always_inline]] inline DoubleDouble sqrt(const DoubleDouble& a) {
  const double high = std::sqrt(a.high);
  const double rest = __builtin_fma(-high, high, a.high) + a.low;
  return double_double::number(high, rest / (high + high), high);
}

inline bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low < b.low);
}
inline bool operator<=(const DoubleDouble& a, const DoubleDouble& b) {
  return a.high < b.high || (a.high == b.high && a.low <= b.low);
}
inline bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
inline bool operator>=(const DoubleDouble& a, const DoubleDouble& b) { return b <= a; }

template <>
inline constexpr Format format_of<DoubleDouble> = double_double_format;

inline Real real(const DoubleDouble& x) { return {x.high, x.low, 0, 0}; }

}  // namespace rayaudit
