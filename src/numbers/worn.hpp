#pragma once

#include <cmath>
#include <limits>

namespace rayaudit {

/// A number of N (float, double or long double) with a bound of its error, were every operation
/// that rounds `wear` times less exact than it is. What holds of it whatever the errors within
/// those bounds, holds of any routine of about the same formula.
template <class N>
struct Worn {
  static constexpr long double wear = 0x1p8L;

  N value = N(0);
  long double bound = 0;

  /// Was every comparison in this thread, since it was last set, the same for all numbers within
  /// the bounds?
  static inline constinit thread_local bool all_sure = true;

  Worn() = default;
  explicit Worn(int x) : value(N(x)) {}
  explicit Worn(const N& x) : value(x) {}
  Worn(const N& x, long double b) : value(x), bound(b) {}

  /// The number that an operation has made: what it brings along, and what it adds where it rounds.
  static Worn made(const N& x, long double brought, bool is_exact) {
    constexpr long double unit = std::numeric_limits<N>::epsilon() / 2;
    if (is_exact) return {x, brought};
    const long double size = std::fabs(static_cast<long double>(x));
    return {x, brought + wear * (unit * size + std::numeric_limits<N>::denorm_min())};
  }

  friend Worn operator-(const Worn& a) { return {-a.value, a.bound}; }
  friend Worn operator+(const Worn& a, const Worn& b) {
    const N x = a.value + b.value;
    const bool is_exact = x - a.value == b.value && x - b.value == a.value;
    return made(x, a.bound + b.bound, is_exact);
  }
  friend Worn operator-(const Worn& a, const Worn& b) { return a + -b; }
  friend Worn operator*(const Worn& a, const Worn& b) {
    const N x = a.value * b.value;
    const long double brought = moved(a) * b.bound + a.bound * size(b);
    return made(x, brought, is_product(x, a.value, b.value));
  }
  friend Worn operator/(const Worn& a, const Worn& b) {
    const N x = a.value / b.value;
    const long double least = size(b) - b.bound;
    const Worn quotient(x);
    const long double brought = (a.bound + size(quotient) * b.bound) / (least > 0 ? least : 0);
    return made(x, a.bound == 0 && b.bound == 0 ? 0 : brought, is_product(a.value, x, b.value));
  }
  friend Worn sqrt(const Worn& a) {
    using std::sqrt;
    const N x = sqrt(a.value);
    const long double least = size(a) - a.bound;
    // Towards 0 a root moves by as much as that of the bound itself.
    const long double brought =
        least > 0 ? a.bound / (size(Worn(x)) + std::sqrt(least)) : std::sqrt(size(a) + a.bound);
    return made(x, a.bound == 0 ? 0 : brought, is_product(a.value, x, x));
  }

  friend bool operator==(const Worn& a, const Worn& b) {
    return decided(a, b, a.value == b.value, a.bound == 0 && b.bound == 0);
  }
  friend bool operator<(const Worn& a, const Worn& b) {
    return decided(a, b, a.value < b.value, a.bound == 0 && b.bound == 0);
  }
  friend bool operator>(const Worn& a, const Worn& b) { return b < a; }
  /// Where both are the same, as on a rim, a routine says so or so.
  friend bool operator<=(const Worn& a, const Worn& b) {
    return decided(a, b, a.value <= b.value, false);
  }
  friend bool operator>=(const Worn& a, const Worn& b) { return b <= a; }

 private:
  static long double size(const Worn& a) { return std::fabs(static_cast<long double>(a.value)); }
  /// The largest that it may be.
  static long double moved(const Worn& a) { return size(a) + a.bound; }
  /// Is x just a b? Where that underflows it does not tell.
  static bool is_product(const N& x, const N& a, const N& b) {
    if (a == 0 || b == 0) return x == 0;
    return std::fma(a, b, -x) == 0 && std::fabs(x) > std::numeric_limits<N>::min() * N(1 << 24) &&
           std::isfinite(x);
  }
  static bool decided(const Worn& a, const Worn& b, bool said, bool are_exact) {
    const long double apart =
        std::fabs(static_cast<long double>(a.value) - static_cast<long double>(b.value));
    if (!are_exact && !(apart > a.bound + b.bound)) all_sure = false;
    return said;
  }
};

}  // namespace rayaudit
