#pragma once

#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <cstring>
#include <string>

#include "geometry/signal_name.hpp"

/// How another process ended, in words that go on a sentence about it.
namespace rayaudit {

/// The signal that ended it, or 0. A shell tells of what it ran that it died of signal n by exit
/// code 128 + n.
inline int signal_of(int status) {
  if (WIFSIGNALED(status)) return WTERMSIG(status);
  const int signal = WEXITSTATUS(status) - 128;
  return signal > 0 && sigabbrev_np(signal) != nullptr ? signal : 0;
}

/// The end that a status of waitpid tells of.
inline std::string told_end(int status) {
  const int signal = signal_of(status);
  if (signal == 0 && WIFEXITED(status))
    return "ended with exit code " + std::to_string(WEXITSTATUS(status));
  return "was killed by " + signal_name(signal) +
         (signal == SIGILL ? ", an instruction that this processor may not have" : "");
}

inline std::string seconds(std::chrono::milliseconds time) {
  std::string text = std::to_string(static_cast<double>(time.count()) / 1000);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

}  // namespace rayaudit
