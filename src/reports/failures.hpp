#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "reports/report.hpp"

namespace rayaudit {

/// What of an audit fails a build.
struct Failure {
  std::string_view type;  ///< a verdict, or the quantity of a limit
  std::string told;       ///< what is wrong and how often, in a sentence without its full stop
  const Worst* worst;     ///< points into the audit; of cases not asked it may be null
};

/// The failures of an audit. Where its run is held to anything, the limits it breaks, in the order
/// of the bounds, and what of it the run is to fail on; else its wrong verdicts, those first that
/// are wrong farthest from any other truth.
std::vector<Failure> failures(const Audit& audit, const Run& run);

}  // namespace rayaudit
