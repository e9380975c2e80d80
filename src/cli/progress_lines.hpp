#pragma once

#include <chrono>

#include "audit/audit.hpp"

namespace rayaudit {

/// A line on standard error for each tenth of a run that takes long: for mpirun passes on lines,
/// and no terminal.
class ProgressLines {
 public:
  void tell(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  Clock::time_point start_ = Clock::now();
  int told_ = 0;  ///< tenths
};

}  // namespace rayaudit
