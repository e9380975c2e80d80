#pragma once

#include <stdexcept>
#include <string>

#include "geometry/vec3.hpp"

namespace rayaudit::oracle {

/// This thread's floating-point state does not allow exact work; no verdict would mean anything.
struct UnfitArithmetic : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Throws UnfitArithmetic unless this thread rounds to nearest and keeps subnormal numbers.
void require_plain_arithmetic();

/// Does this compiler round neighbouring numbers to float where the source says so? gcc 12 with its
/// straight-line vectorizer on does not.
bool rounds_to_float(const Vec3<double>& v);

}  // namespace rayaudit::oracle
