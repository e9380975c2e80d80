#include "geometry/real.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/test/unit_test.hpp>
#include <iomanip>
#include <random>
#include <vector>

namespace rayaudit {

std::ostream& operator<<(std::ostream& out, const Real& x) {
  return out << std::hexfloat << "(" << x.high << " + " << x.middle << " + " << x.low << ") 2^"
             << std::dec << x.exponent;
}

namespace {

using boost::multiprecision::cpp_bin_float;
using boost::multiprecision::digit_base_2;

/// Wide enough that every sum of these tests is exact.
using Wide =
    boost::multiprecision::number<cpp_bin_float<6000, digit_base_2>, boost::multiprecision::et_off>;

Wide wide(const Real& x) { return ldexp(Wide(x.high) + Wide(x.middle) + Wide(x.low), x.exponent); }

/// Is rounded the number of N nearest to x, ties to even, by its neighbours' distances?
template <class N>
bool is_nearest(N rounded, const Wide& x) {
  const N infinity = std::numeric_limits<N>::infinity();
  const N largest = std::numeric_limits<N>::max();
  const N ulp_of_largest = largest - std::nextafter(largest, N(0));
  const Wide overflow = Wide(largest) + Wide(ulp_of_largest) / 2;
  if (std::isinf(rounded)) return rounded > 0 ? x >= overflow : x <= -overflow;
  if (abs(x) >= overflow) return false;
  const Wide distance = abs(Wide(rounded) - x);
  bool tie = false;
  for (const N end : {-infinity, infinity}) {
    const N neighbour = std::nextafter(rounded, end);
    if (std::isinf(neighbour)) continue;
    const Wide other = abs(Wide(neighbour) - x);
    if (other < distance) return false;
    tie = tie || other == distance;
  }
  int exponent = 0;
  const N fraction = std::frexp(rounded, &exponent);
  const int bits =
      std::min(std::numeric_limits<N>::digits, exponent - format_of<N>.tiny_exponent());
  return !tie || std::fmod(std::ldexp(fraction, bits), N(2)) == 0;
}

/// Numbers that sit on and beside the midpoints and ends of the formats.
struct Numbers {
  std::mt19937_64 engine{20240229};

  int below(int n) { return static_cast<int>(engine() % static_cast<std::uint64_t>(n)); }
  double sign() { return below(2) == 0 ? -1 : 1; }

  /// A number of 1 to 53 bits in [1, 2).
  double significand() {
    const int kept = below(4) == 0 ? below(30) : 52;
    return 1 + std::ldexp(static_cast<double>(engine() >> (64 - kept - 1) >> 1), -kept);
  }

  double part(int exponent) { return sign() * std::ldexp(significand(), exponent); }

  int exponent() {
    static constexpr int places[] = {0, 1, 127, 128, -126, -149, -150, 1023, -1022, -1074, -1075};
    return below(3) == 0 ? below(2000) - 1000 : places[below(11)] + below(3) - 1;
  }

  /// High part on a midpoint or a grid point of a format, lower parts far below that break ties.
  Real real() {
    static constexpr int gaps[] = {24, 25, 53, 54, 64, 65, 80, 300};
    Real x = {part(0), 0, 0, exponent()};
    if (below(4) != 0) x.middle = below(2) == 0 ? part(-gaps[below(8)]) : sign() * 0x1p-53;
    if (below(2) == 0) x.middle = sign() * std::ldexp(1.0, -gaps[below(8)]);
    if (below(3) != 0) x.low = sign() * std::ldexp(significand(), -60 - gaps[below(8)] * below(3));
    if (below(8) == 0) x.high = sign();
    if (below(16) == 0) x.high = -x.middle;
    return x;
  }
};

double ulp(double x) { return std::nextafter(std::abs(x), INFINITY) - std::abs(x); }

template <class N>
void check_nearest() {
  Numbers numbers;
  for (int i = 0; i < 60'000; ++i) {
    const Real x = numbers.real();
    const N rounded = nearest<N>(x);
    BOOST_TEST_REQUIRE(is_nearest(rounded, wide(x)), x << " gave " << rounded);
  }
}

BOOST_AUTO_TEST_CASE(nearest_is_correctly_rounded_in_float) { check_nearest<float>(); }
BOOST_AUTO_TEST_CASE(nearest_is_correctly_rounded_in_double) { check_nearest<double>(); }
BOOST_AUTO_TEST_CASE(nearest_is_correctly_rounded_in_long_double) { check_nearest<long double>(); }

BOOST_AUTO_TEST_CASE(a_third_part_breaks_the_tie_of_the_first_two) {
  BOOST_TEST(nearest<double>({1, 0x1p-53, 0x1p-200, 0}) == 1 + 0x1p-52);
  BOOST_TEST(nearest<double>({1, 0x1p-53, 0, 0}) == 1.0);
  BOOST_TEST(nearest<double>({1, 0x1p-53, -0x1p-200, 0}) == 1.0);
  BOOST_TEST(nearest<double>({1, -0x1p-54, -0x1p-200, 0}) == 1 - 0x1p-53);
  BOOST_TEST(nearest<float>({1 + 0x1p-24, 0, 0x1p-200, 0}) == 1 + 0x1p-23f);
  BOOST_TEST(nearest<long double>({1, 0x1p-64, 0x1p-200, 0}) == 1 + 0x1p-63L);
  BOOST_TEST(normal({1, 0x1p-53, 0x1p-200, 0}).high == 1 + 0x1p-52);
}

BOOST_AUTO_TEST_CASE(nearest_meets_the_ends_of_each_format) {
  BOOST_TEST(nearest<double>({1, 0, 0, -1075}) == 0.0);
  BOOST_TEST(nearest<double>({1, 0x1p-70, 0, -1075}) == 0x1p-1074);
  BOOST_TEST(nearest<double>({1, -0x1p-54, 0, 1024}) == std::numeric_limits<double>::infinity());
  BOOST_TEST(nearest<double>({1, -0x1p-54, -0x1p-90, 1024}) == std::numeric_limits<double>::max());
  BOOST_TEST(nearest<float>({-1, 0, 0, 5000}) == -std::numeric_limits<float>::infinity());
  BOOST_TEST(std::signbit(nearest<float>(real(-0.0))));
  BOOST_TEST(std::signbit(nearest<float>({-1, 0, 0, -5000})));
  BOOST_TEST(std::isnan(nearest<double>(real(std::nan("")))));
}

BOOST_AUTO_TEST_CASE(every_long_double_becomes_a_real_and_comes_back) {
  Numbers numbers;
  for (int i = 0; i < 20'000; ++i) {
    const auto bits = static_cast<long double>(numbers.engine() | std::uint64_t{1} << 63);
    const int exponent =
        numbers.below(2) == 0 ? numbers.below(32'000) - 16'400 : numbers.exponent() - 63;
    const auto x = static_cast<long double>(numbers.sign()) * std::ldexp(bits, exponent);
    BOOST_TEST_REQUIRE(nearest<long double>(real(x)) == x, real(x));
    if (std::isfinite(x)) BOOST_TEST_REQUIRE((wide(real(x)) == Wide(x)), real(x));
  }
}

BOOST_AUTO_TEST_CASE(normal_keeps_the_value_and_separates_the_parts) {
  Numbers numbers;
  for (int i = 0; i < 40'000; ++i) {
    const Real x = numbers.real();
    const Real n = normal(x);
    BOOST_TEST_REQUIRE((wide(n) == wide(x)), x);
    BOOST_TEST_REQUIRE(2 * std::abs(n.middle) <= ulp(n.high), x);
    BOOST_TEST_REQUIRE(2 * std::abs(n.low) <= ulp(n.middle), x);
    const Wide value = ldexp(wide(x), -n.exponent);
    BOOST_TEST_REQUIRE(is_nearest(n.high, value), x);
    BOOST_TEST_REQUIRE(sign(x) == (value > 0) - (value < 0), x);
  }
}

BOOST_AUTO_TEST_CASE(a_sum_beyond_the_largest_double_is_still_normal) {
  const Real x = {std::numeric_limits<double>::max(), std::numeric_limits<double>::max(), 0x1p900,
                  3};
  BOOST_TEST((wide(normal(x)) == wide(x)));
  BOOST_TEST(binade(x) == 1024 + 3);
}

BOOST_AUTO_TEST_CASE(the_binade_is_the_largest_power_of_two_not_above) {
  Numbers numbers;
  for (int i = 0; i < 20'000; ++i) {
    const Real x = numbers.real();
    if (sign(x) == 0) continue;
    const Wide magnitude = abs(wide(x));
    const Wide power = ldexp(Wide(1), binade(x));
    BOOST_TEST_REQUIRE((power <= magnitude && magnitude < 2 * power), x);
  }
  BOOST_TEST(binade({1, -0x1p-1000, 0, 5}) == 4);
  BOOST_TEST(binade({1, 0x1p-1000, 0, 5}) == 5);
}

BOOST_AUTO_TEST_CASE(a_difference_is_true_to_its_promise) {
  Numbers numbers;
  for (int i = 0; i < 40'000; ++i) {
    const Real a = numbers.real();
    Real b = numbers.real();
    if (numbers.below(2) == 0) b.exponent = a.exponent;
    if (numbers.below(4) == 0) b = {a.high, a.middle, -a.low, a.exponent};
    if (numbers.below(4) == 0) b = {a.high / 8, a.middle / 8, a.low / 8, a.exponent + 3};
    const Wide exact = wide(a) - wide(b);
    const Real d = difference(a, b);
    BOOST_TEST_REQUIRE((abs(wide(d) - exact) <= ldexp(abs(exact), -100)), a << " - " << b);
    BOOST_TEST_REQUIRE(compare(a, b) == (exact > 0) - (exact < 0), a << " - " << b);
  }
}

BOOST_AUTO_TEST_CASE(what_cancels_leaves_the_lowest_part) {
  const Real x = {1, 0x1p-900, 0, 0};
  BOOST_TEST(compare(difference(x, {0x1p-7, 0, 0, 7}), {1, 0, 0, -900}) == 0);
  BOOST_TEST(compare(difference(x, {0x1p-7, 0x1p-907, 0, 7}), {}) == 0);
}

BOOST_AUTO_TEST_CASE(infinities_compare_as_they_should) {
  const Real infinity = real(std::numeric_limits<double>::infinity());
  const Real huge = {1, 0, 0, 5000};
  BOOST_TEST(compare(infinity, huge) == 1);
  BOOST_TEST(compare(huge, infinity) == -1);
  BOOST_TEST(compare(infinity, infinity) == 0);
  BOOST_TEST(compare(huge, real(-infinity.high)) == 1);
  BOOST_TEST(is_infinite(difference(infinity, huge)));
  BOOST_TEST(compare(huge, {1, 0, 0, -5000}) == 1);
}

BOOST_AUTO_TEST_CASE(a_correctly_rounded_number_is_within_half_an_ulp) {
  Numbers numbers;
  for (int i = 0; i < 20'000; ++i) {
    const Real x = numbers.real();
    BOOST_TEST_REQUIRE(ulps(real(nearest<float>(x)), x, float_format) <= 0.5, x);
    BOOST_TEST_REQUIRE(ulps(real(nearest<double>(x)), x, double_format) <= 0.5, x);
    BOOST_TEST_REQUIRE(ulps(real(nearest<long double>(x)), x, long_double_format) <= 0.5, x);
  }
}

BOOST_AUTO_TEST_CASE(ulps_count_spacings_at_the_exact_value) {
  BOOST_TEST(ulps(real(1 + 0x1p-51), real(1.0), double_format) == 2);
  BOOST_TEST(ulps(real(1 - 0x1p-53), real(1.0), double_format) == 0.5);
  BOOST_TEST(ulps(real(1.0), real(1 - 0x1p-53), double_format) == 1);
  BOOST_TEST(ulps(real(1.5), real(1.0), float_format) == 0x1p22);
  BOOST_TEST(ulps(real(0x1p-1074), real(0.0), double_format) == 1);
  BOOST_TEST(ulps(real(0.0), {1, 0, 0, -1076}, double_format) == 0.25);
  BOOST_TEST(std::isinf(ulps(real(INFINITY), real(1.0), double_format)));
  BOOST_TEST(ulps(real(INFINITY), {1, 0, 0, 128}, float_format) == 0);
  BOOST_TEST(std::isinf(ulps(real(-INFINITY), {1, 0, 0, 128}, float_format)));
}

BOOST_AUTO_TEST_CASE(scaled_saturates_at_both_ends) {
  BOOST_TEST(scaled(real(-3.0), 1) == 1.5);
  BOOST_TEST(scaled({1, 0, 0, 4000}, 3999) == 2);
  BOOST_TEST(std::isinf(scaled({1, 0, 0, 4000}, 0)));
  BOOST_TEST(scaled({1, 0, 0, -4000}, 0) == 0);
}

BOOST_AUTO_TEST_CASE(the_least_number_that_overflows_is_half_an_ulp_beyond_the_largest) {
  BOOST_TEST(overflows({1, -0x1p-25, 0, 128}, float_format));
  BOOST_TEST(!overflows({1, -0x1p-25, -0x1p-300, 128}, float_format));
  BOOST_TEST(overflows({-1, 0x1p-54, 0, 1024}, double_format));
  BOOST_TEST(!overflows({-1, 0x1p-54, 0x1p-300, 1024}, double_format));
  BOOST_TEST(!overflows({1, 0, 0, 16383}, long_double_format));
  BOOST_TEST(overflows({1, 0, 0, 16384}, long_double_format));
  BOOST_TEST(overflows(real(-INFINITY), float_format));
  BOOST_TEST(!overflows(real(std::nan("")), float_format));
  BOOST_TEST(!overflows(real(0.0), float_format));
}

}  // namespace
}  // namespace rayaudit
