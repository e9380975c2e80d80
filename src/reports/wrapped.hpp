#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace rayaudit {

/// Columns that a line of a report for people has.
inline constexpr std::size_t page_width = 120;

/// The words of a text in indented lines that fit the page, with the end of the last line. A word
/// that is wider than the page stands alone.
inline std::string wrapped(std::string_view text, std::size_t indent) {
  const std::string margin(indent, ' ');
  std::string lines, line;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    if (!line.empty() && indent + line.size() + 1 + word.size() > page_width) {
      lines += margin + line + '\n';
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += word;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines + margin + line + '\n';
}

}  // namespace rayaudit
