#pragma once

#include <string>

#include "cli/exit_code.hpp"

namespace rayaudit {

/// Why the program ends without what it was asked for: the sentence that it says, if there is one
/// left to say, and its exit code.
struct Refusal {
  ExitCode code;
  std::string sentence;
};

/// What the exception means that is being handled.
Refusal caught_refusal();

}  // namespace rayaudit
