#pragma once

#include <stdexcept>
#include <string>

namespace rayaudit::oracle {

/// This thread's floating-point state does not allow exact work; no verdict would mean anything.
struct UnfitArithmetic : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UnfitArithmetic unless this thread rounds to nearest and keeps subnormal numbers.
void require_plain_arithmetic();

}  // namespace rayaudit::oracle
