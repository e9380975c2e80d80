#pragma once

#include "numbers/running_bound.hpp"

/// RunningBound<DoubleDouble>: running error analysis with the proved relative errors of
/// double-word arithmetic. Here off is always 0 and most is the bound, rounded upwards.
namespace rayaudit {

using WideBound = RunningBound<DoubleDouble>;

namespace running_bound {

/// More than the roundings of a bound that is computed in at most eight operations.
inline constexpr double upward = 1 + 0x1p-48;
/// More than all that underflows in one operation, but where it is divided.
inline constexpr double underflow = 0x1p-1060;

/// Does the compiler know that the number is exact, and a double?
[[gnu::always_inline]] inline bool is_known_double(const WideBound& a) {
  return is_known_exact(a) && __builtin_constant_p(a.value.low) && a.value.low == 0;
}

[[gnu::cold, gnu::noinline]] inline WideBound odd_wide_quotient(WideBound a, WideBound b,
                                                                DoubleDouble z) {
  if (!is_finite(a) || !is_some(b) || !(size(z) <= largest)) return unbounded(z);
  if (is_exact_zero(a)) return {z, 0, 0};
  // Both sides of a small divisor are brought up first: what is divided is tiny, and must not
  // itself underflow. What underflows on the way may be divided by the divisor.
  const double scale = size(b.value) < 1 ? 0x1p500 : 1;
  const double divisor = size(b.value) * scale * (1 - 0x1p-50) - b.most * scale;
  const double share =
      (b.most * scale + size(b.value) * scale * DoubleDouble::quotient_error) / divisor;
  const double lost = underflow + underflow * scale / divisor * (1 + share);
  return {z, 0, (a.most * scale / divisor + size(z) * share) * upward + lost};
}

}  // namespace running_bound

[[gnu::always_inline]] inline WideBound operator+(const WideBound& a, const WideBound& b) {
  using namespace running_bound;
  if (is_known_double(a) && is_known_double(b)) {
    const Unrounded<double> s = two_sum(a.value.high, b.value.high);
    if (s.low == s.low) [[likely]]
      return WideBound(DoubleDouble(s.high, s.low));
  }
  const DoubleDouble z = a.value + b.value;
  const double own = size(z) * DoubleDouble::sum_error;
  const double most = (a.most + b.most + own) * upward;
  if (is_ordinary(most)) [[likely]]
    return {z, 0, most};
  // In the sum of exact numbers that cancel nothing is lost; nor in that of small ones, but in
  // the bound.
  if (a.most == 0 && b.most == 0 && z.high == 0) return {z, 0, 0};
  return {z, 0, most + underflow};
}

[[gnu::always_inline]] inline WideBound operator-(const WideBound& a, const WideBound& b) {
  return a + -b;
}

[[gnu::always_inline]] inline WideBound operator*(const WideBound& a, const WideBound& b) {
  using namespace running_bound;
  const DoubleDouble z = a.value * b.value;
  const double own =
      is_known_double(a) && is_known_double(b) ? underflow : size(z) * DoubleDouble::product_error;
  const double most = (size(a.value) * b.most + (size(b.value) + b.most) * a.most + own) * upward;
  if (is_ordinary(most)) [[likely]]
    return {z, 0, most};
  return odd_product(a, b, z, 0, most);
}

/// The quotient; unbounded where b may be 0.
[[gnu::always_inline]] inline WideBound operator/(const WideBound& a, const WideBound& b) {
  using namespace running_bound;
  const DoubleDouble z = a.value / b.value;
  // a* / b* - z = (a* - z b*) / b*, and |a - z b| is at most |z| |b| times the share of z.
  const double divisor = size(b.value) * (1 - 0x1p-50) - b.most;
  const double inverse = 1 / divisor;
  const double most =
      (a.most * inverse +
       size(z) * ((b.most + size(b.value) * DoubleDouble::quotient_error) * inverse)) *
      upward;
  if (divisor >= 0x1p-20 && divisor < 0x1p900 && is_ordinary(most)) [[likely]]
    return {z, 0, most};
  return odd_wide_quotient(a, b, z);
}

/// The square root; unbounded where a may be below 0, or where its rest would underflow.
[[gnu::always_inline]] inline WideBound sqrt(const WideBound& a) {
  using namespace running_bound;
  const DoubleDouble z = sqrt(a.value);
  // |sqrt(x) - sqrt(a)| = |x - a| / (sqrt(x) + sqrt(a)), and sqrt(x) >= sqrt(a) (1 - most / a).
  const double least = size(a.value) * (1 - 0x1p-50) - a.most;
  const double most =
      size(z) * (a.most / (size(a.value) + least) + DoubleDouble::root_error) * upward;
  if (least > 0 && a.value.high >= 0x1p-900 && most <= largest) [[likely]]
    return {z, 0, most};
  return is_exact_zero(a) ? WideBound(z) : unbounded(z);
}

}  // namespace rayaudit
