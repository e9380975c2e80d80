#pragma once

#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace rayaudit {

/// Wrong verdicts that have their routine, shape, verdict and claim in common.
struct Finding {
  std::string routine;  ///< the subject's name up to its number
  std::size_t shape = 0;
  Verdict verdict = Verdict::right;
  Claim claim = Claim::none;           ///< the one that the worst case makes
  std::vector<std::string> numbers;    ///< float, double, ...: in which of them it occurs
  std::vector<std::string> families;   ///< in which families, the most afflicted first
  std::uint64_t wrong = 0, cases = 0;  ///< over all of those
  double share = 0;                    ///< wrong of all cases in the most afflicted family
  std::string subject;                 ///< of the example
  Worst example;
};

/// The findings of a run, worst first.
std::vector<Finding> findings(const std::vector<Audit>& audits);

}  // namespace rayaudit
