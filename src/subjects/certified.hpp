#pragma once

#include <span>

#include "subjects/subject.hpp"

namespace rayaudit {

/// The best routine of each shape (closest_approach; for the disk, division_free) in numbers that
/// carry a proved bound: first in double, then in double-double, then the oracle. An answer is
/// taken where every comparison on its way is proved and t can round to one number only; so it is
/// never wrong, and its t is correctly rounded, ties to even. A touch may be taken or passed by;
/// what the oracle has to settle is passed by. An invalid case is a miss. The answer tells its
/// stage: 1 to 3.
Subject certified_float();
Subject certified_double();

/// An answer whose t is not rounded correctly, but proved to lie within error of the exact one.
struct Certified {
  bool hit;
  double t, error;
  std::uint8_t stage;
};

/// The same stages for cases all of one shape, where any finite bound of t will do.
void certify(std::span<const Case> cases, std::span<Certified> answers);

}  // namespace rayaudit
