#pragma once

#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// The oracle's own fields as subjects: in CGAL's intervals, in its exact numbers, and by the
/// oracle itself. They are asked for by name only.
std::vector<Subject> exact_subjects();

}  // namespace rayaudit
