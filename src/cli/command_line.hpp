#pragma once

#include "cli/command.hpp"

namespace rayaudit {

/// What the command line asks for; throws Error where it makes no sense.
Command read_command_line(int argc, const char* const* argv);

}  // namespace rayaudit
