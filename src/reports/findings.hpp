#pragma once

#include <string>
#include <string_view>

#include "reports/ink.hpp"
#include "reports/report.hpp"

namespace rayaudit {

/// What a wrong verdict is, for those who do not know the words yet.
std::string_view sentence(Verdict verdict);
/// What there is at the place that is claimed: what follows the sentence of the verdict, or
/// nothing.
std::string_view sentence(Claim claim);

/// The findings of a run in sentences, worst first, each with one case line to go on from.
std::string write_findings(const Run& run, const Ink& ink, bool all);

}  // namespace rayaudit
