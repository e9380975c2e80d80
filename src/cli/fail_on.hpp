#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "audit/tally.hpp"
#include "geometry/format.hpp"

namespace rayaudit {

/// What is to make the exit code 1: verdicts, or an error in ulps beyond a limit.
struct FailOn {
  std::array<bool, verdict_count> verdicts = {};
  std::optional<double> most_ulps = {};
};

/// Reads `false_hit,wrong_t` and `max_ulp=N`; throws Error where it cannot.
FailOn read_fail_on(std::string_view text);

/// How a tally breaks it: in words, with the worst case; nothing where it holds.
struct Breach {
  std::string words;  ///< `37 of 10,000 cases false_miss`
  Worst worst;
};
std::optional<Breach> breach(const FailOn& fail_on, const Tally& tally);

}  // namespace rayaudit
