#pragma once

// The compiler's own quadruple precision, where it has one: gcc.
#if defined(__GNUC__) && !defined(__clang__)
#define RAYAUDIT_HAS_QUAD

#include <boost/multiprecision/float128.hpp>

#include "geometry/format.hpp"
#include "geometry/real.hpp"

namespace rayaudit {

/// IEEE 754 binary128, in software.
using Quad = boost::multiprecision::float128;

template <>
inline constexpr Format format_of<Quad> = float128_format;

/// Exactly the number x, in three doubles; an infinity or a NaN stays one.
inline Real real(const Quad& x) {
  if (x == 0 || !isfinite(x)) return {static_cast<double>(x), 0, 0, 0};
  Real exact;
  Quad rest = frexp(x, &exact.exponent);
  for (double* part : {&exact.high, &exact.middle, &exact.low}) {
    *part = static_cast<double>(rest);
    rest -= *part;
  }
  return exact;
}

}  // namespace rayaudit
#endif
