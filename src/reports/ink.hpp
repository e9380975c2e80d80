#pragma once

#include <string>
#include <string_view>

namespace rayaudit {

/// Puts colour on text where it is wanted: ANSI escape codes, which take no room.
struct Ink {
  bool colour;

  std::string heading(std::string_view text) const { return in("1", text); }
  std::string bad(std::string_view text) const { return in("31", text); }
  std::string good(std::string_view text) const { return in("32", text); }
  std::string faint(std::string_view text) const { return in("2", text); }

 private:
  std::string in(std::string_view code, std::string_view text) const {
    if (!colour) return std::string(text);
    return "\x1b[" + std::string(code) + 'm' + std::string(text) + "\x1b[0m";
  }
};

}  // namespace rayaudit
