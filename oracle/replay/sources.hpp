#pragma once

#include <string_view>

namespace rayaudit::replay {

/// A line of the routines as they were compiled, without the spaces around it; empty where there is
/// none. The file is named below src, as routines/textbook.hpp.
std::string_view source_line(std::string_view file, int line);

/// The same file named as from src on.
std::string_view below_src(std::string_view path);

}  // namespace rayaudit::replay
