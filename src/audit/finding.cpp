#include "audit/finding.hpp"

#include <algorithm>
#include <climits>
#include <cmath>
#include <string_view>
#include <tuple>

namespace rayaudit {
namespace {

/// The wrong verdicts of one kind in one audit.
struct Occurrence {
  const Audit* audit;
  const Outcome* outcome;

  Afflicted afflicted() const {
    return {std::string(audit->family->id), outcome->count, audit->tally.cases};
  }
  double share() const { return afflicted().share(); }
  std::string_view subject() const { return audit->subject->name; }
  std::string_view routine() const { return subject().substr(0, subject().rfind('/')); }
  std::string_view number() const {
    const std::size_t slash = subject().rfind('/');
    return slash == subject().npos ? audit->subject->format.name : subject().substr(slash + 1);
  }
  /// What a finding has in common.
  auto kind() const {
    return std::tuple(routine(), audit->shape, outcome->verdict, outcome->claim);
  }
};

std::vector<Occurrence> occurrences(const std::vector<Audit>& audits) {
  std::vector<Occurrence> all;
  for (const Audit& audit : audits)
    for (const Outcome& outcome : audit.tally.outcomes)
      if (is_wrong(outcome.verdict)) all.push_back({&audit, &outcome});
  return all;
}

/// Of several subjects that a family afflicts the first, who is afflicted most, is told.
void tell(std::vector<Afflicted>& families, const Afflicted& family) {
  const auto is_told = [&](const Afflicted& each) { return each.family == family.family; };
  if (std::none_of(families.begin(), families.end(), is_told)) families.push_back(family);
}

/// The power of two of a margin, no more than that of a defect.
int rank(double margin) {
  return margin > 0 ? std::ilogb(std::min(margin, defect_margin)) : INT_MIN;
}

/// The finding that a group of occurrences is, in the order of the audits.
Finding finding(std::vector<Occurrence> group) {
  Finding made;
  std::tie(made.routine, made.shape, made.verdict, made.claim) = group.front().kind();
  for (const Occurrence& each : group) {
    include(made.numbers, each.number());
    made.wrong += each.outcome->count;
    made.cases += each.audit->tally.cases;
    made.causes.merge(each.outcome->causes);
    add(made.by_cause, by_cause(*each.outcome));
  }
  std::stable_sort(group.begin(), group.end(),
                   [](const Occurrence& a, const Occurrence& b) { return a.share() > b.share(); });
  for (const Occurrence& each : group) tell(made.families, each.afflicted());
  made.share = group.front().share();
  for (const Occurrence& each : group)
    made.margin = std::max(made.margin, each.outcome->worst->severity);
  const auto leading = std::find_if(group.begin(), group.end(), [&](const Occurrence& each) {
    return rank(each.outcome->worst->severity) == rank(made.margin);
  });
  made.audit = leading->audit;
  made.example = *leading->outcome->worst;
  return made;
}

/// Invalid cases are questions about conduct, not about truth: they come last.
bool comes_first(const Finding& a, const Finding& b) {
  const bool a_invalid = a.verdict == Verdict::invalid_mishandled;
  if (a_invalid != (b.verdict == Verdict::invalid_mishandled)) return !a_invalid;
  if (rank(a.margin) != rank(b.margin)) return rank(a.margin) > rank(b.margin);
  if (a.share != b.share) return a.share > b.share;
  return std::tie(a.verdict, a.routine, a.shape, a.claim) <
         std::tie(b.verdict, b.routine, b.shape, b.claim);
}

}  // namespace

void include(std::vector<std::string>& names, std::string_view name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
}

std::vector<Finding> findings(const std::vector<Audit>& audits) {
  std::vector<Occurrence> all = occurrences(audits);
  std::stable_sort(all.begin(), all.end(),
                   [](const Occurrence& a, const Occurrence& b) { return a.kind() < b.kind(); });
  std::vector<Finding> found;
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(
        first, all.end(), [&](const Occurrence& each) { return each.kind() != first->kind(); });
    found.push_back(finding({first, last}));
    first = last;
  }
  std::sort(found.begin(), found.end(), comes_first);
  return found;
}

}  // namespace rayaudit
