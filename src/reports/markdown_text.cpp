#include "reports/markdown_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "reports/figures.hpp"

namespace rayaudit {
namespace {

/// Room that the sentences of what is left out take.
constexpr std::size_t sentences_room = 512;

bool is_word(std::string_view text, std::size_t i) {
  return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
}

/// Means a letter nothing where it stands? An underscore within a word does not.
bool is_plain(std::string_view text, std::size_t i) {
  if (text[i] == '_') return is_word(text, i - 1) && is_word(text, i + 1);
  return is_word(text, i) || std::string_view(" /-.,:;()%+='\"?^").find(text[i]) != text.npos;
}

/// The most backquotes in a row.
std::size_t most_backquotes(std::string_view text) {
  std::size_t longest = 0, here = 0;
  for (const char letter : text) {
    here = letter == '`' ? here + 1 : 0;
    longest = std::max(longest, here);
  }
  return longest;
}

}  // namespace

std::string markdown_text(std::string_view bytes) {
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    const auto code = static_cast<unsigned char>(bytes[i]);
    if (is_plain(bytes, i))
      text += bytes[i];
    else
      text += code >= ' ' && code < 0x7f ? fmt::format("&#{};", code)
                                         : fmt::format("&#92;x{:02x}", code);
  }
  return text;
}

std::string one_line(std::string_view bytes) {
  std::string text(bytes);
  for (char& letter : text)
    if (letter < ' ' || letter > '~') letter = ' ';
  return text;
}

std::string code_span(std::string_view line) {
  const std::string text = one_line(line), fence(most_backquotes(text) + 1, '`');
  const bool touches = text.starts_with('`') || text.ends_with('`');
  const std::string_view room = touches ? " " : "";
  return fmt::format("{}{}{}{}{}", fence, room, text, room, fence);
}

std::string fenced(std::string_view text) {
  const std::string fence(std::max<std::size_t>(most_backquotes(text), 2) + 1, '`');
  return fmt::format("{}\n{}{}\n", fence, text, fence);
}

std::string folded(std::string_view summary, std::string_view block) {
  return fmt::format("\n<details><summary>{}</summary>\n\n{}\n</details>\n", markdown_text(summary),
                     fenced(block));
}

void ShortMarkdown::add(const std::vector<std::string>& pieces, std::size_t wanted,
                        std::string_view name, std::size_t limit) {
  std::size_t added = 0;
  while (added < std::min(wanted, pieces.size()) &&
         text_.size() + pieces[added].size() + foot_.size() + sentences_room <= limit)
    text_ += pieces[added++];
  if (const std::size_t left = pieces.size() - added; left > 0)
    text_ += fmt::format("\n{} more {} left out.\n", figures::grouped(left), name);
}

}  // namespace rayaudit
