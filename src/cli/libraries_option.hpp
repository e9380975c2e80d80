#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "subjects/subject.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace rayaudit {

/// The cases of each subject, shape and family where libraries are audited and no other number is
/// asked for: all of them take under ten minutes on two processors.
inline constexpr std::uint64_t cases_of_libraries = 1024;

/// What of libraries a command line asks for, where it does.
struct LibrariesOption {
  bool is_asked = false;  ///< told by who parses the command line, once that is done
  std::vector<std::string> names;
};
CLI::Option* add_libraries_option(CLI::App& command, LibrariesOption& libraries);

/// Loads the libraries of the names, all that are here where there are none: `embree`, one shape of
/// it as `embree/sphere`, one subject as `coin_pick/float`. What is not here or cannot be loaded is
/// told on standard error, in a sentence each. A subject of which one shape is asked for answers no
/// other. Throws Error where a name is known of no library, NothingAudited where none is left.
std::deque<Subject> loaded_libraries(const std::vector<std::string>& names);

}  // namespace rayaudit
