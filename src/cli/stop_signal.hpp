#pragma once

#include <atomic>
#include <csignal>

namespace rayaudit {

/// While it stands, Ctrl-C and SIGTERM end nothing but are taken note of; the second of a kind ends
/// the program as ever. One at a time.
class StopSignal {
 public:
  StopSignal();
  ~StopSignal();
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;

  /// Is set once a signal has come.
  const std::atomic<bool>& flag() const;

 private:
  struct sigaction interrupt_ = {}, terminate_ = {};  ///< what stood before
};

}  // namespace rayaudit
