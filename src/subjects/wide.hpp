#pragma once

#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// Every routine in numbers wider than the machine's: double-double, and float128 where the
/// compiler has it. They are asked for by name only.
std::vector<Subject> wide_subjects();

/// The formats among those that this compiler does not have.
std::vector<Absent> absent_wide_subjects();

}  // namespace rayaudit
