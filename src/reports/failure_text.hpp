#pragma once

#include <string>

#include "audit/judge.hpp"

namespace rayaudit {

/// Is an answer not wrong, and its t within so many ulps where they are above 0?
bool agrees(const Judgement& judgement, double max_ulp);

/// One answer to one case, for a person to read and to go on from: case, got, truth, verdict,
/// error, margin, cause where an answer alone shows it, and the command that explains it. Lines,
/// each of them ended.
std::string failure_text(const Case& question, const Answer& answer, const Format& format,
                         const Convention& convention, double max_ulp);

}  // namespace rayaudit
