#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace rayaudit {

/// How a shell command ended that was run once.
struct ProgramEnd {
  bool is_hung = false;  ///< it neither took nor said anything for too long, and was killed
  bool is_fed = false;   ///< it took all that it was given
  int status = 0;        ///< as waitpid has it, of a command that ended by itself
};

/// Runs a command by /bin/sh. The text is its standard input, and what it prints is handed to take,
/// piece by piece, while it still reads; patience begins anew with each progress in either
/// direction. Returns when it has ended and its output with it. Whatever the command started in its
/// group of processes has then ended too, also where take throws; should our own process end, it
/// does so with that. From any thread. Throws NoAnswer where the system refuses.
ProgramEnd run_program(const std::string& command, std::string_view text,
                       std::chrono::milliseconds patience,
                       const std::function<void(std::string_view)>& take);

}  // namespace rayaudit
