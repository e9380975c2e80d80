#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

#include "audit/finding.hpp"
#include "reports/failure_block.hpp"
#include "reports/failures.hpp"
#include "reports/figures.hpp"
#include "reports/findings.hpp"
#include "reports/markdown_text.hpp"
#include "reports/report.hpp"

namespace rayaudit {
namespace {

using figures::grouped;

/// So many findings are told where not all are asked for.
constexpr std::size_t findings_shown = 20;

std::string plural(std::uint64_t count, std::string_view one, std::string_view more) {
  return fmt::format("{} {}", grouped(count), count == 1 ? one : more);
}

std::string verdict(const Run& run) {
  std::uint64_t failed = 0, cases = 0, wrong = 0, unasked = 0;
  for (const Audit& audit : run.audits) {
    failed += !failures(audit, run).empty();
    cases += audit.tally.cases;
    wrong += audit.tally.wrong();
    unasked += audit.tally.unasked;
  }
  std::string of = fmt::format("{} of {}", grouped(wrong), plural(cases, "case", "cases"));
  const std::string missing = unasked > 0 ? fmt::format(", {} not asked", grouped(unasked)) : "";
  const std::string audits = plural(run.audits.size(), "audit", "audits");
  const bool is_to_fail = run.fail_on.asks_anything();
  if (run.plan.bounds.empty() && failed == 0)
    return fmt::format("**rayaudit: all {} hold**; {} wrong{}", audits, of, missing);
  if (run.plan.bounds.empty())
    return fmt::format("**rayaudit: {} of {} {}**; {} wrong{}", grouped(failed), audits,
                       is_to_fail ? "fail by --fail-on" : "have wrong answers", of, missing);
  if (failed == 0)
    return fmt::format("**rayaudit: every bound is kept** in {}; {} wrong{}", audits, of, missing);
  return fmt::format("**rayaudit: bounds are broken{}** in {} of {}; {} wrong{}",
                     is_to_fail ? ", or --fail-on" : "", grouped(failed), audits, of, missing);
}

/// A subject over all families of each shape.
struct Row {
  const Subject* subject;
  std::array<Tally, shape_count> shapes = {};
  std::array<bool, shape_count> failed = {};
};

std::vector<Row> rows(const Run& run) {
  std::vector<Row> all;
  for (const Audit& audit : run.audits) {
    if (all.empty() || all.back().subject != audit.subject) all.push_back({audit.subject});
    all.back().shapes[audit.shape].merge(audit.tally);
    if (!failures(audit, run).empty()) all.back().failed[audit.shape] = true;
  }
  return all;
}

std::string cell(const Tally& tally, bool failed) {
  if (tally.cases == 0) return "";
  const std::string text =
      tally.wrong() == 0 ? fmt::format("0 of {}", grouped(tally.cases))
                         : fmt::format("{} % of {}", figures::percent(tally.wrong(), tally.cases),
                                       grouped(tally.cases));
  return failed ? "**" + text + "**" : text;
}

std::string table_heading(const Plan& plan) {
  std::string names = "| wrong answers |", rule = "|---|";
  for (const std::size_t shape : plan.shapes) {
    names += fmt::format(" {} |", shape_names[shape]);
    rule += "--:|";
  }
  return names + '\n' + rule + '\n';
}

std::string line(const Row& row, const Plan& plan) {
  std::string text = fmt::format("| {} |", markdown_text(row.subject->name));
  for (const std::size_t shape : plan.shapes)
    text += fmt::format(" {} |", cell(row.shapes[shape], row.failed[shape]));
  return text + '\n';
}

std::string details(const Finding& finding, const Convention& stated) {
  const Afflicted& most = finding.families.front();
  const std::string summary =
      fmt::format("{} by {} on {}: {}{}; {} % of {}", figures::words(name(finding.verdict)),
                  finding.routine, shape_names[finding.shape], sentence(finding.verdict),
                  sentence(finding.claim), figures::percent(most.wrong, most.cases), most.family);
  return folded(summary, failure_block(finding.example, *finding.audit->subject, stated));
}

/// What is worth a look: what fails the run; then, where it is held to no bounds, the findings,
/// worst first.
std::vector<std::string> all_details(const Run& run) {
  const bool is_bound = !run.plan.bounds.empty();
  std::vector<std::string> all;
  for (const Audit& audit : run.audits) {
    if (!is_bound && !run.fail_on.asks_anything()) break;
    for (const Failure& failure : failures(audit, run))
      all.push_back(folded(fmt::format("{} on {}, family {}: {}", audit.subject->name,
                                       shape_names[audit.shape], audit.family->id, failure.told),
                           failure.worst == nullptr ? ""
                                                    : failure_block(*failure.worst, *audit.subject,
                                                                    run.plan.convention)));
  }
  if (is_bound) return all;
  for (const Finding& finding : findings(run.audits))
    all.push_back(details(finding, run.plan.convention));
  return all;
}

std::string foot(const Run& run) {
  const Plan& plan = run.plan;
  return fmt::format("\nrayaudit {}: {} for each subject, shape and family; seed {}{}\n",
                     run.version, plural(plan.cases, "case", "cases"), plan.seed,
                     plan.difficulty ? fmt::format("; difficulty {}", *plan.difficulty) : "");
}

}  // namespace

std::string write_markdown(const Run& run, const Look& look) {
  ShortMarkdown text(verdict(run) + "\n\n" + table_heading(run.plan), foot(run));
  std::vector<std::string> lines;
  for (const Row& row : rows(run)) lines.push_back(line(row, run.plan));
  text.add(lines, lines.size(), "subjects are", ShortMarkdown::most / 2);
  const std::vector<std::string> found = all_details(run);
  text.add(found, look.everything ? found.size() : findings_shown,
           run.plan.bounds.empty() ? "findings, less severe, are" : "broken limits are");
  return text.text();
}

}  // namespace rayaudit
