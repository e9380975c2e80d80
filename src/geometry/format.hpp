#pragma once

#include <limits>
#include <string_view>

namespace rayaudit {

/// A binary floating-point format: what a subject works in, what an ulp is counted in.
struct Format {
  std::string_view name;
  int precision;     ///< bits of the significand, the hidden one included
  int min_exponent;  ///< the exponent e of the smallest normal number 2^e
  int max_exponent;  ///< the exponent e of the largest binade [2^e, 2^(e+1))

  friend bool operator==(const Format&, const Format&) = default;

  /// Exponent of the smallest subnormal number.
  constexpr int tiny_exponent() const { return min_exponent - (precision - 1); }
  /// Exponent of the unit roundoff u: half the spacing at 1.
  constexpr int unit_exponent() const { return -precision; }
};

template <class N>
constexpr Format format_named(std::string_view name) {
  using Limits = std::numeric_limits<N>;
  return {name, Limits::digits, Limits::min_exponent - 1, Limits::max_exponent - 1};
}

inline constexpr Format float_format = format_named<float>("float");
inline constexpr Format double_format = format_named<double>("double");
inline constexpr Format long_double_format = format_named<long double>("long_double");
/// Two doubles; whole numbers of 2^-1074, as its lower one has it.
inline constexpr Format double_double_format = {"double_double", 106, -969, 1023};
/// IEEE 754 binary128.
inline constexpr Format float128_format = {"float128", 113, -16382, 16383};

template <class N>
inline constexpr Format format_of = double_format;
template <>
inline constexpr Format format_of<float> = float_format;
template <>
inline constexpr Format format_of<long double> = long_double_format;

}  // namespace rayaudit
