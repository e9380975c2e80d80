#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "audit/tally.hpp"
#include "families/family.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// What to audit: every subject on every shape that it answers and every family that draws it.
struct Plan {
  std::vector<const Subject*> subjects;
  std::vector<const Family*> families;
  std::vector<std::size_t> shapes;
  std::uint64_t cases = 0;  ///< for each subject, shape and family
  std::uint64_t seed = 0;
  std::optional<int> difficulty = {};
  Convention convention = {};
  int threads = 0;  ///< 0: one for each processor
};

/// One subject on one shape and family.
struct Audit {
  const Subject* subject;
  const Family* family;
  std::size_t shape;
  Tally tally;
};

/// How far a run has come, in judged cases.
struct Progress {
  std::uint64_t done, all;
};

/// The audits of a plan before they are run, in the order of the lists: subject, shape, family.
/// Empty where nothing in the plan fits together.
std::vector<Audit> planned(const Plan& plan);

/// Runs the plan; the result is the same for any number of threads. Progress is told now and then,
/// from one thread at a time.
std::vector<Audit> run(const Plan& plan, const std::function<void(Progress)>& tell = {});

}  // namespace rayaudit
