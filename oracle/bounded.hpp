#pragma once

#include <cmath>
#include <limits>

#include "geometry/real.hpp"
#include "oracle/polynomial.hpp"

namespace rayaudit::oracle {

/// A double-word number with a rigorous bound of its distance from the exact value: the exact value
/// lies within error of high + low. Never decides a sign that the bound leaves open; an overflow
/// ends in an error that is infinite or NaN, which no comparison accepts.
///
/// The relative errors of the operations are those proved by Joldes, Muller and Popescu, "Tight and
/// rigorous error bounds for basic building blocks of double-word arithmetic", ACM TOMS 44(2), 2017
/// (algorithms 6, 12 and 17: sum 3u^2, product 5u^2, quotient 15u^2, plus higher terms; ours
/// multiplies in the quotient by algorithm 9, 2u^2 more), and by Lefevre, Louvet, Muller, Picot and
/// Rideau, "Accurate calculation of Euclidean norms using double-word arithmetic", ACM TOMS 49(1),
/// 2023 (root 25/8 u^2), u = 2^-53. Rounding must be to nearest.
struct Bounded {
  double high = 0, low = 0, error = 0;

  Bounded() = default;
  explicit Bounded(double x) : high(x) {}
  Bounded(double h, double l, double e) : high(h), low(l), error(e) {}
};

namespace double_word {
inline constexpr double sum_error = 0x1.9p-105;       // 3.125 u^2
inline constexpr double product_error = 0x1.5p-104;   // 5.25 u^2
inline constexpr double quotient_error = 0x1.2p-102;  // 18 u^2
inline constexpr double root_error = 0x1.ap-105;      // 3.25 u^2
/// More than all that products lose to underflow: the low word of a product and the bound itself.
inline constexpr double underflow = 0x1p-1068;
/// More than the roundings of a bound that is itself computed in at most eight operations.
inline constexpr double upward = 1 + 0x1p-48;

[[gnu::always_inline]] inline Bounded two_sum(double a, double b) {
  const double s = a + b;
  const double t = s - a;
  return {s, (a - (s - t)) + (b - t), 0};
}
/// Does the compiler know, once all is inlined, that x is 0? So it is for the low word and the
/// error of a number of the case, which spares most of the work.
[[gnu::always_inline]] inline bool is_known_zero(double x) {
  return __builtin_constant_p(x) && x == 0;
}
/// 0, or NaN where the low word tells that the high one overflowed.
[[gnu::always_inline]] inline double nan_if_overflown(double low) { return low * 0; }
/// a + b exactly, where |a| >= |b| or a = 0.
[[gnu::always_inline]] inline Bounded fast_two_sum(double a, double b) {
  const double s = a + b;
  return {s, b - (s - a), 0};
}
}  // namespace double_word

[[gnu::always_inline]] inline Bounded operator-(const Bounded& a) {
  return {-a.high, -a.low, a.error};
}

[[gnu::always_inline]] inline Bounded operator+(const Bounded& a, const Bounded& b) {
  const Bounded s = double_word::two_sum(a.high, b.high);
  if (double_word::is_known_zero(a.low) && double_word::is_known_zero(b.low) &&
      double_word::is_known_zero(a.error) && double_word::is_known_zero(b.error))
    return {s.high, s.low, double_word::nan_if_overflown(s.low)};
  const Bounded t = double_word::two_sum(a.low, b.low);
  const Bounded v = double_word::fast_two_sum(s.high, s.low + t.high);
  const Bounded z = double_word::fast_two_sum(v.high, t.low + v.low);
  return {z.high, z.low,
          (a.error + b.error + std::fabs(z.high) * double_word::sum_error) * double_word::upward};
}

[[gnu::always_inline]] inline Bounded operator-(const Bounded& a, const Bounded& b) {
  return a + -b;
}

[[gnu::always_inline]] inline Bounded operator*(const Bounded& a, const Bounded& b) {
  const double high = a.high * b.high;
  const double low = __builtin_fma(a.high, b.high, -high);
  if (double_word::is_known_zero(a.low) && double_word::is_known_zero(b.low) &&
      double_word::is_known_zero(a.error) && double_word::is_known_zero(b.error))
    return {high, low, double_word::underflow + double_word::nan_if_overflown(low)};
  const double mixed = __builtin_fma(a.high, b.low, __builtin_fma(a.low, b.high, a.low * b.low));
  const Bounded z = double_word::fast_two_sum(high, low + mixed);
  const double error = std::fabs(a.high) * b.error + std::fabs(b.high) * a.error +
                       a.error * b.error + std::fabs(z.high) * double_word::product_error;
  return {z.high, z.low, error * double_word::upward + double_word::underflow};
}

/// The quotient; an infinite error where b may be 0.
[[gnu::always_inline]] inline Bounded operator/(const Bounded& a, const Bounded& b) {
  const double high = a.high / b.high;
  const double product = b.high * high;
  const double product_low = __builtin_fma(b.low, high, __builtin_fma(b.high, high, -product));
  const Bounded r = double_word::fast_two_sum(product, product_low);
  const double rest = (a.high - r.high) + (a.low - r.low);
  const Bounded z = double_word::fast_two_sum(high, rest / b.high);
  const double divisor = std::fabs(b.high) * (1 - 0x1p-50) - b.error;
  const double error = (a.error + std::fabs(z.high) * b.error) / divisor +
                       std::fabs(z.high) * double_word::quotient_error;
  return {z.high, z.low,
          divisor > 0
              ? error * double_word::upward + double_word::underflow / (divisor < 1 ? divisor : 1)
              : std::numeric_limits<double>::infinity()};
}

/// The square root; an infinite error where a may be 0 or less, or so small that its rest
/// underflows.
[[gnu::always_inline]] inline Bounded sqrt(const Bounded& a) {
  const double high = std::sqrt(a.high);
  const double rest = __builtin_fma(-high, high, a.high) + a.low;
  const Bounded z = double_word::fast_two_sum(high, rest / (high + high));
  // |sqrt(x) - sqrt(y)| <= |x - y| / sqrt(y); the root is a little more than z (1 - 2^-50).
  const double error = a.error / (z.high * (1 - 0x1p-50)) + z.high * double_word::root_error;
  return {z.high, z.low,
          a.high > 2 * a.error && a.high > 0x1p-900
              ? error * double_word::upward + double_word::underflow
              : std::numeric_limits<double>::infinity()};
}

using real_detail::power_of_two;

/// 2 a, without a rounding.
[[gnu::always_inline]] inline Bounded twice(const Bounded& a) {
  return {2 * a.high, 2 * a.low, 2 * a.error};
}

/// -1 or 1 where the bound proves the sign, else 0.
[[gnu::always_inline]] inline int proved_sign(const Bounded& a) {
  const double least = std::fabs(a.high) * (1 - 0x1p-50);
  return least > a.error ? (a.high > 0 ? 1 : -1) : 0;
}

/// Is the value proved to within relative times itself? False for 0 with any error at all.
[[gnu::always_inline]] inline bool known_to(const Bounded& a, double relative) {
  return a.error <= std::fabs(a.high) * relative * (1 - 0x1p-40);
}

}  // namespace rayaudit::oracle
