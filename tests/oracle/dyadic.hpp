#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>

#include "geometry/real.hpp"
#include "geometry/vec3.hpp"

namespace rayaudit {

/// An exact number m 2^e for tests: sums, differences and products of doubles, with no CGAL in it.
struct Dyadic {
  boost::multiprecision::cpp_int m = 0;
  long e = 0;

  Dyadic() = default;
  Dyadic(double x) {
    int exponent = 0;
    m = static_cast<long long>(std::ldexp(std::frexp(x, &exponent), 53));
    e = m == 0 ? 0 : exponent - 53;
  }
  Dyadic(const boost::multiprecision::cpp_int& mantissa, long exponent)
      : m(mantissa), e(mantissa == 0 ? 0 : exponent) {}

  int sign() const { return m.sign(); }
};

inline Dyadic operator-(const Dyadic& a) {
  Dyadic negative = a;
  negative.m.backend().negate();  // gcc 12 takes the expression -m for uninitialized
  return negative;
}

inline Dyadic operator+(const Dyadic& a, const Dyadic& b) {
  if (a.m == 0) return b;
  if (b.m == 0) return a;
  if (a.e < b.e) return b + a;
  return {(a.m << (a.e - b.e)) + b.m, b.e};
}

inline Dyadic operator-(const Dyadic& a, const Dyadic& b) { return a + -b; }
inline Dyadic operator*(const Dyadic& a, const Dyadic& b) { return {a.m * b.m, a.e + b.e}; }

inline bool operator<=(const Dyadic& a, const Dyadic& b) { return (b - a).sign() >= 0; }
inline bool operator<(const Dyadic& a, const Dyadic& b) { return (b - a).sign() > 0; }

inline Dyadic size(const Dyadic& a) { return a.sign() < 0 ? -a : a; }
inline Dyadic times_power(const Dyadic& a, long exponent) { return {a.m, a.e + exponent}; }

/// A finite Real, exactly.
inline Dyadic exactly(const Real& x) {
  return times_power(Dyadic(x.high) + Dyadic(x.middle) + Dyadic(x.low), x.exponent);
}
inline Vec3<Dyadic> exactly(const Vec3<Real>& p) {
  return {exactly(p.x), exactly(p.y), exactly(p.z)};
}

/// Is |got - exact| <= 2^-bits |exact|?
inline bool agree(const Dyadic& got, const Dyadic& exact, int bits) {
  return times_power(size(got - exact), bits) <= size(exact);
}

}  // namespace rayaudit
