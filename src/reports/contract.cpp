#include "reports/contract.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "audit/library_finding.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using figures::grouped;

/// The wrong answers to valid cases.
std::uint64_t wrong_of_valid(const Tally& tally) {
  return tally.wrong() - tally.of(Verdict::invalid_mishandled);
}

void add(Contract& contract, const Audit& audit) {
  const Tally& tally = audit.tally;
  const std::uint64_t wrong = wrong_of_valid(tally);
  const std::uint64_t invalid =
      tally.of(Verdict::invalid_handled) + tally.of(Verdict::invalid_mishandled);
  contract.cases += tally.cases - invalid;
  contract.wrong += wrong;
  contract.unasked += tally.unasked;
  contract.invalid += invalid;
  contract.invalid_hits += tally.of(Verdict::invalid_mishandled);
  for (const Outcome& outcome : tally.outcomes) {
    contract.beyond_rounding += beyond_rounding(outcome);
    if (!is_wrong(outcome.verdict)) continue;
    if (outcome.verdict == Verdict::invalid_mishandled) {
      if (outcome.claim == Claim::ended) contract.invalid_ends += outcome.count;
      continue;
    }
    if (outcome.worst) contract.margin = std::max(contract.margin, outcome.worst->severity);
    if (outcome.claim == Claim::behind) contract.claims_behind += outcome.count;
    rayaudit::add(contract.by_cause, by_cause(outcome));
  }
  const WrongOf here = {wrong, tally.cases - invalid};
  if (audit.family->id == "length") {
    contract.length = here;
    contract.t_in_length = {tally.of(Verdict::wrong_t), here.cases};
  }
  if (audit.family->id == "behind") contract.behind = here;
  if (audit.family->id == "inside") contract.inside = here;
  for (std::size_t kind = 0; kind < contract.touches.size(); ++kind) {
    contract.touches[kind].taken += tally.touches[kind].taken;
    contract.touches[kind].passed += tally.touches[kind].passed;
  }
}

std::string of(const WrongOf& count) {
  return fmt::format("{} of {} wrong", grouped(count.wrong), grouped(count.cases));
}

/// A touch: always taken, never, or how often.
std::string manner(const TouchCount& count) {
  if (count.passed == 0) return "hit";
  if (count.taken == 0) return "miss";
  return fmt::format("{}% hit", figures::percent(count.taken, count.taken + count.passed));
}

}  // namespace

std::vector<Contract> contracts_of(const Run& run) {
  std::vector<Contract> all;
  for (const Audit& audit : run.audits) {
    if (all.empty() || all.back().subject != audit.subject || all.back().shape != audit.shape)
      all.emplace_back().subject = audit.subject, all.back().shape = audit.shape;
    add(all.back(), audit);
  }
  return all;
}

std::string observed(const Contract& contract) {
  std::vector<std::string> words;
  const Convention& declared = contract.subject->convention;
  if (contract.length.cases > 0 && !declared.unit_direction && !declared.segment)
    words.push_back(fmt::format("directions of any length {}, {} of it in t", of(contract.length),
                                grouped(contract.t_in_length.wrong)));
  if (contract.behind.cases > 0)
    words.push_back(fmt::format("all behind {}, hits before the start {} in all",
                                of(contract.behind), grouped(contract.claims_behind)));
  if (contract.inside.cases > 0) words.push_back("from inside " + of(contract.inside));
  for (std::size_t kind = 1; kind < contract.touches.size(); ++kind)
    if (const TouchCount& count = contract.touches[kind]; count.taken + count.passed > 0)
      words.push_back(fmt::format("{} {}", name(static_cast<oracle::Kind>(kind)), manner(count)));
  if (contract.invalid > 0)
    words.push_back(fmt::format("no case at all: a hit or worse for {} of {}",
                                grouped(contract.invalid_hits), grouped(contract.invalid)) +
                    (contract.invalid_ends > 0
                         ? fmt::format(", its process ended for {}", grouped(contract.invalid_ends))
                         : ""));
  if (contract.unasked > 0)
    words.push_back(
        fmt::format("{} not asked, for it crashed or hung too often", grouped(contract.unasked)));
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string causes(const Contract& contract) {
  std::vector<std::pair<double, std::string_view>> parts;
  for (std::size_t i = 0; i < cause_count; ++i)
    if (contract.by_cause[i] > 0)
      parts.emplace_back(contract.by_cause[i], name(static_cast<Cause>(i)));
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> words;
  words.reserve(parts.size());
  // A share of replayed answers is no whole number of all.
  constexpr double fine = 1000;
  const auto whole = static_cast<std::uint64_t>(fine * static_cast<double>(contract.wrong));
  for (const auto& [share, cause] : parts) {
    const auto part = static_cast<std::uint64_t>(std::ceil(fine * share));
    words.push_back(parts.size() == 1
                        ? std::string(cause)
                        : fmt::format("{}% {}", figures::percent(part, whole), cause));
  }
  return fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace rayaudit
