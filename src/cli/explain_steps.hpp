#pragma once

#include <string>

#include "geometry/case.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// The run of a built-in subject on a case, line by line: what each line yields in the subject's
/// format, exactly, and how far off it is and may be; and the comparisons, with those marked that
/// are answered otherwise than exactly so. One sentence where the subject cannot be replayed.
std::string steps_text(const Case& question, const Subject& subject);

}  // namespace rayaudit
