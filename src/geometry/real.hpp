#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "geometry/format.hpp"

namespace rayaudit {

/// A real number as (high + middle + low) 2^exponent: holds any value of float, double, long
/// double,
/// __float128 and double-double exactly, and t beyond the range of double. Not unique; where a
/// function says normal, the parts do not overlap and high is the sum rounded to nearest.
struct Real {
  double high = 0, middle = 0, low = 0;
  int exponent = 0;

  friend bool operator==(const Real&, const Real&) = default;
};

/// Exactly the number x; an infinity or a NaN stays one.
template <class N>
Real real(N x) {
  const double high = static_cast<double>(x);
  if (std::isfinite(high) && (high != 0 || x == N(0))) {
    const N rest = x - static_cast<N>(high);
    const double middle = static_cast<double>(rest);
    if (static_cast<N>(middle) == rest) return {high, middle, 0, 0};
  }
  if (!std::isfinite(x)) return {high, 0, 0, 0};
  // A long double outside the range of double: its exponent is taken out first.
  int exponent = 0;
  const N fraction = std::frexp(x, &exponent);
  const double leading = static_cast<double>(fraction);
  return {leading, static_cast<double>(fraction - static_cast<N>(leading)), 0, exponent};
}
inline Real real(float x) { return {x, 0, 0, 0}; }
inline Real real(double x) { return {x, 0, 0, 0}; }

inline bool is_nan(const Real& x) { return std::isnan(x.high); }
inline bool is_infinite(const Real& x) { return std::isinf(x.high); }
inline bool is_finite(const Real& x) { return std::isfinite(x.high); }

/// What the functions below do at once for numbers of two parts, and at length for others.
namespace real_detail {

template <class W>
struct Sum {
  W value, rest;
};

/// a + b = value + rest exactly, value rounded to nearest: Knuth, The Art of Computer Programming
/// 2, section 4.2.2, theorem B.
template <class W>
Sum<W> two_sum(W a, W b) {
  const W value = a + b;
  const W of_b = value - a;
  return {value, (a - (value - of_b)) + (b - of_b)};
}

inline constexpr double room = 0x1p1016;  ///< sums of a few numbers below it do not overflow

/// Has it two parts at most, far from overflow? Then a sum of two such numbers is soon told.
inline bool is_simple(const Real& x) {
  return x.low == 0 && std::abs(x.high) < room && std::abs(x.middle) < room;
}

/// 2^e, for the exponents of normal numbers.
inline double power_of_two(int e) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(e + 1023) << 52);
}
inline bool has_power(int e) { return e >= -1022 && e <= 1023; }

/// Is high all that a double can say of it?
inline bool is_led(const Real& x) { return x.low == 0 && x.high + x.middle == x.high; }

int sign_of_three(const Real& x);
Real any_difference(const Real& a, const Real& b);
int any_binade(const Real& x);
double any_scaled(const Real& x, int e);

}  // namespace real_detail

/// -1, 0 or 1; x must not be NaN.
inline int sign(const Real& x) {
  if (x.low != 0) return real_detail::sign_of_three(x);
  const double sum = x.high + x.middle;  // of two doubles it does not round to 0 unless it is
  const double least = x.middle == 0 ? x.high : sum;
  return (least > 0) - (least < 0);
}

/// The same value in normal form: high the rounded sum, parts that do not overlap.
Real normal(const Real& x);

/// The largest e with 2^e <= |x|; x finite and not 0.
inline int binade(const Real& x) {
  const auto bits = std::bit_cast<std::uint64_t>(x.high);
  const int biased = static_cast<int>(bits >> 52 & 0x7ff);
  const bool is_power = (bits & 0xf'ffff'ffff'ffff) == 0;  // the middle may lie below it
  if (biased == 0 || is_power || !real_detail::is_led(x)) return real_detail::any_binade(x);
  return biased - 1023 + x.exponent;
}

/// a - b, in normal form, to 2^-100 of the larger operand and exactly where it cancels to a few
/// leading bits; saturates to an infinity where the exponents of a and b differ by over 2,000.
inline Real difference(const Real& a, const Real& b) {
  using real_detail::two_sum;
  if (a.exponent == b.exponent && real_detail::is_simple(a) && real_detail::is_simple(b)) {
    const auto [high, rest] = two_sum(a.high, -b.high);
    const auto [middle, lost] = two_sum(a.middle, -b.middle);
    const auto [small, smaller] = two_sum(rest, middle);
    const auto [value, tail] = two_sum(high, small);
    if (lost == 0 && smaller == 0) return {value, tail, 0, a.exponent};
  }
  return real_detail::any_difference(a, b);
}

/// The sign of a - b, as exact as difference.
inline int compare(const Real& a, const Real& b) {
  const bool are_doubles = a.middle == 0 && b.middle == 0 && a.low == 0 && b.low == 0;
  if (is_finite(a) && is_finite(b) && !(are_doubles && a.exponent == b.exponent))
    return sign(difference(a, b));
  return (a.high > b.high) - (a.high < b.high);
}

/// x as a number of N, to nearest (ties to even) of the value that x holds; overflows to an
/// infinity.
template <class N>
N nearest(const Real& x);

/// Exponent e of the spacing 2^e of the format at x: that of x's binade, never below the smallest
/// subnormal.
inline int spacing_exponent(const Real& x, const Format& format) {
  if (sign(x) == 0) return format.tiny_exponent();
  return std::max(binade(x) - (format.precision - 1), format.tiny_exponent());
}

/// |got - exact| in ulps of the format at exact: a correctly rounded got has at most 0.5.
double ulps(const Real& got, const Real& exact, const Format& format);

/// |x| 2^-e as a double; saturates to infinity, and to 0 below the range of double.
inline double scaled(const Real& x, int e) {
  const int shift = x.exponent - e;
  if (real_detail::is_led(x) && real_detail::has_power(shift)) {
    const double quick = std::abs(x.high) * real_detail::power_of_two(shift);
    if (quick < 0x1p1000 && quick > 0x1p-900) return quick;
  }
  return real_detail::any_scaled(x, e);
}

/// Does |x| round to infinity in the format?
bool overflows(const Real& x, const Format& format);

}  // namespace rayaudit
