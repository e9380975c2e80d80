#include "cli/audit_end.hpp"
#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "cli/option.hpp"
#include "cli/report_order.hpp"
#include "cli/whole_file.hpp"
#include "reports/difference.hpp"

namespace rayaudit {
namespace {

struct DiffOptions {
  std::string before, after;
  std::vector<std::string> renamed, reports = {"table"};
  bool all_findings = false;
};

Record record_in(const std::string& path) {
  const WholeFile file = read_whole(path);
  return read_record(file.text, file.name);
}

int diff(const DiffOptions& options) {
  const std::vector<ReportOrder> orders = orders_of(options.reports, difference_reports());
  require_places(orders);
  Record before = record_in(options.before);
  for (const std::string& renaming : options.renamed) rename_subject(before, renaming);
  const Difference found_changes = difference(std::move(before), record_in(options.after));
  require_compared(found_changes);
  for (const bool to_stdout : {false, true})
    deliver(orders, difference_reports(), found_changes, {.everything = options.all_findings},
            to_stdout);
  return found_changes.broke.empty() ? all_held : found;
}

}  // namespace

void add_diff_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<DiffOptions>();
  CLI::App* command = program.add_subcommand(
      "diff", "Hold one audit against an earlier one of the same cases: what broke, what is fixed");
  command->add_option("OLD", options->before, "a json report of an audit")
      ->type_name("")
      ->required();
  command->add_option("NEW", options->after, "another, of the same cases")
      ->type_name("")
      ->required();
  add_list(*command, "--map", "OLD=NEW", "a subject that had another name in the old report",
           options->renamed);
  add_list(*command, "--report", "FORMAT[=FILE]",
           "table (the default), json or markdown; may be repeated, but one at most to stdout",
           options->reports);
  command->add_flag("--all-findings", options->all_findings,
                    "in markdown, not only the first of each kind");
  command->footer(
      "Exit code 1 where something broke: a wrong verdict that is more frequent than it was, or "
      "of\n"
      "other cases, or the largest error of a subject, shape and family more than twice what it\n"
      "was. What is gone or new is told and is no failure.\n\n"
      "Examples:\n"
      "  rayaudit audit '*/float' --report json=old.json\n"
      "  rayaudit diff old.json new.json\n"
      "  rayaudit diff old.json new.json --map mine/float=mine2/float --report markdown\n"
      "  rayaudit audit '*/float' --baseline old.json\n");
  command->callback([=, &asked] { asked = [options] { return diff(*options); }; });
}

}  // namespace rayaudit
