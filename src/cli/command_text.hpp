#pragma once

#include <string>

namespace CLI {
class App;
}

namespace rayaudit {

/// The command line that a command was read from, as a shell takes it.
std::string command_text(const CLI::App& command);

}  // namespace rayaudit
