#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rayaudit {

/// A word as a shell takes it for itself.
std::string quoted(const std::string& word);

/// The command line that a command was read from, as a shell takes it, without some options.
std::string command_text(const CLI::App& command, const std::vector<std::string>& without = {});

}  // namespace rayaudit
