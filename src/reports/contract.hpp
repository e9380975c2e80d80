#pragma once

#include <string>
#include <vector>

#include "reports/report.hpp"

namespace rayaudit {

/// How often a subject is wrong of so many cases.
struct WrongOf {
  std::uint64_t wrong = 0, cases = 0;
};

/// What was seen of a subject's contract on one shape, over all families of a run.
struct Contract {
  const Subject* subject = nullptr;
  std::size_t shape = 0;
  std::uint64_t cases = 0, wrong = 0;  ///< of valid cases
  std::uint64_t beyond_rounding = 0, unasked = 0;
  double margin = 0;                ///< the largest of a wrong answer, in u
  CauseShare by_cause = {};         ///< of the wrong ones
  WrongOf length, behind, inside;   ///< in the families of these names
  std::uint64_t claims_behind = 0;  ///< hits told that lie before the ray begins
  WrongOf t_in_length;              ///< wrong t, there
  decltype(Tally::touches) touches = {};
  std::uint64_t invalid = 0, invalid_hits = 0, invalid_ends = 0;
};

/// Those of a run, in its order.
std::vector<Contract> contracts_of(const Run& run);

/// What it shows, in words: directions of any length, hits behind, from inside, touches, what is no
/// case at all.
std::string observed(const Contract& contract);

/// The wrong answers by cause, in words: `81% assumption, 19% rounding`; empty where none is.
std::string causes(const Contract& contract);

}  // namespace rayaudit
