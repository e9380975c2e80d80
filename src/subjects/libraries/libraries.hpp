#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "subjects/plugins.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// A library that people ship, as a plugin: rayaudit-PLUGIN.so, built where the library is found,
/// lies beside the program or in ../lib/rayaudit. What its subjects are and declare, it tells when
/// it is loaded; so they are asked for by name only.
struct Library {
  std::string_view plugin;
  std::string_view subjects;  ///< what they are called, as a glob: `coin*/float`
  std::string_view needs;     ///< for the plugin to be built: `ODE (Debian's libode-dev)`

  /// What all names of its subjects begin with: `coin`.
  std::string_view stem() const { return subjects.substr(0, subjects.find_first_of("*/")); }
};

/// Every library there is. A new one is its file in this folder, a line in CMakeLists.txt, and a
/// row here.
std::span<const Library> libraries();

/// Is its plugin there?
bool is_here(const Library& library, const std::filesystem::path& program = this_program);

/// Its subjects, loaded now, each in a process of its own. Throws Error, in one sentence, where its
/// plugin is not there or cannot be loaded.
std::vector<Subject> subjects_of(const Library& library,
                                 const std::filesystem::path& program = this_program);

/// Why its plugin is not there, as a sentence: it needs its library when the project is built.
std::string why_absent(const Library& library);

}  // namespace rayaudit
