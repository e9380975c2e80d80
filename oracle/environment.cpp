#include "oracle/environment.hpp"

#include <cfenv>
#ifdef __SSE2__
#include <immintrin.h>
#endif

namespace rayaudit::oracle {

void require_plain_arithmetic() {
#ifdef __SSE2__
  constexpr unsigned flush_to_zero = 0x8000, denormals_are_zero = 0x0040, rounding = 0x6000;
  const unsigned state = _mm_getcsr();
  const bool flushes = (state & (flush_to_zero | denormals_are_zero)) != 0;
  const bool nearest = (state & rounding) == 0;
#else
  const bool nearest = std::fegetround() == FE_TONEAREST;
  volatile double least = 0x1p-1074;
  const bool flushes = least * 1.0 == 0;
#endif
  if (!nearest) throw UnfitArithmetic("this thread does not round to nearest");
  if (flushes) throw UnfitArithmetic("this thread flushes subnormal numbers to zero");
}

bool rounds_to_float(const Vec3<double>& v) {
  const Vec3<double> rounded = in<double>(in<float>(v));
  const auto is_float = [](double x) {
    volatile const float stored = static_cast<float>(x);
    return static_cast<double>(stored) == x;
  };
  return is_float(rounded.x) && is_float(rounded.y) && is_float(rounded.z);
}

}  // namespace rayaudit::oracle
