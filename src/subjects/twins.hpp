#pragma once

#include <filesystem>
#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// The built-in routines compiled again under other flags: `textbook+fast_math/float` with
/// -ffast-math, `textbook+native/float` for the very processor of the build, contraction allowed.
/// Each set of flags is a module beside the program, run in a process of its own. They are asked
/// for by name only.
std::vector<Subject> twin_subjects();

/// Those whose module is not beside the program.
std::vector<Absent> absent_twins();

/// The twins whose modules are beside a program that knows the command serve-module, or in
/// ../lib/rayaudit as seen from there.
std::vector<Subject> twins_beside(const std::filesystem::path& program);

}  // namespace rayaudit
