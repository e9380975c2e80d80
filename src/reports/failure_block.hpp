#pragma once

#include <string>

#include "audit/tally.hpp"

namespace rayaudit {

/// All that a person needs of one wrong answer, of its minimal case where there is one, a line
/// each: case, got, truth, verdict, error and
/// margin where they are known, cause, and the command to explain it. With the end of the last
/// line.
std::string failure_block(const Worst& worst, const Subject& subject,
                          const Convention& stated = {});

}  // namespace rayaudit
