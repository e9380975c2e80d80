#pragma once

#include <optional>
#include <vector>

#include "audit/finding.hpp"

namespace rayaudit {

/// How many answers of a finding make a claim, or have a cause.
struct Share {
  std::string of;
  std::uint64_t count = 0;
};

/// A defect of a library: answers that rounding does not excuse, of one subject, shape and verdict
/// over all families, whatever they claim and whyever; but hits behind the start of the ray are a
/// defect of their own.
struct LibraryFinding {
  const Subject* subject = nullptr;
  std::size_t shape = 0;
  Verdict verdict = Verdict::right;
  Claim claim = Claim::none;           ///< of the example
  std::vector<Share> claims, causes;   ///< in words, the most frequent first
  std::vector<Afflicted> families;     ///< with what of each is beyond rounding, the most first
  std::uint64_t wrong = 0, cases = 0;  ///< beyond rounding, over all of those
  const Audit* audit = nullptr;        ///< of the example
  /// Of moderate numbers, else far from any other truth, else of the family that is afflicted most,
  /// else short.
  Worst example;

  bool is_behind() const { return claim == Claim::behind; }
};

/// The root that the t of an answer is nearest to, where it is too far off to be any.
std::optional<double> root_that_is_far(const Case& question, const Answer& answer);

/// How many answers of an outcome rounding does not excuse: none where rounding is their cause.
std::uint64_t beyond_rounding(const Outcome& outcome);

/// The defects that a run beside the textbook has found, in the order of its subjects and shapes,
/// the most frequent first. What did not show again is none.
std::vector<LibraryFinding> library_findings(const std::vector<Audit>& audits);

}  // namespace rayaudit
