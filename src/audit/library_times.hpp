#pragma once

#include <optional>
#include <vector>

#include "audit/audit.hpp"
#include "audit/spread.hpp"

namespace rayaudit {

/// What a subject takes for a case of one shape beside the textbook in the same format, in
/// nanoseconds, both on the same cases in the same rounds.
struct TimeBeside {
  const Subject* subject;
  std::size_t shape;
  Spread nanoseconds;
  /// The textbook's; nothing where it does not answer the shape.
  std::optional<Spread> textbook = {};
};

/// Measures every subject of a plan on every shape that it answers: the family `unit`, posed as
/// the subject has it. Differs from run to run. Who cannot be timed, since it crashes, is left out.
std::vector<TimeBeside> times_beside_textbook(const Plan& plan);

}  // namespace rayaudit
