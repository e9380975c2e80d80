#include <chrono>
#include <csignal>
#include <thread>

#include "cli/command.hpp"
#include "cli/command_line.hpp"
#include "cli/output.hpp"
#include "cli/ranks.hpp"
#include "cli/refusal.hpp"
#include "oracle/self_check.hpp"

namespace {

int told(const rayaudit::Refusal& why) {
  if (why.sentence.empty()) return why.code;
  if (rayaudit::is_first_rank()) {
    rayaudit::complain(why.sentence);
  } else {
    // What every rank refuses the first one tells, whose end is that of all.
    std::this_thread::sleep_for(std::chrono::seconds(2));
    rayaudit::complain(rayaudit::told_by_rank(why.sentence));
  }
  return why.code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rayaudit;
  std::signal(SIGPIPE, SIG_DFL);  // a reader that closes its pipe early ends us silently
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is then an error like any other
  try {
    const Command command = read_command_line(argc, argv);
    if (const auto flaw = oracle::self_check()) throw Refusal{unfit, *flaw};
    return command();
  } catch (...) {
    return told(caught_refusal());
  }
}
