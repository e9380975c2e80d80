#pragma once

#include <string>

#include "reports/ink.hpp"
#include "reports/report.hpp"
#include "reports/sentence.hpp"

namespace rayaudit {

/// The findings of a run in sentences, worst first, each with one case line to go on from.
std::string write_findings(const Run& run, const Ink& ink, bool all);

}  // namespace rayaudit
