#pragma once

#include <optional>
#include <string>

#include "audit/tally.hpp"

namespace rayaudit {

/// What is to fail a run: verdicts, or an error in ulps beyond a limit.
struct FailOn {
  std::array<bool, verdict_count> verdicts = {};
  std::optional<double> most_ulps = {};

  bool asks_anything() const { return verdicts != FailOn{}.verdicts || most_ulps.has_value(); }
};

/// How a tally breaks it: in words, with the worst case; nothing where it holds. Cases that were
/// not asked hold nothing.
struct Breach {
  std::string_view type;  ///< a verdict, max_ulp or unasked
  std::string words;      ///< `37 of 10,000 cases false_miss`
  const Worst* worst;     ///< points into the tally; null where nothing in it is wrong
};
std::optional<Breach> breach(const FailOn& fail_on, const Tally& tally);

}  // namespace rayaudit
