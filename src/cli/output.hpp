#pragma once

#include <string_view>

namespace rayaudit {

/// Writes all of it to standard output; throws Error where that fails.
void print(std::string_view text);

/// Writes a sentence of the program to standard error.
void complain(std::string_view sentence);

bool is_terminal(int descriptor);

/// May standard output be coloured: is it a terminal, and NO_COLOR (no-color.org) not set?
bool is_colour_welcome();

}  // namespace rayaudit
