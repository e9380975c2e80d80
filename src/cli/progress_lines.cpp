#include "cli/progress_lines.hpp"

#include <fmt/format.h>

#include "cli/output.hpp"

namespace rayaudit {

void ProgressLines::tell(const Progress& progress) {
  constexpr double long_run = 10;  // seconds
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.all);
  const int tenths = static_cast<int>(10 * share);
  const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
  if (tenths <= told_ || tenths > 9 || seconds < long_run) return;
  told_ = tenths;
  complain(fmt::format("{} % of the cases are judged, about {:.0f} s left", 10 * tenths,
                       seconds * (1 - share) / share));
}

}  // namespace rayaudit
