#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "subjects/serve_plugin.hpp"

namespace rayaudit {

/// What the program asks of itself (subjects/plugin_child.hpp); no person does.
void add_serve_plugin_command(CLI::App& program, Command& asked) {
  const auto plugin = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("serve-plugin", "Answer for a plugin");
  command->group("");  // in no list of commands
  command->add_option("PLUGIN", *plugin)->required();
  command->callback([=, &asked] {
    asked = [plugin] {
      serve_plugin(plugin->c_str());
      return all_held;
    };
  });
}

}  // namespace rayaudit
