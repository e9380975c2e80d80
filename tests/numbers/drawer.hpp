#pragma once

#include <cmath>
#include <random>
#include <string>

#include "geometry/case_line.hpp"
#include "numbers/double_double.hpp"
#include "tests/oracle/dyadic.hpp"

namespace rayaudit {

inline Dyadic exactly(float x) { return Dyadic(x); }
inline Dyadic exactly(double x) { return Dyadic(x); }
inline Dyadic exactly(long double x) {
  const auto high = static_cast<double>(x);
  return Dyadic(high) + Dyadic(static_cast<double>(x - static_cast<long double>(high)));
}
inline Dyadic exactly(const DoubleDouble& x) { return Dyadic(x.high) + Dyadic(x.low); }

/// Is |x| <= most?
inline bool is_at_most(const Dyadic& x, const Dyadic& most) { return size(x) <= most; }

/// x to a few bits.
inline double nearly(const Dyadic& x) {
  const long bits = x.m == 0 ? 0 : static_cast<long>(msb(size(x).m));
  const long shift = bits > 60 ? bits - 60 : 0;
  return std::ldexp(static_cast<double>(static_cast<long long>(x.m >> shift)),
                    static_cast<int>(x.e + shift));
}

inline std::string shown(const DoubleDouble& x) {
  std::string words;
  write(words, x.high), words += " + ";
  write(words, x.low);
  return words;
}

/// Numbers of every kind: of few bits and of many, and such as cancel.
class NumberDrawer {
 public:
  explicit NumberDrawer(unsigned seed) : engine_(seed) {}

  int below(int end) { return static_cast<int>(engine_() % static_cast<unsigned>(end)); }
  int between(int least, int most) { return least + below(most - least + 1); }
  /// In [-1, 1).
  double symmetric() { return std::ldexp(static_cast<double>(engine_() >> 11), -52) - 1; }

  double number(int least, int most) {
    double x = 0;
    while (x == 0) x = below(4) == 0 ? between(-9, 9) : symmetric();
    return std::ldexp(x, between(least, most));
  }
  DoubleDouble word(int least, int most) {
    const double high = number(least, most);
    const double low = below(4) == 0 ? 0 : std::ldexp(high * symmetric(), -53);
    return {high + low, low - ((high + low) - high)};
  }
  /// One that leaves little of x in a sum.
  DoubleDouble near(const DoubleDouble& x) {
    return -x + DoubleDouble(std::ldexp(x.high * symmetric(), -between(0, 110)));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rayaudit
