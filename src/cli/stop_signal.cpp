#include "cli/stop_signal.hpp"

namespace rayaudit {
namespace {

std::atomic<bool> stopped = false;
static_assert(std::atomic<bool>::is_always_lock_free, "a signal handler may set it");

void note(int) { stopped = true; }

}  // namespace

StopSignal::StopSignal() {
  stopped = false;
  struct sigaction noting = {};
  noting.sa_handler = note;
  noting.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &noting, &interrupt_);
  sigaction(SIGTERM, &noting, &terminate_);
}

StopSignal::~StopSignal() {
  sigaction(SIGINT, &interrupt_, nullptr);
  sigaction(SIGTERM, &terminate_, nullptr);
}

const std::atomic<bool>& StopSignal::flag() const { return stopped; }

}  // namespace rayaudit
