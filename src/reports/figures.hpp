#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

/// How reports for people spell figures: short, and never a 0 or a 100 % that is none.
namespace rayaudit::figures {

/// 1234567 as 1,234,567.
inline std::string grouped(std::uint64_t number) {
  std::string digits = std::to_string(number);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

/// A share in per cent, in at most five characters: 100, >99.9, 12.3, 0.04, <0.01; 0 is a dash.
inline std::string percent(std::uint64_t part, std::uint64_t whole) {
  if (part == 0) return "-";
  if (part == whole) return "100";
  const double share = 100 * static_cast<double>(part) / static_cast<double>(whole);
  if (share >= 99.95) return ">99.9";
  if (share < 0.01) return "<0.01";
  return share < 9.995 ? fmt::format("{:.2f}", share) : fmt::format("{:.1f}", share);
}

/// A magnitude to two or three digits, in at most six characters: 0.5, 117, 3.2e7, 1e300.
inline std::string magnitude(double x) {
  if (std::isnan(x)) return "-";
  if (!std::isfinite(x)) return "inf";
  if (x == 0 || (x >= 0.001 && x < 999.5)) return fmt::format("{:.3g}", x);
  const bool wide = x < 1e-99 || x > 9.4e99;
  std::string text = fmt::format("{:.{}e}", x, wide ? 0 : 1);
  const std::size_t exponent = text.find('e') + 1;
  if (text[exponent] == '+') text.erase(exponent, 1);
  const std::size_t digit = text[exponent] == '-' ? exponent + 1 : exponent;
  if (text[digit] == '0') text.erase(digit, 1);
  return text;
}

/// Words with spaces where names have underscores.
inline std::string words(std::string_view name) {
  std::string text(name);
  for (char& letter : text)
    if (letter == '_') letter = ' ';
  return text;
}

}  // namespace rayaudit::figures
