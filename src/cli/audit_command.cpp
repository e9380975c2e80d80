#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "audit/audit.hpp"
#include "cli/bounds_option.hpp"
#include "cli/command.hpp"
#include "cli/command_text.hpp"
#include "cli/convention_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/fail_on.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/progress_bar.hpp"
#include "cli/report_order.hpp"
#include "cli/selection.hpp"
#include "geometry/error.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

constexpr std::int64_t default_cases = 10'000;

Plan default_plan() {
  Plan plan;
  plan.cases = default_cases;
  plan.seed = default_seed;
  return plan;
}

struct AuditOptions {
  std::vector<std::string> subjects, shapes, families, reports, bounds;
  Plan plan = default_plan();
  FailOn fail_on;
  std::string written_bounds;  ///< the file for what is observed, or empty
  std::string command;         ///< all of this as it was typed
  int headroom = 1;
  bool all_findings = false;
};

/// A difficulty must be one of every family that has any, in every format it will be drawn in.
void require_difficulty(const std::vector<Audit>& audits, int difficulty) {
  bool any = false;
  for (const Audit& audit : audits) {
    if (!audit.family->difficulty) continue;
    any = true;
    rayaudit::require_difficulty(*audit.family, audit.subject->drawn_in(), difficulty);
  }
  if (!any) throw Error("--difficulty: no family chosen has a difficulty");
}

Plan plan_of(const AuditOptions& options) {
  Plan plan = options.plan;
  plan.subjects = selected_subjects(options.subjects);
  for (const std::size_t i :
       selected("family", options.families, names_of(families(), &Family::id)))
    plan.families.push_back(&families()[i]);
  plan.shapes = selected("shape", options.shapes, shape_names);
  for (const std::string& file : options.bounds)
    for (const Bound& bound : read_bounds_file(file)) plan.bounds.push_back(bound);
  const std::vector<Audit> audits = planned(plan);
  if (audits.empty())
    throw NothingAudited(
        plan.bounds.empty()
            ? "nothing to audit: no chosen subject answers a chosen shape that a chosen family "
              "draws"
            : "nothing was held: no row of " + fmt::format("{}", fmt::join(options.bounds, ", ")) +
                  " is about a chosen subject, shape and family");
  if (plan.difficulty) require_difficulty(audits, *plan.difficulty);
  return plan;
}

std::vector<Audit> run_with_progress(const Plan& plan) {
  ProgressBar bar;
  return run(plan, [&](const Progress& progress) { bar.tell(progress); });
}

int told_breach(const Plan& plan, const std::vector<Audit>& audits, const FailOn& fail_on) {
  const auto breaks = [&](const Audit& audit) { return breach(fail_on, audit.tally).has_value(); };
  const auto first = std::find_if(audits.begin(), audits.end(), breaks);
  if (first == audits.end()) return all_held;
  const Breach broken = *breach(fail_on, first->tally);
  const auto others = std::count_if(first + 1, audits.end(), breaks);
  complain(fmt::format(
      "--fail-on: {} on {}, family {}: {}{}: {}", first->subject->name, shape_names[first->shape],
      first->family->id, broken.words,
      others > 0 ? fmt::format(" (and {} more audit{})", others, others == 1 ? " fails" : "s fail")
                 : "",
      explain_line(broken.worst, *first->subject, plan.convention)));
  return found;
}

/// How many broken limits are told where not all of them were asked for.
constexpr std::size_t broken_shown = 10;

int told_broken(const Plan& plan, const std::vector<Audit>& audits, bool all) {
  const std::vector<Broken> found_broken = broken(plan.bounds, audits);
  const std::size_t shown = all ? found_broken.size() : std::min(found_broken.size(), broken_shown);
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

std::string write_observed(const AuditOptions& options, const std::vector<Audit>& audits) {
  std::vector<std::string> head = {fmt::format(
      "What rayaudit {} observed in {} cases for each subject, shape and family, seed {}",
      RAYAUDIT_VERSION, figures::grouped(options.plan.cases), options.plan.seed)};
  if (options.headroom > 1)
    head.push_back(
        fmt::format("(errors and margins times {}; what may well be chance is left out), by",
                    options.headroom));
  head.push_back("  " + options.command);
  return write_bounds(observed(audits, options.headroom), head);
}

/// What is asked for: the table where there is nothing else for standard output.
std::vector<ReportOrder> orders_of(const AuditOptions& options) {
  if (!options.reports.empty()) return orders_of(options.reports, reports());
  if (options.written_bounds == "-") return {};
  return orders_of({"table"}, reports());
}

/// Where the observed bounds go, as the places of reports are told, if anywhere.
std::optional<std::string> place_of_observed(const AuditOptions& options) {
  if (options.written_bounds.empty()) return std::nullopt;
  return options.written_bounds == "-" ? "" : options.written_bounds;
}

int audit(const AuditOptions& options) {
  const Plan plan = plan_of(options);
  const std::vector<ReportOrder> orders = orders_of(options);
  const std::optional<std::string> observed_to = place_of_observed(options);
  std::vector<std::string> files;
  files.reserve(orders.size() + 1);
  for (const ReportOrder& order : orders) files.push_back(order.file);
  if (observed_to) files.push_back(*observed_to);
  require_places(files);
  const std::vector<Audit> audits = run_with_progress(plan);
  const Run run = {RAYAUDIT_VERSION, plan, audits, environment(), options.command};
  // Standard output comes last: where its reader has gone, the files are there.
  for (const bool to_stdout : {false, true}) {
    deliver(orders, reports(), run, {.everything = options.all_findings}, to_stdout);
    if (observed_to && observed_to->empty() == to_stdout)
      deliver(*observed_to, write_observed(options, audits));
  }
  const int breach = told_breach(plan, audits, options.fail_on);
  const int broken = told_broken(plan, audits, options.all_findings);
  return std::max({breach, broken, told_uncertain(audits)});
}

void add_names(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_subjects_and_shapes(command, options->subjects, options->shapes);
  add_list(command, "--family", "FAMILY,...", "names or globs", options->families)->delimiter(',');
  add_list(command, "--report", "FORMAT[=FILE]",
           "table (the default), json, csv or html; may be repeated, but one at most to stdout",
           options->reports);
}

void add_numbers(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_number(command, "--cases", "for each subject, shape and family; 1e6 and 100k will do", 1,
             largest_cases,
             [=](std::int64_t n) { options->plan.cases = static_cast<std::uint64_t>(n); })
      ->default_str(std::to_string(default_cases));
  add_seed(command, options->plan.seed);
  add_number(
      command, "--difficulty",
      "draw at difficulty K (see rayaudit list families); default: spread over each family's range",
      INT32_MIN, INT32_MAX, [=](std::int64_t n) { options->plan.difficulty = static_cast<int>(n); })
      ->type_name("K");
  add_number(command, "--threads", "else one for each processor; the findings are the same", 1,
             1024, [=](std::int64_t n) { options->plan.threads = static_cast<int>(n); });
}

void add_judgement(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_option(command, "--convention", "KIND=STANCE,...",
             "what the subjects declare of touches, as tangent=hit,rim=miss",
             [=](const std::string& text) { options->plan.convention = read_convention(text); });
  add_option(command, "--fail-on", "VERDICT,...",
             "exit 1 where one of these occurs; also max_ulp=N",
             [=](const std::string& text) { options->fail_on = read_fail_on(text); });
  command.add_flag("--thorough", options->plan.thorough,
                   "margins, proofs and causes of every case, not of a share");
  command.add_flag("--all-findings", options->all_findings,
                   "in the table and of broken bounds, not only the worst");
}

void add_bounds(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_list(command, "--bounds", "FILE",
           "exit 1 where a row of the file is broken; only what its rows name is audited; may be "
           "repeated",
           options->bounds);
  CLI::Option* written = add_option(command, "--write-bounds", "FILE",
                                    "write what is observed as such rows; - is standard output",
                                    [=](const std::string& file) {
                                      if (file.empty())
                                        throw Error("--write-bounds: expected a file");
                                      options->written_bounds = file;
                                    });
  add_number(command, "--headroom",
             "with it: grant errors and margins N times as large, leave out what may be chance", 1,
             1000, [=](std::int64_t n) { options->headroom = static_cast<int>(n); })
      ->needs(written);
}

}  // namespace

void add_audit_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<AuditOptions>();
  CLI::App* command = program.add_subcommand(
      "audit", "Hold subjects against the exact truth and tell what is wrong");
  add_names(*command, options);
  add_numbers(*command, options);
  add_judgement(*command, options);
  add_bounds(*command, options);
  command->footer(
      "Without names, every subject, shape and family is audited. A subject that is wrong is a\n"
      "finding, not a failure: the exit code is 0 unless --fail-on or --bounds says otherwise.\n\n"
      "Each row of a file of bounds is a promise: SUBJECT SHAPE FAMILY, names or globs; limits "
      "and\n"
      "their values; and whether it is proved or only observed, as in\n"
      "  textbook/float sphere anywhere wrong 0 max_ulp 8 observed  # a comment\n"
      "Limits: wrong, or one wrong verdict, in cases; max_ulp; max_forced; wrong_margin, in u.\n\n"
      "Examples:\n"
      "  rayaudit audit\n"
      "  rayaudit audit 'textbook/*' --shape sphere --family grazing,far --cases 1e6\n"
      "  rayaudit audit '*/float' --report table --report json=audit.json\n"
      "  rayaudit audit stable_quadratic/double --fail-on false_hit,false_miss,max_ulp=100\n"
      "  rayaudit audit 'textbook/*' --cases 1e6 --headroom 2 --write-bounds mine.txt\n"
      "  rayaudit audit --bounds mine.txt --seed 2\n");
  command->callback([=, &asked] {
    options->command = command_text(*command);
    asked = [options] { return audit(*options); };
  });
}

}  // namespace rayaudit
