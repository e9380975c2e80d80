#pragma once

#include <string>
#include <string_view>

namespace rayaudit {

/// A word of the user's as a sentence can hold it: between backquotes, cut after 60 characters,
/// what is no printable ASCII as \x1b.
inline std::string quotation(std::string_view word) {
  constexpr std::size_t most = 60;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text = "`";
  for (const char letter : word.substr(0, most)) {
    const auto code = static_cast<unsigned char>(letter);
    if (code >= ' ' && code < 0x7f) {
      text += letter;
    } else {
      (text += "\\x") += {digits[code / 16], digits[code % 16]};
    }
  }
  return text + (word.size() > most ? "...`" : "`");
}

}  // namespace rayaudit
