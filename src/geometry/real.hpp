#pragma once

#include <cmath>

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

int sign_of_three(const Real& x);
Real any_difference(const Real& a, const Real& b);

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
int binade(const Real& x);

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
  if (is_finite(a) && is_finite(b)) return sign(difference(a, b));
  return (a.high > b.high) - (a.high < b.high);
}

/// x as a number of N, to nearest (ties to even) of the value that x holds; overflows to an
/// infinity.
template <class N>
N nearest(const Real& x);

/// Exponent e of the spacing 2^e of the format at x: that of x's binade, never below the smallest
/// subnormal.
int spacing_exponent(const Real& x, const Format& format);

/// |got - exact| in ulps of the format at exact: a correctly rounded got has at most 0.5.
double ulps(const Real& got, const Real& exact, const Format& format);

/// |x| 2^-e as a double; saturates to infinity, and to 0 below the range of double.
double scaled(const Real& x, int e);

/// Does |x| round to infinity in the format?
bool overflows(const Real& x, const Format& format);

}  // namespace rayaudit
