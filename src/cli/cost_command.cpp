#include "audit/cost.hpp"
#include "cli/command.hpp"
#include "cli/command_text.hpp"
#include "cli/exit_code.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/progress_bar.hpp"
#include "cli/report_order.hpp"
#include "cli/selection.hpp"
#include "geometry/error.hpp"

namespace rayaudit {
namespace {

constexpr std::int64_t default_cases = 4'096, default_rounds = 15;

struct CostOptions {
  SubjectChoice subjects;
  std::vector<std::string> shapes, families, reports;
  CostPlan plan;
  Look look;
  std::string command;  ///< all of this as it was typed
};

CostPlan plan_of(const CostOptions& options, const Subjects& subjects) {
  CostPlan plan = options.plan;
  // Every way to answer where none is named: what is audited by name only takes part too.
  plan.subjects = subjects.selected(options.subjects, Subjects::Unnamed::every);
  for (const std::size_t i :
       selected("family", options.families, names_of(families(), &Family::id)))
    // Invalid cases are no question of accuracy: they take part where they are named.
    if (!options.families.empty() || families()[i].id != "invalid")
      plan.families.push_back(&families()[i]);
  plan.shapes = selected("shape", options.shapes, shape_names);
  return plan;
}

/// A subject that could not be timed is a finding.
int told_untimed(const Cost& cost) {
  for (const Untimed& each : cost.untimed) complain(each.why);
  return cost.untimed.empty() ? all_held : found;
}

int cost(const CostOptions& options) {
  if (!options.subjects.program.empty())
    throw Error(
        "cost: --program: what a program takes is mostly to be started and to read and write text, "
        "so it has no time by the case; bring the routine as a plugin (--plugin)");
  const Subjects subjects(options.subjects);
  const CostPlan plan = plan_of(options, subjects);
  const auto orders = orders_of(options.reports, cost_reports());
  require_places(orders);
  Cost measured;
  {
    ProgressBar bar;
    measured = measure(plan, [&](const Progress& progress) { bar.tell(progress); });
  }
  const int untimed = told_untimed(measured);
  if (measured.cells.empty() && untimed == all_held)
    throw NothingAudited(
        "nothing to measure: no chosen subject answers a chosen shape that a chosen family draws");
  const CostRun run = {RAYAUDIT_VERSION, plan, measured, environment(), options.command};
  for (const bool to_stdout : {false, true})
    deliver(orders, cost_reports(), run, options.look, to_stdout);
  return untimed;
}

void add_names(CLI::App& command, const std::shared_ptr<CostOptions>& options) {
  add_subjects_and_shapes(command, options->subjects, options->shapes);
  // They are known only to be refused.
  for (const char* of_programs : {"--program", "--format"})
    command.get_option(of_programs)->group("");
  add_list(command, "--family", "FAMILY,...", "names or globs; else all but invalid",
           options->families)
      ->delimiter(',');
  add_list(command, "--report", "FORMAT[=FILE]",
           "table (the default), json or html; may be repeated, but one at most to stdout",
           options->reports);
}

void add_numbers(CLI::App& command, const std::shared_ptr<CostOptions>& options) {
  CostPlan& plan = options->plan;
  add_number(command, "--cases", "to judge each way by, of each shape and family", 1, largest_cases,
             [&plan](std::int64_t n) { plan.cases = static_cast<std::uint64_t>(n); })
      ->default_str(std::to_string(default_cases));
  add_number(command, "--rounds", "of timing; each takes all ways in turn", 3, 10'000,
             [&plan](std::int64_t n) { plan.rounds = static_cast<int>(n); })
      ->default_str(std::to_string(default_rounds));
  add_seed(command, plan.seed);
  add_number(command, "--threads", "to judge on; timing takes one", 1, 1024,
             [&plan](std::int64_t n) { plan.threads = static_cast<int>(n); });
}

}  // namespace

void add_cost_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<CostOptions>();
  options->plan.cases = default_cases;
  options->plan.rounds = default_rounds;
  options->plan.seed = default_seed;
  CLI::App* command =
      program.add_subcommand("cost", "Measure what every way to answer costs, and how right it is");
  add_names(*command, options);
  add_numbers(*command, options);
  command->add_flag("--all-ways", options->look.everything, "not only those on the front");
  command->add_flag("--each-family", options->look.families, "each family alone too");
  command->footer(
      "Without names, every subject there is takes part, also those that an audit has by name\n"
      "only; libraries only where they are named, as 'embree/*'. All answer the same cases, dear "
      "ones fewer, drawn as floats, in turn, on one "
      "processor.\n\n"
      "Examples:\n"
      "  rayaudit cost\n"
      "  rayaudit cost --shape sphere --family grazing --all-ways\n"
      "  rayaudit cost '*/float' '*/double' --report table --report html=cost.html\n");
  command->callback([=, &asked] {
    options->command = command_text(*command);
    if (options->reports.empty()) options->reports = {"table"};
    asked = [options] { return cost(*options); };
  });
}

}  // namespace rayaudit
