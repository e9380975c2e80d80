#include "geometry/real.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

namespace rayaudit {

using real_detail::has_power;
using real_detail::is_simple;
using real_detail::power_of_two;
using real_detail::room;
using real_detail::two_sum;

namespace {

template <class W>
int sign_of(W x) {
  return (x > W(0)) - (x < W(0));
}

/// Leaves the exact sum of the parts as it is and makes them normal: parts[0] the sum rounded to
/// nearest, each part at most half an ulp of the one before, zeros last.
template <class W, std::size_t n>
void distil(std::array<W, n>& parts) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = n - 1; i-- > 0;) {
      const auto [value, rest] = two_sum(parts[i], parts[i + 1]);
      changed = changed || value != parts[i];
      parts[i] = value;
      parts[i + 1] = rest;
    }
  }
  // A tie between the first two went to even; the third part may break it the other way.
  const bool tie = (parts[0] + 2 * parts[1]) - parts[0] == 2 * parts[1];
  if (tie && sign_of(parts[1]) * sign_of(parts[2]) > 0) {
    parts[0] += 2 * parts[1];
    parts[1] = -parts[1];
  }
}

/// std::ilogb, at once where x is normal.
int exponent_of(double x) {
  const int biased = static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52 & 0x7ff);
  return biased != 0 && biased != 0x7ff ? biased - 1023 : std::ilogb(x);
}
int exponent_of(long double x) { return std::ilogb(x); }

/// The largest e with 2^e <= |head + tail|, where head is normal and the tail has the given sign.
template <class W>
int binade_of(W head, int tail) {
  if (tail == 0) return exponent_of(head);
  const int e = exponent_of(head);
  const bool below = tail * sign_of(head) < 0 && std::abs(head) == std::ldexp(W(1), e);
  return below ? e - 1 : e;
}

Real scaled_parts(const Real& x, int shift) {
  return {std::ldexp(x.high, shift), std::ldexp(x.middle, shift), std::ldexp(x.low, shift),
          x.exponent - shift};
}

/// Far from overflow and underflow, or 0.
bool is_modest(double x) { return x == 0 || (std::abs(x) < 0x1p1000 && std::abs(x) > 0x1p-900); }

/// The same value where no sum of parts can overflow.
Real roomy(const Real& x) {
  const double largest = std::max({std::abs(x.high), std::abs(x.middle), std::abs(x.low)});
  return largest < room ? x : scaled_parts(x, -64);
}

}  // namespace

Real normal(const Real& x) {
  // The common forms, already normal: one part, or a second that rounds away.
  if (x.low == 0 && (x.middle == 0 || x.high + x.middle == x.high)) return x;
  if (is_simple(x)) {
    const auto [value, rest] = two_sum(x.high, x.middle);
    return {value, rest, 0, x.exponent};
  }
  if (!is_finite(x)) return x;
  const Real roomier = roomy(x);
  std::array<double, 3> parts = {roomier.high, roomier.middle, roomier.low};
  distil(parts);
  return {parts[0], parts[1], parts[2], roomier.exponent};
}

int real_detail::sign_of_three(const Real& x) { return sign_of(normal(x).high); }

int real_detail::any_binade(const Real& x) {
  const Real n = normal(x);
  return binade_of(n.high, sign_of(n.middle)) + n.exponent;
}

Real real_detail::any_difference(const Real& a, const Real& b) {
  if (!is_finite(a) || !is_finite(b)) return real(a.high - b.high);
  const Real minus_b = {-b.high, -b.middle, -b.low, b.exponent};
  if (sign(a) == 0) return normal(minus_b);
  if (sign(b) == 0) return normal(a);
  Real from = roomy(normal(a)), less = roomy(normal(minus_b));
  if (from.exponent != less.exponent) {
    // Room above for the sum; below it 1,900 bits of both.
    const int exponent = std::max(binade(from), binade(less)) - 900;
    from = scaled_parts(from, from.exponent - exponent);
    less = scaled_parts(less, less.exponent - exponent);
  }
  std::array<double, 6> parts = {from.high,   less.high, from.middle,
                                 less.middle, from.low,  less.low};
  distil(parts);
  return {parts[0], parts[1], parts[2], from.exponent};
}

template <class N>
N nearest(const Real& x) {
  const Real n = normal(x);
  const bool plain = n.exponent == 0 && n.middle == 0;
  if (plain || !is_finite(n) || n.high == 0) return static_cast<N>(n.high);
  using Wide = std::conditional_t<std::is_same_v<N, long double>, long double, double>;
  std::array<Wide, 3> parts = {n.high, n.middle, n.low};
  distil(parts);
  // parts[0] is the value to nearest, so it lies on the side of every midpoint that the value does,
  // or on the midpoint; there the sign of the next part tells.
  const int tail = sign_of(parts[1]);
  const Format& format = format_of<N>;
  const int spacing = std::max(binade_of(parts[0], tail) + n.exponent - (format.precision - 1),
                               format.tiny_exponent());
  const Wide magnitude = std::ldexp(std::abs(parts[0]), n.exponent - spacing);
  Wide whole = std::floor(magnitude);
  const int past_half = sign_of(magnitude - whole - Wide(0.5));
  const int outward = past_half != 0 ? past_half : tail * sign_of(parts[0]);
  const bool odd = std::fmod(whole, Wide(2)) != 0;
  if (outward > 0 || (outward == 0 && odd)) whole += 1;
  return std::copysign(std::ldexp(static_cast<N>(whole), spacing), static_cast<N>(sign_of(n.high)));
}
template float nearest<float>(const Real&);
template double nearest<double>(const Real&);
template long double nearest<long double>(const Real&);

double ulps(const Real& got, const Real& exact, const Format& format) {
  if (is_infinite(got) && overflows(exact, format) && sign(got) == sign(exact)) return 0;
  return scaled(difference(got, exact), spacing_exponent(exact, format));
}

double real_detail::any_scaled(const Real& x, int e) {
  const Real n = normal(x);
  const int shift = n.exponent - e;
  const double quick = has_power(shift) ? std::abs(n.high) * power_of_two(shift)
                                        : std::ldexp(std::abs(n.high), shift);
  if (is_modest(quick) && quick != 0) return quick;
  return std::abs(nearest<double>({x.high, x.middle, x.low, x.exponent - e}));
}

bool overflows(const Real& x, const Format& format) {
  if (!is_finite(x)) return is_infinite(x);
  if (sign(x) == 0 || binade(x) < format.max_exponent) return false;
  // The midpoint between the largest number and 2^(max_exponent + 1) goes to even: infinity.
  const Real midpoint = {1, -std::ldexp(1.0, -(format.precision + 1)), 0, format.max_exponent + 1};
  const Real magnitude = sign(x) < 0 ? difference({}, x) : x;
  return compare(magnitude, midpoint) >= 0;
}

}  // namespace rayaudit
