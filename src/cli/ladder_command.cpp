#include <fmt/format.h>

#include "audit/ladder.hpp"
#include "cli/bounds_option.hpp"
#include "cli/command.hpp"
#include "cli/command_text.hpp"
#include "cli/exit_code.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/progress_bar.hpp"
#include "cli/report_order.hpp"
#include "cli/selection.hpp"
#include "geometry/error.hpp"

namespace rayaudit {
namespace {

constexpr std::int64_t default_cases = 1'024;
constexpr const char* default_family = "grazing";

struct LadderOptions {
  SubjectChoice subjects;
  std::vector<std::string> shapes, reports, bounds;
  std::string family = default_family;
  LadderPlan plan;
  Look look;
  std::string command;  ///< all of this as it was typed
};

const Family& family_with_difficulty(const std::string& id) {
  const Family& family = families()[place_of("family", id, names_of(families(), &Family::id))];
  if (family.difficulty) return family;
  std::string others;
  for (const Family& each : families())
    if (each.difficulty) (others += others.empty() ? "" : ", ") += each.id;
  throw Error(
      fmt::format("family `{}` has no difficulty to rise; those that have: {}", id, others));
}

LadderPlan plan_of(const LadderOptions& options, Subjects& subjects) {
  LadderPlan plan = options.plan;
  plan.family = &family_with_difficulty(options.family);
  plan.subjects = subjects.selected(options.subjects);
  plan.shapes = selected("shape", options.shapes, shape_names);
  for (const std::string& file : options.bounds)
    for (const Bound& bound : read_bounds_file(file, subjects)) plan.bounds.push_back(bound);
  return plan;
}

/// Who was held to a file of bounds, and broke one, is a finding.
int told_broken(const LadderPlan& plan, const std::vector<Climb>& climbs) {
  if (plan.bounds.empty()) return all_held;
  int code = all_held;
  for (const Climb& climb : climbs) {
    const bool is_held = !climb.held_to.front().place.empty();
    if (!is_held || !climb.broken) continue;
    complain(told(*climb.broken, climb, *plan.family));
    code = found;
  }
  return code;
}

int ladder(const LadderOptions& options) {
  Subjects subjects(options.subjects);
  const LadderPlan plan = plan_of(options, subjects);
  const auto orders = orders_of(options.reports, ladder_reports());
  require_places(orders);
  std::vector<Climb> climbs;
  {
    ProgressBar bar;
    climbs = climb(plan, [&](const Progress& progress) { bar.tell(progress); });
  }
  if (climbs.empty())
    throw NothingAudited("nothing to climb: no chosen subject answers a chosen shape that family " +
                         options.family + " draws");
  const LadderRun run = {RAYAUDIT_VERSION, plan, climbs, environment(), options.command};
  for (const bool to_stdout : {false, true})
    deliver(orders, ladder_reports(), run, options.look, to_stdout);
  return told_broken(plan, climbs);
}

void add_choice(CLI::App& command, const std::shared_ptr<LadderOptions>& options) {
  add_subjects_and_shapes(command, options->subjects, options->shapes);
  command.add_option("--family", options->family, "one that has a difficulty")
      ->type_name("FAMILY")
      ->default_str(default_family);
  add_list(command, "--bounds", "FILE",
           "hold subjects to its rows, and exit 1 where one is broken; else to a yardstick",
           options->bounds);
  add_list(command, "--report", "FORMAT[=FILE]",
           "table (the default), json or html; may be repeated, but one at most to stdout",
           options->reports);
  command.add_flag("--breaks", options->look.everything,
                   "in the table, the case that each subject breaks at first");
}

void add_numbers(CLI::App& command, const std::shared_ptr<LadderOptions>& options) {
  LadderPlan& plan = options->plan;
  add_number(command, "--cases", "for each subject and shape at each k", 1, largest_cases,
             [&plan](std::int64_t n) { plan.cases = static_cast<std::uint64_t>(n); })
      ->default_str(std::to_string(default_cases));
  add_seed(command, plan.seed);
  add_number(command, "--threads", "else one for each processor; the findings are the same", 1,
             1024, [&plan](std::int64_t n) { plan.threads = static_cast<int>(n); });
}

}  // namespace

void add_ladder_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<LadderOptions>();
  options->plan.cases = default_cases;
  options->plan.seed = default_seed;
  CLI::App* command = program.add_subcommand(
      "ladder", "Let one family get harder until the format gives out, and see who holds");
  add_choice(*command, options);
  add_numbers(*command, options);
  command->footer(
      "Examples:\n"
      "  rayaudit ladder\n"
      "  rayaudit ladder 'textbook/*' 'certified/*' --family far --shape sphere --breaks\n"
      "  rayaudit ladder --bounds data/bounds/robust.txt --report html=ladder.html\n");
  command->callback([=, &asked] {
    options->command = command_text(*command);
    if (options->reports.empty()) options->reports = {"table"};
    asked = [options] { return ladder(*options); };
  });
}

}  // namespace rayaudit
