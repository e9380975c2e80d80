#include "subjects/twins.hpp"

namespace rayaudit {

std::vector<Subject> twin_subjects() { return {}; }
std::vector<Absent> absent_twins() { return {}; }

}  // namespace rayaudit
