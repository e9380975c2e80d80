#pragma once

#include <csignal>
#include <cstring>
#include <string>

namespace rayaudit {

/// SIGSEGV, of its number.
inline std::string signal_name(int signal) {
  const char* name = sigabbrev_np(signal);
  return name != nullptr ? std::string("SIG") + name : "signal " + std::to_string(signal);
}

}  // namespace rayaudit
