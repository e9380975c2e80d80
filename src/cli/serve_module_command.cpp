#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "cli/command.hpp"
#include "cli/exit_code.hpp"
#include "subjects/serve_module.hpp"

namespace rayaudit {

/// What the program asks of itself (subjects/module_child.hpp); no person does.
void add_serve_module_command(CLI::App& program, Command& asked) {
  const auto module = std::make_shared<std::string>();
  CLI::App* command = program.add_subcommand("serve-module", "Answer for a module");
  command->group("");  // in no list of commands
  command->add_option("MODULE", *module)->required();
  command->callback([=, &asked] {
    asked = [module] {
      serve_module(module->c_str());
      return all_held;
    };
  });
}

}  // namespace rayaudit
