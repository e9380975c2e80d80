#include "reports/xml_text.hpp"

#include <algorithm>
#include <cstdint>

namespace rayaudit {
namespace {

/// The bytes of the character that a text begins with; 0 where that is no UTF-8 (RFC 3629), or none
/// that XML 1.0 has (its production 2).
std::size_t character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
  const std::uint8_t first = byte(0);
  if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r';
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : first >= 0xc0 ? 2 : 0;
  if (size == 0 || text.size() < size) return 0;
  std::uint32_t code = first & (0x7f >> size);
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
    code = code << 6 | (byte(i) & 0x3f);
  }
  constexpr std::uint32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xd800 && code <= 0xdfff;
  if (code < least[size] || code > 0x10ffff || is_surrogate) return 0;
  return code == 0xfffe || code == 0xffff ? 0 : size;
}

std::string_view entity(char letter) {
  switch (letter) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\r':
      return "&#13;";
    default:
      return {};
  }
}

}  // namespace

std::string xml_text(std::string_view bytes) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  while (!bytes.empty()) {
    const std::size_t size = character(bytes);
    const auto code = static_cast<std::uint8_t>(bytes.front());
    if (size == 0) {
      (text += "\\x") += {digits[code / 16], digits[code % 16]};
    } else if (const std::string_view mark = entity(bytes.front()); !mark.empty()) {
      text += mark;
    } else {
      text += bytes.substr(0, size);
    }
    bytes.remove_prefix(std::max<std::size_t>(size, 1));
  }
  return text;
}

std::string xml_attribute(std::string_view key, std::string_view bytes) {
  std::string text = ' ' + std::string(key) + "=\"";
  for (const char letter : xml_text(bytes))
    text += letter == '\n' ? "&#10;" : letter == '\t' ? "&#9;" : std::string(1, letter);
  return text + '"';
}

}  // namespace rayaudit
