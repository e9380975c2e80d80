#pragma once

#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// The built-in routines compiled again under other flags: `textbook+fast_math/float` with
/// -ffast-math, `textbook+native/float` for this very processor, contraction allowed. Each set of
/// flags is a module beside the program, run in a process of its own. They are asked for by name
/// only.
std::vector<Subject> twin_subjects();

/// Those whose module is not beside the program.
std::vector<Absent> absent_twins();

}  // namespace rayaudit
