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

/// -1, 0 or 1; x must not be NaN.
int sign(const Real& x);

/// The same value in normal form: high the rounded sum, parts that do not overlap.
Real normal(const Real& x);

/// The largest e with 2^e <= |x|; x finite and not 0.
int binade(const Real& x);

/// a - b, in normal form, to 2^-100 of the larger operand and exactly where it cancels to a few
/// leading bits; saturates to an infinity where the exponents of a and b differ by over 2,000.
Real difference(const Real& a, const Real& b);

/// The sign of a - b, as exact as difference.
int compare(const Real& a, const Real& b);

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
