#include "cli/output.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>

#include "cli/ranks.hpp"
#include "geometry/error.hpp"

namespace rayaudit {

void print(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(STDOUT_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0)
      throw Error(std::string("standard output cannot be written: ") + std::strerror(errno));
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void complain(std::string_view sentence) {
  const std::string line = "rayaudit: " + std::string(sentence) + "\n";
  if (write(STDERR_FILENO, line.data(), line.size()) < 0) return;  // nobody left to tell
}

bool is_terminal(int descriptor) { return isatty(descriptor) != 0; }

bool is_colour_welcome() {
  if (ranks_started() > 1) return false;  // what mpirun shows us is no sign of where it leads
  const char* no_colour = std::getenv("NO_COLOR");
  return is_terminal(STDOUT_FILENO) && (no_colour == nullptr || *no_colour == '\0');
}

}  // namespace rayaudit
