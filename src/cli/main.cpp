#include <csignal>
#include <exception>
#include <new>
#include <string>

#include "cli/command.hpp"
#include "cli/command_line.hpp"
#include "cli/exit_code.hpp"
#include "cli/output.hpp"
#include "geometry/error.hpp"
#include "oracle/environment.hpp"
#include "oracle/self_check.hpp"
#include "subjects/subject.hpp"

namespace {

int complained(std::string_view sentence, rayaudit::ExitCode code) {
  rayaudit::complain(sentence);
  return code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace rayaudit;
  std::signal(SIGPIPE, SIG_DFL);  // a reader that closes its pipe early ends us silently
  std::signal(SIGXFSZ, SIG_IGN);  // a file at its limit is then an error like any other
  try {
    const Command command = read_command_line(argc, argv);
    if (const auto flaw = oracle::self_check()) return complained(*flaw, unfit);
    return command();
  } catch (const Error& mistake) {
    return complained(mistake.what(), mistaken);
  } catch (const NothingAudited& why) {
    return complained(why.what(), nothing_audited);
  } catch (const NoAnswer& why) {
    return complained(why.what(), found);
  } catch (const oracle::UnfitArithmetic& flaw) {
    return complained(flaw.what(), unfit);
  } catch (const std::bad_alloc&) {
    return complained("there is not enough memory", mistaken);
  } catch (const std::exception& fault) {
    return complained(std::string("the system refused: ") + fault.what(), mistaken);
  }
}
