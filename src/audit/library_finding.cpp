#include "audit/library_finding.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/case_line.hpp"
#include "oracle/position.hpp"

namespace rayaudit {
namespace {

auto kind(const LibraryFinding& finding) {
  return std::tuple(finding.subject, finding.shape, finding.verdict, finding.is_behind());
}

/// What of one audit's outcome rounding does not excuse.
LibraryFinding occurrence(const Audit& audit, const Outcome& outcome) {
  const std::uint64_t count = beyond_rounding(outcome);
  LibraryFinding made;
  made.subject = audit.subject, made.shape = audit.shape;
  made.verdict = outcome.verdict, made.claim = outcome.claim;
  if (outcome.claim != Claim::none) made.claims = {{std::string(name(outcome.claim)), count}};
  made.causes = {{told(outcome.worst->diagnosis), count}};
  made.families = {{std::string(audit.family->id), count, audit.tally.cases}};
  made.wrong = count, made.cases = audit.tally.cases;
  made.audit = &audit;
  made.example = *outcome.worst;
  return made;
}

/// A case whose numbers are of moderate size is the better example, wherever it is found.
bool is_moderate(const Case& question) {
  bool all = true;
  each_number(question, [&](double x) {
    const double size = std::fabs(x);
    all = all && (x == 0 || (size > 0x1p-20 && size < 0x1p20));
  });
  return all;
}

/// From so many u on, a margin leaves no doubt, whatever rounding does.
double clear_margin(const Format& format) { return format == float_format ? 0x1p12 : 0x1p20; }

/// The smaller, the better an example it is.
auto place_among_examples(const LibraryFinding& one) {
  const Worst shown = told_first(one.example);
  return std::tuple(!is_moderate(shown.question),
                    !(shown.severity >= clear_margin(one.subject->format)),
                    -one.families.front().share(), case_line(shown.question).size());
}

bool is_better_example(const LibraryFinding& a, const LibraryFinding& b) {
  return place_among_examples(a) < place_among_examples(b);
}

void join(std::vector<Share>& all, const std::vector<Share>& more) {
  for (const Share& share : more) {
    const auto same = std::find_if(all.begin(), all.end(),
                                   [&](const Share& each) { return each.of == share.of; });
    if (same == all.end())
      all.push_back(share);
    else
      same->count += share.count;
  }
}

void join(std::vector<Afflicted>& all, const Afflicted& more) {
  const auto same = std::find_if(all.begin(), all.end(),
                                 [&](const Afflicted& each) { return each.family == more.family; });
  if (same == all.end())
    all.push_back(more);
  else
    same->wrong += more.wrong;
}

/// The finding that a group of occurrences is, the best example first.
LibraryFinding finding(const std::vector<LibraryFinding>& group) {
  LibraryFinding all = group.front();
  for (auto each = group.begin() + 1; each != group.end(); ++each) {
    join(all.families, each->families.front());
    join(all.claims, each->claims);
    join(all.causes, each->causes);
    all.wrong += each->wrong;
  }
  all.cases = 0;
  for (const Afflicted& family : all.families) all.cases += family.cases;
  std::stable_sort(all.families.begin(), all.families.end(),
                   [](const Afflicted& a, const Afflicted& b) { return a.share() > b.share(); });
  for (std::vector<Share>* shares : {&all.claims, &all.causes})
    std::stable_sort(shares->begin(), shares->end(),
                     [](const Share& a, const Share& b) { return a.count > b.count; });
  return all;
}

/// The finite t that an answer tells.
std::optional<double> told_t(const Case& question, const Answer& answer) {
  const auto& [x, y, z] = answer.point;
  Real t = answer.t;
  if (answer.form == Answer::Form::at) {
    if (!is_finite(x) || !is_finite(y) || !is_finite(z)) return {};
    t = oracle::projection(question.ray, answer.point, oracle::bits_for(double_format));
  } else if (answer.form != Answer::Form::hit) {
    return {};
  }
  if (!is_finite(t)) return {};
  return nearest<double>(t);
}

}  // namespace

std::optional<double> root_that_is_far(const Case& question, const Answer& answer) {
  const auto t = told_t(question, answer);
  if (!t) return {};
  std::optional<double> nearest_one;
  const oracle::Roots all = oracle::roots(question);
  for (const oracle::Root& each : all.roots()) {
    const auto root = nearest<double>(each.t);
    if (!nearest_one || std::fabs(*t - root) < std::fabs(*t - *nearest_one)) nearest_one = root;
  }
  const bool is_far =
      nearest_one && std::fabs(*t - *nearest_one) > wrong_t_limit * std::fabs(*nearest_one);
  return is_far ? nearest_one : std::nullopt;
}

std::uint64_t beyond_rounding(const Outcome& outcome) {
  const bool is_rounding = outcome.worst && outcome.worst->diagnosis.cause == Cause::rounding;
  return is_rounding ? 0 : outcome.beyond_rounding;
}

std::vector<LibraryFinding> library_findings(const std::vector<Audit>& audits) {
  std::vector<std::vector<LibraryFinding>> groups;
  for (const Audit& audit : audits)
    for (const Outcome& outcome : audit.tally.outcomes) {
      if (beyond_rounding(outcome) == 0 || !outcome.worst->repeats) continue;
      LibraryFinding one = occurrence(audit, outcome);
      const auto same = std::find_if(groups.begin(), groups.end(), [&](const auto& group) {
        return kind(group.front()) == kind(one);
      });
      (same == groups.end() ? groups.emplace_back() : *same).push_back(std::move(one));
    }
  std::vector<LibraryFinding> found;
  for (std::vector<LibraryFinding>& group : groups) {
    std::stable_sort(group.begin(), group.end(), is_better_example);
    found.push_back(finding(group));
  }
  const auto place = [&](const LibraryFinding& finding) {
    return std::find_if(audits.begin(), audits.end(),
                        [&](const Audit& audit) {
                          return audit.subject == finding.subject && audit.shape == finding.shape;
                        }) -
           audits.begin();
  };
  std::stable_sort(found.begin(), found.end(),
                   [&](const LibraryFinding& a, const LibraryFinding& b) {
                     return std::tuple(place(a), b.wrong) < std::tuple(place(b), a.wrong);
                   });
  return found;
}

}  // namespace rayaudit
