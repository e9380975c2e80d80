#pragma once

#include <CGAL/Interval_nt.h>

#include "oracle/settle.hpp"

/// CGAL's intervals as a number of the fields. Upward rounding must be on for every operation.
namespace rayaudit::oracle {

using Interval = CGAL::Interval_nt<false>;

/// CGAL's square is tighter than a product: it knows that both factors are one number.
template <>
[[gnu::always_inline]] inline Interval squared(const Interval& x) {
  return CGAL::square(x);
}

template <>
struct Signs<Interval> {
  bool unsure = false;

  int operator()(const Interval& x) {
    if (x.inf() > 0) return 1;
    if (x.sup() < 0) return -1;
    if (!(x.inf() == 0 && x.sup() == 0)) unsure = true;
    return 0;
  }
};

}  // namespace rayaudit::oracle
