#include "cli/audit_end.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/bounds_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/saved_cases.hpp"
#include "cli/whole_file.hpp"
#include "geometry/error.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

int told_breach(const Plan& plan, const std::vector<Audit>& audits, const FailOn& fail_on) {
  const auto breaks = [&](const Audit& audit) { return breach(fail_on, audit.tally).has_value(); };
  const auto first = std::find_if(audits.begin(), audits.end(), breaks);
  if (first == audits.end()) return all_held;
  const Breach broken = *breach(fail_on, first->tally);
  const auto others = std::count_if(first + 1, audits.end(), breaks);
  complain(fmt::format(
      "--fail-on: {} on {}, family {}: {}{}{}", first->subject->name, shape_names[first->shape],
      first->family->id, broken.words,
      others > 0 ? fmt::format(" (and {} more audit{})", others, others == 1 ? " fails" : "s fail")
                 : "",
      broken.worst != nullptr ? ": " + explain_line(*broken.worst, *first->subject, plan.convention)
                              : ""));
  return found;
}

/// Subjects that crashed or hung so often on a shape that whole families were not put to them. Are
/// there any?
bool tell_unasked(const Plan& plan, const std::vector<Audit>& audits) {
  const auto is_there = [&](const Audit& wanted) {
    return std::any_of(audits.begin(), audits.end(), [&](const Audit& audit) {
      return audit.subject == wanted.subject && audit.family == wanted.family &&
             audit.shape == wanted.shape;
    });
  };
  bool any = false;
  const std::vector<Audit> all = planned(plan);
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const Audit& audit) {
      return audit.subject != first->subject || audit.shape != first->shape;
    });
    std::vector<std::string_view> families;
    for (auto audit = first; audit != last; ++audit)
      if (!is_there(*audit)) families.push_back(audit->family->id);
    any = any || !families.empty();
    if (!families.empty())
      complain(fmt::format("{} was not asked about {}, family {}: it crashed or hung too often",
                           first->subject->name, shape_names[first->shape],
                           fmt::join(families, ", ")));
    first = last;
  }
  return any;
}

/// How many of a kind are told where not all of them were asked for.
constexpr std::size_t shown_unasked = 10;

int told_broken(const Plan& plan, const std::vector<Audit>& audits, bool all) {
  const std::vector<Broken> found_broken = broken(plan.bounds, audits);
  const std::size_t shown =
      all ? found_broken.size() : std::min(found_broken.size(), shown_unasked);
  for (std::size_t i = 0; i < shown; ++i) complain(told(found_broken[i], plan.convention));
  if (const std::size_t more = found_broken.size() - shown; more > 0)
    complain(fmt::format("{} more limit{} broken: --all-findings tells all", more,
                         more == 1 ? " is" : "s are"));
  return found_broken.empty() ? all_held : found;
}

/// A certified verdict that the exact replay does not share is a flaw of ours, not of the subject.
int told_uncertain(const std::vector<Audit>& audits) {
  for (const Audit& audit : audits)
    if (const Certificate& certificate = audit.tally.certificate; certificate.wrong > 0) {
      complain(fmt::format(
          "self-check: {} of {} certified answers of {} on {}, family {}, differ from its exact "
          "replay; rayaudit is at fault: {}",
          certificate.wrong, certificate.compared, audit.subject->name, shape_names[audit.shape],
          audit.family->id, explain_line(*certificate.first_wrong, *audit.subject)));
      return unfit;
    }
  return all_held;
}

void tell_changes(std::string_view what, const std::vector<Change>& changes, bool all) {
  const std::size_t shown = all ? changes.size() : std::min(changes.size(), shown_unasked);
  for (std::size_t i = 0; i < shown; ++i)
    complain(fmt::format("{}: {}: {}", what, told(changes[i]), changes[i].explain));
  if (const std::size_t more = changes.size() - shown; more > 0)
    complain(fmt::format("{}: {} more; --all-findings tells all", what, more));
}

int told_difference(const ReadyEnd& end, const Run& run) {
  if (!end.baseline) return all_held;
  const Difference found_changes = difference(*end.baseline, record_of(run, "this run"));
  require_compared(found_changes);
  tell_changes("broke", found_changes.broke, end.asked.all_findings);
  tell_changes("fixed", found_changes.fixed, end.asked.all_findings);
  complain(fmt::format("--baseline {}: {}", end.baseline->name, summary(found_changes)));
  return found_changes.broke.empty() ? all_held : found;
}

std::string write_observed(const AuditEnd& end, const Run& run) {
  std::vector<std::string> head = {fmt::format(
      "What rayaudit {} observed in {} cases for each subject, shape and family, seed {}",
      run.version, figures::grouped(run.plan.cases), run.plan.seed)};
  if (end.headroom > 1)
    head.push_back(fmt::format(
        "(errors and margins times {}; what may well be chance is left out), by", end.headroom));
  head.push_back("  " + end.command);
  return write_bounds(observed(run.audits, end.headroom), head);
}

/// What is asked for: the table where there is nothing else for standard output.
std::vector<ReportOrder> orders_of(const AuditEnd& end, const Plan& plan) {
  for (const std::string& report : end.reports)
    if (report == "shard" || report.starts_with("shard="))
      throw Error("--report shard=FILE goes with `rayaudit audit --shard i/n`");
  if (!end.reports.empty()) return orders_of(end.reports, reports());
  if (end.written_bounds == "-") return {};
  return orders_of({plan.beside_textbook ? "libraries" : "table"}, reports());
}

/// Where the observed bounds go, as the places of reports are told, if anywhere.
std::optional<std::string> place_of_observed(const AuditEnd& end) {
  if (end.written_bounds.empty()) return std::nullopt;
  return end.written_bounds == "-" ? "" : end.written_bounds;
}

std::optional<Record> baseline_of(const AuditEnd& end, const Plan& plan) {
  if (end.baseline.empty()) return std::nullopt;
  const WholeFile file = read_whole(end.baseline);
  Record record = read_record(file.text, file.name);
  for (const std::string& renaming : end.renamed) rename_subject(record, renaming);
  const std::vector<Audit> none;
  require_same_cases(record, record_of({"", plan, none, {}}, "this run"));
  return record;
}

}  // namespace

void require_compared(const Difference& difference) {
  if (difference.compared == 0)
    throw NothingAudited(
        fmt::format("nothing was compared: `{}` and `{}` have no subject, shape and family in "
                    "common; --map OLD=NEW renames a subject",
                    difference.before.name, difference.after.name));
}

void add_audit_end(CLI::App& command, AuditEnd& end) {
  add_list(command, "--report", "FORMAT[=FILE]",
           "table (the default), json, csv, html, junit or markdown; may be repeated, but one at "
           "most to stdout",
           end.reports);
  add_option(command, "--fail-on", "VERDICT,...",
             "exit 1 where one of these occurs; also max_ulp=N",
             [&end](const std::string& text) { end.fail_on = read_fail_on(text); });
  command.add_flag("--all-findings", end.all_findings,
                   "in the table, of broken bounds and of changes, not only the worst");
  add_option(command, "--save-cases", "FILE",
             "add the minimal case of each finding, with truth and reason; see rayaudit check",
             [&end](const std::string& file) {
               if (file.empty()) throw Error("--save-cases: expected a file");
               end.saved_cases = file;
             });
  CLI::Option* written = add_option(command, "--write-bounds", "FILE",
                                    "write what is observed as rows of bounds; - is stdout",
                                    [&end](const std::string& file) {
                                      if (file.empty())
                                        throw Error("--write-bounds: expected a file");
                                      end.written_bounds = file;
                                    });
  add_number(command, "--headroom",
             "with it: grant errors and margins N times as large, leave out what may be chance", 1,
             1000, [&end](std::int64_t n) { end.headroom = static_cast<int>(n); })
      ->needs(written);
  CLI::Option* baseline =
      add_option(command, "--baseline", "FILE",
                 "exit 1 where something is worse than in this json report of the same cases",
                 [&end](const std::string& file) {
                   if (file.empty()) throw Error("--baseline: expected a file");
                   end.baseline = file;
                 });
  add_list(command, "--map", "OLD=NEW", "with it: a subject that had another name there",
           end.renamed)
      ->needs(baseline);
}

const std::vector<std::string>& audit_end_options() {
  static const std::vector<std::string> names = {"--report",     "--fail-on",      "--all-findings",
                                                 "--save-cases", "--write-bounds", "--headroom",
                                                 "--baseline",   "--map"};
  return names;
}

ReadyEnd ready(const AuditEnd& end, const Plan& plan) {
  const std::vector<ReportOrder> orders = orders_of(end, plan);
  const std::optional<std::string> observed_to = place_of_observed(end);
  std::vector<std::string> files;
  files.reserve(orders.size() + 1);
  for (const ReportOrder& order : orders) files.push_back(order.file);
  if (observed_to) files.push_back(*observed_to);
  if (!end.saved_cases.empty()) files.push_back(end.saved_cases);
  require_places(files);
  if (!end.saved_cases.empty()) require_case_file(end.saved_cases);
  return {end, orders, observed_to, baseline_of(end, plan)};
}

int told(const ReadyEnd& end, const Run& run) {
  if (!end.asked.saved_cases.empty()) save_cases(end.asked.saved_cases, run.audits);
  const bool is_held = !run.plan.bounds.empty() || run.fail_on.asks_anything();
  const int missing = tell_unasked(run.plan, run.audits) && is_held ? found : all_held;
  // Standard output comes last: where its reader has gone, the files are there.
  for (const bool to_stdout : {false, true}) {
    deliver(end.orders, reports(), run, {.everything = end.asked.all_findings}, to_stdout);
    if (end.observed_to && end.observed_to->empty() == to_stdout)
      deliver(*end.observed_to, write_observed(end.asked, run));
  }
  const int breach = told_breach(run.plan, run.audits, run.fail_on);
  const int broken = told_broken(run.plan, run.audits, end.asked.all_findings);
  const int changed = told_difference(end, run);
  return std::max({missing, breach, broken, changed, told_uncertain(run.audits)});
}

}  // namespace rayaudit
