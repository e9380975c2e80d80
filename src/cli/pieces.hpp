#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

namespace rayaudit {

/// The pieces of a text between separators; empty ones are left out.
inline std::vector<std::string_view> pieces(std::string_view text, char separator) {
  std::vector<std::string_view> found;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    if (end > 0) found.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return found;
}

}  // namespace rayaudit
