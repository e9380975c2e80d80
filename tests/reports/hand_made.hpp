#pragma once

#include <deque>
#include <string>

#include "reports/report.hpp"

namespace rayaudit {

/// A run made by hand: audits of subjects and families that need not answer or draw.
struct HandMade {
  std::deque<std::string> ids;
  std::deque<Subject> subjects;
  std::deque<Family> families;
  Plan plan = {.subjects = {},
               .families = {},
               .shapes = {0, 1, 2, 3},
               .cases = 100,
               .seed = 0xfedcba9876543210};
  std::vector<Audit> audits;
  Environment environment = {.compiler = "a compiler",
                             .flags = "-O2",
                             .processor = "a processor",
                             .contraction = false,
                             .flush_to_zero = false,
                             .rounding = "to nearest",
                             .processors = 2};

  /// An audit of 100 cases, all right.
  Tally& add(const std::string& subject, std::size_t shape, const std::string& family) {
    ids.push_back(family);
    families.push_back({ids.back(), "", Strength::anywhere, {}, {}});
    subjects.push_back({subject, float_format, {}});
    audits.push_back({&subjects.back(), &families.back(), shape, {}, {}});
    Tally& tally = audits.back().tally;
    tally.cases = tally.decided_by[2] = tally.verdicts[0] = 100;
    return tally;
  }

  /// The same with a subject for several shapes and families: that of the last audit.
  Tally& add(std::size_t shape, const std::string& family) {
    Tally& tally = add("", shape, family);
    audits.back().subject = audits[audits.size() - 2].subject;
    return tally;
  }

  FailOn fail_on;
  Run run() const { return {"1.2.3", plan, audits, environment, "", fail_on}; }
};

/// A case that is told from others by where its ray begins.
inline Case known_case(double x) {
  return {{{x, 0.1, -0.0}, {0, 0, 1}}, Sphere<double>{{0, 0, 5}, 1}};
}

/// Turns so many right answers of a tally into others, the worst of them to a known case with a
/// margin.
inline void turn(Tally& tally, Verdict verdict, Claim claim, std::uint64_t count, double x = 0,
                 double margin = 1) {
  tally.verdicts[0] -= count;
  tally.verdicts[static_cast<std::size_t>(verdict)] += count;
  const bool invalid =
      verdict == Verdict::invalid_handled || verdict == Verdict::invalid_mishandled;
  if (invalid) tally.decided_by[2] -= count;
  const Judgement judgement = {.verdict = verdict, .claim = claim};
  Outcome& outcome = tally.outcome(verdict, claim);
  outcome.count += count;
  outcome.worst = Worst{margin, 0, known_case(x), Answer::hit(real(4.5)), judgement, {}};
}

}  // namespace rayaudit
