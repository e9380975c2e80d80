#pragma once

#include <stdexcept>

namespace rayaudit {

/// What the program tells its caller when it ends. Never a count.
enum ExitCode : int {
  all_held = 0,         ///< every bound held
  found = 1,            ///< a finding
  mistaken = 2,         ///< the user's mistake
  unfit = 3,            ///< a self-check failed: rayaudit itself is at fault
  nothing_audited = 4,  ///< known names that leave no audit
};

/// Names that are known, or globs, leave nothing to audit; told in one sentence.
struct NothingAudited : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rayaudit
