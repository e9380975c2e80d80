#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "audit/audit.hpp"

namespace rayaudit {

/// What of an audit fails a build.
struct Failure {
  std::string_view type;  ///< a verdict, or the quantity of a limit
  std::string told;       ///< what is wrong and how often, in a sentence without its full stop
  const Worst* worst;     ///< points into the audit
};

/// The failures of an audit. Where its run has bounds the limits it breaks, in their order; else
/// its wrong verdicts, those first that are wrong farthest from any other truth.
std::vector<Failure> failures(const Audit& audit, const std::vector<Bound>& bounds);

}  // namespace rayaudit
