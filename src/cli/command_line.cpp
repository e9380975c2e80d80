#include "cli/command_line.hpp"

#include <CLI/CLI.hpp>

#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "cli/ranks.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

/// The command that was asked for, or the program where there is none yet.
const CLI::App& asked_of(const CLI::App& program) {
  const auto commands = program.get_subcommands();
  return commands.empty() ? program : *commands.front();
}

/// The commands that a person may ask for.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

std::vector<std::string> known_words(const CLI::App& app) {
  std::vector<std::string> words;
  for (const CLI::App* command : commands_of(app)) words.push_back(command->get_name());
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
  return words;
}

/// The sentence about a word that neither a command nor an option is.
std::string unknown_word(const CLI::App& app, const std::string& word) {
  const std::vector<std::string> words = known_words(app);
  const bool is_option = word.starts_with("-");
  std::vector<std::string_view> known;
  for (const std::string& each : words)
    if (each.starts_with("-") == is_option) known.emplace_back(each);
  if (known.empty()) return app.get_name() + ": " + quotation(word) + " was not expected";
  return unknown_name(is_option ? "option" : "command", word, known);
}

std::string expected_command(const CLI::App& program) {
  std::string commands;
  for (const CLI::App* command : commands_of(program))
    commands += (commands.empty() ? "" : ", ") + command->get_name();
  return "expected a command, one of " + commands + "; `rayaudit --help` tells more";
}

std::string sentence(const CLI::App& program, const CLI::ParseError& fault) {
  const CLI::App& app = asked_of(program);
  for (const CLI::App* each : {&program, &app})
    if (const auto left = each->remaining(); !left.empty())
      return unknown_word(*each, left.front());
  if (&app == &program) return expected_command(program);
  return app.get_name() + ": " + fault.what();
}

Command printing(std::string text) {
  return [text = std::move(text)] {
    if (is_first_rank()) print(text);
    return all_held;
  };
}

/// Only an audit is spread over the processes that mpirun starts.
void require_one_process(const CLI::App& command) {
  if (ranks_started() > 1 && command.get_name() != "audit")
    throw Error("mpirun is for `rayaudit audit`: start `rayaudit " + command.get_name() +
                "` without it");
}

void describe(CLI::App& program) {
  program.require_subcommand(1);
  program.set_version_flag("--version", "rayaudit " RAYAUDIT_VERSION);
  program.get_formatter()->column_width(34);
  program.footer(
      "Examples:\n"
      "  rayaudit audit\n"
      "  rayaudit audit 'textbook/*' --shape sphere --family grazing\n"
      "  rayaudit explain 'sphere 0 0 0 1 ray 0 0 -3 0 0 1'\n"
      "  rayaudit draw --shape sphere --family far --count 1e5 | ./mine | rayaudit judge\n\n"
      "`rayaudit COMMAND --help` tells more. Exit codes: 0 all bounds held, 1 a finding,\n"
      "2 a mistake on the command line or in a file, 3 this machine's arithmetic is unfit,\n"
      "4 nothing was audited.\n");
}

}  // namespace

Command read_command_line(int argc, const char* const* argv) {
  CLI::App program("Where ray-intersection code is wrong, by how much: judged by exact arithmetic",
                   "rayaudit");
  Command asked;
  describe(program);
  add_audit_command(program, asked);
  add_check_command(program, asked);
  add_cost_command(program, asked);
  add_ladder_command(program, asked);
  add_scene_command(program, asked);
  add_explain_command(program, asked);
  add_draw_command(program, asked);
  add_truth_command(program, asked);
  add_judge_command(program, asked);
  add_diff_command(program, asked);
  add_merge_command(program, asked);
  add_list_command(program, asked);
  add_serve_plugin_command(program, asked);
  try {
    program.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return printing(program.help());
  } catch (const CLI::CallForVersion& version) {
    return printing(std::string(version.what()) + "\n");
  } catch (const CLI::ParseError& fault) {
    throw Error(sentence(program, fault));
  }
  require_one_process(asked_of(program));
  return asked;
}

}  // namespace rayaudit
