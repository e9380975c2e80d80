#pragma once

#include <string>

#include "reports/ink.hpp"
#include "reports/report.hpp"

namespace rayaudit {

/// What can be relied on, a row for each subject: how often it is wrong at which margin, and what
/// its running error bounds prove beside what was seen.
std::string write_limits(const Run& run, const Ink& ink);

}  // namespace rayaudit
