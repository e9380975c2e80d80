#include "subjects/exact.hpp"

namespace rayaudit {

std::vector<Subject> exact_subjects() { return {}; }

}  // namespace rayaudit
