#pragma once

#include <fmt/format.h>

#include <string>

#include "audit/environment.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {

/// Where a report was made, in a sentence.
inline std::string surroundings(const Environment& environment) {
  return wrapped(
      fmt::format("Found where it ran: rounding {}, {} contraction, {}; compiled by {} with {}; {} "
                  "(runs {} threads at once)",
                  environment.rounding, environment.contraction ? "with" : "no",
                  environment.flush_to_zero ? "flushes to zero" : "no flush to zero",
                  environment.compiler, environment.flags, environment.processor,
                  environment.processors),
      0);
}

}  // namespace rayaudit
