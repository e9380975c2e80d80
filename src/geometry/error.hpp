#pragma once

#include <stdexcept>

namespace rayaudit {

/// The user's mistake, told in one sentence: what, where, and the mend. Caught once, in main.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rayaudit
