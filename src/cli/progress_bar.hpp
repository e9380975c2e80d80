#pragma once

#include <chrono>
#include <string_view>

#include "audit/audit.hpp"

namespace rayaudit {

/// One line on standard error that tells how far a run has come, how fast it goes and how long it
/// will yet take; gone when the run is. Nothing unless standard error is a terminal.
class ProgressBar {
 public:
  explicit ProgressBar(std::string_view what = "cases");  ///< that are counted
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  void tell(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  std::string_view what_;
  bool shown_;
  Clock::time_point start_ = Clock::now(), last_ = start_;
};

}  // namespace rayaudit
