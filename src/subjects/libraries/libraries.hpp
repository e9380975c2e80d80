#pragma once

#include <filesystem>
#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// Libraries that people ship, as subjects: each comes as a plugin, rayaudit-NAME.so, that lies
/// beside the program or in ../lib/rayaudit, and is loaded when first asked. They are asked for by
/// name only.
std::vector<Subject> library_subjects();
std::vector<Subject> libraries_beside(const std::filesystem::path& program);

/// Those whose plugins are not there: each needs its library when the project is built.
std::vector<Absent> absent_libraries();

}  // namespace rayaudit
