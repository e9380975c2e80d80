#pragma once

#include <string>
#include <vector>

namespace rayaudit {

/// The case line that words are, or that stands at the place that the only word names, FILE:LINE.
/// Throws Error where it is neither or cannot be read.
std::string line_of(const std::vector<std::string>& words);

}  // namespace rayaudit
