#pragma once

#include <string>

#include "reports/ink.hpp"
#include "reports/report.hpp"

namespace rayaudit {

/// What each routine was seen to make of touches; empty where none was on offer.
std::string write_touches(const Run& run, const Ink& ink);

}  // namespace rayaudit
