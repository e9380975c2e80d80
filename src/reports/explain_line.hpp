#pragma once

#include <string>

#include "audit/tally.hpp"

namespace rayaudit {

/// The case line, with the answer to it that was judged.
std::string answered_line(const Worst& worst);

/// The command that shows a case, with the answer to it that was judged in the format.
std::string explain_line(const Worst& worst, const Format& format);
/// The same for a subject, step by step.
std::string explain_line(const Worst& worst, const Subject& subject, const Convention& stated = {});

}  // namespace rayaudit
