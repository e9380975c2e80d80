#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "audit/audit.hpp"

namespace rayaudit {

/// A family that a finding occurs in, with its cases for the subject that it afflicts most.
struct Afflicted {
  std::string family;
  std::uint64_t wrong = 0, cases = 1;

  double share() const { return static_cast<double>(wrong) / static_cast<double>(cases); }
};

/// Wrong verdicts that have their routine, shape, verdict and claim in common.
struct Finding {
  std::string routine;  ///< the subject's name up to its number
  std::size_t shape = 0;
  Verdict verdict = Verdict::right;
  Claim claim = Claim::none;
  std::vector<std::string> numbers;    ///< float, double, ...: in which of them it occurs
  std::vector<Afflicted> families;     ///< the most afflicted first
  std::uint64_t wrong = 0, cases = 0;  ///< over all of those
  double share = 0;                    ///< wrong of all cases in the most afflicted family
  CauseCount causes;                   ///< of those that were replayed
  const Audit* audit = nullptr;        ///< of the example
  Worst example;                       ///< the one with the largest margin, in u of its format

  double margin() const { return example.severity; }
};

/// Adds a name to those that it is not among.
void include(std::vector<std::string>& names, std::string_view name);

/// The findings of a run, worst first: by the power of two of the largest margin at which a subject
/// is wrong, then by their share. Conduct on invalid cases comes last.
std::vector<Finding> findings(const std::vector<Audit>& audits);

}  // namespace rayaudit
