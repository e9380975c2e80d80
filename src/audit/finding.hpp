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
  CauseShare by_cause = {};            ///< of all that are wrong, each audit as its replayed ones
  double margin = 0;                   ///< the largest, in u of its subject's format
  const Audit* audit = nullptr;        ///< of the example
  /// The one with the largest margin, from the most afflicted family that has so large a one.
  Worst example;
};

/// Adds a name to those that it is not among.
void include(std::vector<std::string>& names, std::string_view name);

/// From so many u on, a margin is a defect however much larger it is: of such findings the share
/// tells which is worse.
inline constexpr double defect_margin = 0x1p20;

/// The findings of a run, worst first: by the power of two of the largest margin at which a subject
/// is wrong, up to defect_margin, then by their share. Conduct on invalid cases comes last.
std::vector<Finding> findings(const std::vector<Audit>& audits);

}  // namespace rayaudit
