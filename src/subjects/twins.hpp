#pragma once

#include <filesystem>
#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// The built-in routines compiled again under other flags: `textbook+fast_math/float` with
/// -ffast-math, `textbook+native/float` for the very processor of the build, contraction allowed.
/// Each set of flags is a plugin beside the program, run in a process of its own. They are asked
/// for by name only. Unlike the subjects of other plugins they share their cases, whose truth is so
/// found once for all of them, and one that crashes or hangs is told by NoAnswer.
std::vector<Subject> twin_subjects();

/// Those whose plugin is not beside the program.
std::vector<Absent> absent_twins();

/// The twins whose plugins are beside a program that knows the command serve-plugin, or in
/// ../lib/rayaudit as seen from there.
std::vector<Subject> twins_beside(const std::filesystem::path& program);

}  // namespace rayaudit
