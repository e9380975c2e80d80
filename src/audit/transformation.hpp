#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "audit/cause.hpp"

namespace rayaudit {

/// An exact change of a case that leaves its truth alone, but for a power of two on t.
struct Transformation {
  std::string_view about;  ///< what answers depend on where it changes them
  /// The changed case; nothing where the format does not hold its numbers.
  std::optional<Case> (*change)(const Case& question, const Format& format);
  int t_exponent;  ///< the t of the changed case are 2^t_exponent times those of the case
  /// Whether every operation of floating point that does not overflow or underflow goes along, so
  /// that the answer must be the same to the last bit.
  bool to_the_bit;
};

/// Every one there is.
std::span<const Transformation> transformations();

/// What a subject that cannot be replayed takes for granted: the first transformation that changes
/// its wrong answer, or nothing. Where rounding may be what changes it, only cases far from any
/// other truth count.
std::string_view assumption_from_outside(const Wrong& wrong, const Subject& subject,
                                         const Convention& convention);

}  // namespace rayaudit
