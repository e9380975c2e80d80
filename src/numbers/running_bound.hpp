#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <limits>
#include <type_traits>

#include "geometry/error_free.hpp"
#include "numbers/double_double.hpp"

namespace rayaudit {

/// A number of N that goes through a routine as N does, bit for bit, with a rigorous running bound
/// of its rounding error: in real numbers the same operations, taken the same way at every
/// comparison, give a number within error() of value. N is float, double or long double; in
/// DoubleDouble see wide_bound.hpp. Rounding must be to nearest.
///
/// The bounds of sums, products, quotients and roots are those of running error analysis (Higham,
/// "Accuracy and Stability of Numerical Algorithms", 2nd ed., sec. 3.3), but for what an operation
/// adds of its own: not the most that the standard model allows, but what it is, which an
/// error-free transformation tells; and it is carried on with its sign (Langlois, "Automatic Linear
/// Correction of Rounding Errors", BIT 41, 2001). The standard model (ibid., sec. 2.2) bounds only
/// what is lost in that: at most a few units of 2^-53 of `most` an operation, and 2^-36 of it in
/// 10,000 operations, 50 of them roots, each upon the one before.
///
/// A comparison answers as the values do; where that is not proved to be the exact answer it
/// clears all_proved. A bound that is infinite or NaN proves nothing; only a number that was given
/// as an infinity is exactly one.
template <class N>
struct RunningBound {
  N value = N(0);
  double off = 0;   ///< nearly what the exact number has above value
  double most = 0;  ///< at least |off| and |exact - value|; 0 only where value is exact

  /// Was every comparison in this thread, since it was last set, proved? See ProofWatch.
  static inline constinit thread_local bool all_proved = true;
  /// The share of most by which off may be wrong; a double-double has no off.
  static constexpr double share = std::same_as<N, DoubleDouble> ? 1 : 0x1p-36;

  RunningBound() = default;
  explicit RunningBound(int x) : value(N(x)) {}
  /// A number of N is exact.
  explicit RunningBound(const N& x) : value(x) {}
  RunningBound(const N& v, double o, double m) : value(v), off(o), most(m) {}
  /// A double is as far from its float as rounding takes it.
  explicit RunningBound(double x) requires(!std::same_as<N, double>) : value(N(x)) {
    if constexpr (std::same_as<N, float>)
      if (x != value) off = x - value, most = std::fabs(off);
  }

  /// How far value + off may be from the exact number.
  double slack() const { return most * share; }
  double error() const { return (std::fabs(off) + slack()) * (1 + 0x1p-50); }
  bool is_bounded() const { return most <= std::numeric_limits<double>::max(); }
};

/// Watches the comparisons made in RunningBound<N> in this thread from its making on; one at a
/// time.
template <class N>
struct ProofWatch {
  ProofWatch() { RunningBound<N>::all_proved = true; }
  bool all_proved() const { return RunningBound<N>::all_proved; }
};

namespace running_bound {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr double largest = std::numeric_limits<double>::max();
/// Beside a bound at least so large all that underflows is nothing; a smaller one is raised by it.
inline constexpr double smallest = 0x1p-990;

/// x rounded to a double, and its size.
template <class N>
[[gnu::always_inline]] inline double rounded(const N& x) {
  return static_cast<double>(x);
}
template <class N>
[[gnu::always_inline]] inline double size(const N& x) {
  return std::fabs(rounded(x));
}

/// Does the compiler know, once all is inlined, that the number is exact? So it is for the numbers
/// of a case, which spares most of the work.
template <class N>
[[gnu::always_inline]] inline bool is_known_exact(const RunningBound<N>& a) {
  return __builtin_constant_p(a.most) && a.most == 0;
}

/// A long double that is no double is not infinite.
template <class N>
bool is_infinite(const N& x) {
  return std::isinf(x);
}
inline bool is_infinite(const DoubleDouble& x) { return std::isinf(x.high); }

template <class N>
bool is_exact_zero(const RunningBound<N>& a) {
  return a.most == 0 && a.value == N(0);
}
template <class N>
bool is_exact_infinity(const RunningBound<N>& a) {
  return a.most == 0 && is_infinite(a.value);
}
template <class N>
bool is_finite(const RunningBound<N>& a) {
  return a.is_bounded() && size(a.value) <= largest;
}
/// Is it proved not to be 0?
template <class N>
bool is_some(const RunningBound<N>& a) {
  return a.is_bounded() && size(a.value) * (1 - 0x1p-30) > a.most;
}
/// Is the bound neither so small that underflow matters, nor infinite, nor NaN?
[[gnu::always_inline]] inline bool is_ordinary(double most) {
  constexpr auto least = std::bit_cast<std::uint64_t>(smallest);
  return std::bit_cast<std::uint64_t>(most) - least <=
         std::bit_cast<std::uint64_t>(largest) - least;
}

/// What rounding z took from a b.
[[gnu::always_inline]] inline double lost_in_product(float a, float b, float z) {
  return static_cast<double>(a) * static_cast<double>(b) - static_cast<double>(z);
}
[[gnu::always_inline]] inline double lost_in_product(double a, double b, double z) {
  return __builtin_fma(a, b, -z);
}
[[gnu::always_inline]] inline double lost_in_product(long double a, long double b, long double) {
  return static_cast<double>(two_product(a, b).low);
}

/// a - b z, where z is a / b rounded, or b = z the rounded root of a.
[[gnu::always_inline]] inline double rest_of(float a, float b, float z) {
  return static_cast<double>(a) - static_cast<double>(b) * static_cast<double>(z);
}
[[gnu::always_inline]] inline double rest_of(double a, double b, double z) {
  return __builtin_fma(-b, z, a);
}
[[gnu::always_inline]] inline double rest_of(long double a, long double b, long double z) {
  const Unrounded<long double> p = two_product(b, z);
  return static_cast<double>((a - p.high) - p.low);
}

/// Is there room below x for all the bits that a product or a rest of its size may have?
template <class N>
[[gnu::always_inline]] inline bool is_far_from_underflow(const N& x) {
  return size(x) >= 0x1p-900 && size(x) <= largest && !std::same_as<N, DoubleDouble>;
}

template <class N>
RunningBound<N> unbounded(const N& z) {
  return {z, 0, infinity};
}

// The results whose bounds are not ordinary. What underflows is less than 2^-1060 / |divisor|.

template <class N>
[[gnu::cold, gnu::noinline]] RunningBound<N> odd_product(RunningBound<N> a, RunningBound<N> b, N z,
                                                         double off, double most) {
  const bool is_zero = (is_exact_zero(a) && is_finite(b)) || (is_finite(a) && is_exact_zero(b));
  if (is_zero) return {z, 0, 0};
  if (most < smallest && size(z) <= largest) return {z, off, smallest};
  const bool is_exact =
      (is_exact_infinity(a) && is_some(b)) || (is_some(a) && is_exact_infinity(b));
  return is_exact ? RunningBound<N>(z) : unbounded(z);
}

template <class N>
[[gnu::cold, gnu::noinline]] RunningBound<N> odd_quotient(RunningBound<N> a, RunningBound<N> b, N z,
                                                          double off, double most) {
  if (!is_finite(a) || !is_finite(b) || !is_some(b) || !(size(z) <= largest)) return unbounded(z);
  if (is_exact_zero(a)) return {z, 0, 0};
  if (most == 0 && is_far_from_underflow(a.value) && is_far_from_underflow(z)) return {z, 0, 0};
  const double divisor = size(b.value) - 2 * b.most;
  if (!(divisor > 0) || !(most <= largest)) return unbounded(z);
  const double raised = most + smallest + 0x1p-1020 / divisor / RunningBound<N>::share;
  return {z, off, raised};
}

template <class N>
[[gnu::cold, gnu::noinline]] RunningBound<N> odd_root(RunningBound<N> a, N z) {
  if (is_exact_zero(a)) return {z, 0, 0};
  const double exact = static_cast<double>(a.value) + a.off, least = exact - 2 * a.slack();
  if (!(a.value > N(0) && least >= 0x1p-900 && a.most <= largest)) return unbounded(z);
  const double root = static_cast<double>(z), exact_root = std::sqrt(exact);
  return {z, exact_root - root, a.most / std::sqrt(least) + root + exact_root};
}

/// a - b to within 2^-52 of itself; infinite where that is no double.
template <class N>
[[gnu::always_inline]] inline double difference_of(const N& a, const N& b) {
  return rounded(a - b);
}
[[gnu::always_inline]] inline double difference_of(float a, float b) {
  return static_cast<double>(a) - static_cast<double>(b);
}

/// The sign of a - b where it is proved, else 0.
template <class N>
[[gnu::cold, gnu::noinline]] int proved_order(RunningBound<N> a, RunningBound<N> b) {
  const double values = difference_of(a.value, b.value), gap = values + (a.off - b.off);
  const double least = std::fabs(gap) * (1 - 0x1p-48) - std::fabs(values) * 0x1p-48;
  return least > 2 * (a.slack() + b.slack()) && std::fabs(gap) <= largest ? (gap > 0 ? 1 : -1) : 0;
}

/// Compares the values, and takes note where that is not proved to be the exact answer.
template <class N, class Order>
[[gnu::always_inline]] inline bool compare(const RunningBound<N>& a, const RunningBound<N>& b,
                                           Order order) {
  const bool said = order(a.value, b.value);
  if (is_known_exact(a) && is_known_exact(b)) return said;
  const double most = a.most + b.most;
  const double gap = std::fabs(difference_of(a.value, b.value));
  if (gap * (1 - 0x1p-20) > most || most == 0) [[likely]]
    if (gap <= largest || most == 0 || is_exact_infinity(a) || is_exact_infinity(b)) [[likely]]
      return said;
  const int sign = proved_order(a, b);
  if (sign == 0 || order(sign, 0) != said) RunningBound<N>::all_proved = false;
  return said;
}

}  // namespace running_bound

template <class N>
[[gnu::always_inline]] inline RunningBound<N> operator-(const RunningBound<N>& a) {
  return {-a.value, -a.off, a.most};
}

template <class N>
[[gnu::always_inline]] inline RunningBound<N> operator+(const RunningBound<N>& a,
                                                        const RunningBound<N>& b) {
  using namespace running_bound;
  const Unrounded<N> s = two_sum(a.value, b.value);
  const double lost = static_cast<double>(s.low);
  const double off = is_known_exact(a)   ? (is_known_exact(b) ? lost : b.off + lost)
                     : is_known_exact(b) ? a.off + lost
                                         : (a.off + b.off) + lost;
  const double most = is_known_exact(a)   ? (is_known_exact(b) ? size(lost) : b.most + size(lost))
                      : is_known_exact(b) ? a.most + size(lost)
                                          : (a.most + b.most) + size(lost);
  return {s.high, off, most};
}

template <class N>
[[gnu::always_inline]] inline RunningBound<N> operator-(const RunningBound<N>& a,
                                                        const RunningBound<N>& b) {
  return a + -b;
}

template <class N>
[[gnu::always_inline]] inline RunningBound<N> operator*(const RunningBound<N>& a,
                                                        const RunningBound<N>& b) {
  using namespace running_bound;
  const N z = a.value * b.value;
  const double x = static_cast<double>(a.value), y = static_cast<double>(b.value);
  const double lost = lost_in_product(a.value, b.value, z);
  double off = lost, most = size(lost);
  if (is_known_exact(a)) {
    if (!is_known_exact(b)) off += x * b.off, most += size(x) * b.most;
  } else if (is_known_exact(b)) {
    off += y * a.off, most += size(y) * a.most;
  } else {
    off += x * b.off + a.off * (y + b.off);
    most += size(x) * b.most + a.most * (size(y) + 2 * b.most);
  }
  if (is_ordinary(most) || (most == 0 && is_far_from_underflow(z))) [[likely]]
    return {z, off, most};
  return odd_product(a, b, z, off, most);
}

/// The quotient; unbounded where b may be 0, or nearly so.
template <class N>
[[gnu::always_inline]] inline RunningBound<N> operator/(const RunningBound<N>& a,
                                                        const RunningBound<N>& b) {
  using namespace running_bound;
  const N z = a.value / b.value;
  const double quotient = static_cast<double>(z), y = static_cast<double>(b.value);
  const double rest = rest_of(a.value, b.value, z);
  // a* / b* - z = (a* - z b*) / b*
  const double inverse = 1 / (y + b.off);
  const double off = (rest + (a.off - quotient * b.off)) * inverse;
  const double most = (size(rest) + a.most + size(quotient) * b.most) * 2 * size(inverse);
  // Shapes are brought to size by powers of two, which rounds nothing: that must cost nothing.
  if ((is_ordinary(most) || (most == 0 && size(z) >= 0x1p-800)) && size(y) > 4 * b.most &&
      size(y) < 0x1p900 && size(y) >= 0x1p-20) [[likely]]
    return {z, off, most};
  return odd_quotient(a, b, z, off, most);
}

/// The square root; unbounded where a may be below 0, or nearly so.
template <class N>
[[gnu::always_inline]] inline RunningBound<N> sqrt(const RunningBound<N>& a) {
  using namespace running_bound;
  using std::sqrt;
  const N z = sqrt(a.value);
  const double x = static_cast<double>(a.value), root = static_cast<double>(z);
  const double rest = rest_of(a.value, z, z);
  // sqrt(z z + x) - z is h - h h / 2z, and no more than |h| h h / z z off that, where h = x / 2z.
  const double inverse = 0.5 / root;
  const double h = (rest + a.off) * inverse, second = h * h * inverse;
  const double most =
      (size(rest) + a.most) * 2 * inverse + second * std::fabs(h) * inverse * 0x1p44;
  if (x > 2 * a.most && x >= 0x1p-900 && most <= largest) [[likely]]
    return {z, h - second, most};
  return odd_root(a, z);
}

template <class N>
[[gnu::always_inline]] inline bool operator==(const RunningBound<N>& a, const RunningBound<N>& b) {
  return running_bound::compare(a, b, std::equal_to<>());
}
template <class N>
[[gnu::always_inline]] inline bool operator<(const RunningBound<N>& a, const RunningBound<N>& b) {
  return running_bound::compare(a, b, std::less<>());
}
template <class N>
[[gnu::always_inline]] inline bool operator>(const RunningBound<N>& a, const RunningBound<N>& b) {
  return running_bound::compare(a, b, std::greater<>());
}
template <class N>
[[gnu::always_inline]] inline bool operator<=(const RunningBound<N>& a, const RunningBound<N>& b) {
  return running_bound::compare(a, b, std::less_equal<>());
}
template <class N>
[[gnu::always_inline]] inline bool operator>=(const RunningBound<N>& a, const RunningBound<N>& b) {
  return running_bound::compare(a, b, std::greater_equal<>());
}

namespace running_bound {
/// The largest power of two that is at most x; x positive.
[[gnu::always_inline]] inline float power_below(float x) {
  if (x < std::numeric_limits<float>::min()) [[unlikely]]
    return std::ldexp(1.0f, std::ilogb(x));
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) & 0x7f800000u);
}
[[gnu::always_inline]] inline double power_below(double x) {
  if (x < std::numeric_limits<double>::min()) [[unlikely]]
    return std::ldexp(1.0, std::ilogb(x));
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & 0x7ff0000000000000u);
}
inline long double power_below(long double x) {
  return std::isinf(x) ? x : std::ldexp(1.0L, std::ilogb(x));
}

inline DoubleDouble power_below(const DoubleDouble& x) {
  const double power = power_below(x.high);
  return DoubleDouble(power == x.high && x.low < 0 ? power / 2 : power);
}

template <class N>
[[gnu::cold, gnu::noinline]] bool is_proved_from_to(RunningBound<N> x, N least, N end) {
  return proved_order(x, RunningBound<N>(least)) > 0 && proved_order(x, RunningBound<N>(end)) < 0;
}
}  // namespace running_bound

/// The same as the routines' own power_of_two (routines/power_of_two.hpp), which it stands in for:
/// its comparisons all prove that the exact size has the same power below it.
template <class N>
[[gnu::always_inline]] inline RunningBound<N> power_of_two(const RunningBound<N>& size) {
  using namespace running_bound;
  if (!(size > RunningBound<N>(0))) return RunningBound<N>(1);
  const N power = power_below(size.value);
  if (!is_known_exact(size) && size.most > 0 &&
      !(running_bound::size(size.value - power) > 2 * size.most &&
        running_bound::size(power - (size.value - power)) > 2 * size.most)) [[unlikely]]
    if (is_infinite(N(2) * power) || !is_proved_from_to(size, power, N(2) * power))
      RunningBound<N>::all_proved = false;
  return RunningBound<N>(power);
}

}  // namespace rayaudit
