#include "cli/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "cli/output.hpp"

namespace rayaudit {
namespace {

constexpr std::chrono::milliseconds pause(100);
constexpr std::string_view start_of_cleared_line = "\r\033[K";

void draw(std::string_view text) { fmt::print(stderr, "{}{}", start_of_cleared_line, text); }

}  // namespace

ProgressBar::ProgressBar(std::string_view what) : what_(what), shown_(is_terminal(STDERR_FILENO)) {}

ProgressBar::~ProgressBar() {
  if (shown_) draw("");
}

void ProgressBar::tell(const Progress& progress) {
  constexpr int width = 30;
  const Clock::time_point now = Clock::now();
  if (!shown_ || now - last_ < pause || progress.done == 0) return;
  last_ = now;
  const double seconds = std::chrono::duration<double>(now - start_).count();
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.all);
  const double thousands = static_cast<double>(progress.done) / seconds / 1000;
  draw(fmt::format("[{:<{}}] {:3.0f} %  {:.0f} k {}/s  {:.0f} s left",
                   std::string(static_cast<std::size_t>(share * width), '='), width, 100 * share,
                   thousands, what_, seconds * (1 - share) / share));
}

}  // namespace rayaudit
