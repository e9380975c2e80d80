#pragma once

#include <CGAL/Mpzf.h>

#include "oracle/settle.hpp"

namespace rayaudit::oracle {

/// An exact real: (p + e sqrt(d)) / q 2^exponent, e in -1, 0, 1; d >= 0, q != 0. Or an infinity,
/// which ends a stretch that does not end.
struct Radical {
  CGAL::Mpzf p = 0, d = 0, q = 1;
  int e = 0;
  int exponent = 0;
  int infinite = 0;  ///< else its sign
};

/// x to within 2^-bits |x|, bits at most 150.
Real value(const Radical& x, int bits);

/// x to nearest (ties to even) in N: float, double, long double.
template <class N>
N nearest(const Radical& x);

Spelled spelled(const Radical& x, int digits);

/// One root, exactly: how it stands, and its t (of a within: both ends).
struct ExactRoot {
  Outlined outlined;
  Radical t, t_last;
};

/// The roots of a valid case in exact numbers: all, or those up to the first proper crossing.
struct ExactRoots {
  bool constant = false;  ///< F is the same all along the line, or a cap's field 0 all along
  std::uint8_t count = 0;
  std::array<ExactRoot, Truth::most_roots> listed;
};
ExactRoots exact_roots(const Case& question, bool all);

}  // namespace rayaudit::oracle
