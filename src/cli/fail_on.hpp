#pragma once

#include <string_view>

#include "reports/breach.hpp"

namespace rayaudit {

/// Reads `false_hit,wrong_t` and `max_ulp=N`; throws Error where it cannot.
FailOn read_fail_on(std::string_view text);

}  // namespace rayaudit
