#include "reports/failures.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/figures.hpp"
#include "reports/findings.hpp"
#include "reports/promise.hpp"

namespace rayaudit {
namespace {

using figures::grouped;

std::string of_cases(std::uint64_t count, const Tally& tally) {
  return fmt::format("{} of {} cases", grouped(count), grouped(tally.cases));
}

Failure failure(const Broken& broken) {
  const auto& [bound, audit, limit, seen, worst] = broken;
  const std::string what = limit.quantity->is_count
                               ? of_cases(static_cast<std::uint64_t>(seen), audit->tally)
                               : promise(seen);
  const std::string place = bound->place.empty() ? "" : fmt::format(" ({})", bound->place);
  return {limit.quantity->name,
          fmt::format("{} is {}, more than the {} {}{}", limit.quantity->name, what,
                      bound->proved ? "proved" : "observed", promise(limit.most), place),
          worst};
}

Failure failure(const Outcome& outcome, const Tally& tally) {
  std::string what(name(outcome.verdict));
  if (outcome.claim != Claim::none) what += fmt::format(" ({})", name(outcome.claim));
  return {name(outcome.verdict),
          fmt::format("{} in {}: {}{}", what, of_cases(outcome.count, tally),
                      sentence(outcome.verdict), sentence(outcome.claim)),
          &*outcome.worst};
}

}  // namespace

std::vector<Failure> failures(const Audit& audit, const Run& run) {
  std::vector<Failure> all;
  if (!run.plan.bounds.empty() || run.fail_on.asks_anything()) {
    for (const Broken& each : broken(run.plan.bounds, audit)) all.push_back(failure(each));
    if (const auto found = breach(run.fail_on, audit.tally))
      all.push_back({found->type, found->words, found->worst});
    return all;
  }
  for (const Outcome& outcome : audit.tally.outcomes)
    if (is_wrong(outcome.verdict) && outcome.worst) all.push_back(failure(outcome, audit.tally));
  std::stable_sort(all.begin(), all.end(), [](const Failure& a, const Failure& b) {
    return a.worst->severity > b.worst->severity;
  });
  return all;
}

}  // namespace rayaudit
