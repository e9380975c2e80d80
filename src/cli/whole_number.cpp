#include "cli/whole_number.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

/// Decimal places that a suffix stands for: 6 for `e6` and `M`; nothing where it is none.
std::optional<int> places_of(std::string_view suffix) {
  if (suffix.empty()) return 0;
  if (suffix == "k" || suffix == "K") return 3;
  if (suffix == "M") return 6;
  if (suffix == "G") return 9;
  if (suffix[0] != 'e' && suffix[0] != 'E') return std::nullopt;
  suffix.remove_prefix(suffix.substr(1, 1) == "+" ? 2 : 1);
  const bool plain = !suffix.empty() && suffix.size() <= 3 &&
                     suffix.find_first_not_of("0123456789") == suffix.npos;
  return plain ? std::optional(std::stoi(std::string(suffix))) : std::nullopt;
}

/// Any value beyond the range of the result becomes the end of that range.
std::optional<std::int64_t> read(std::string_view text) {
  std::string digits(text);
  std::erase(digits, '_');
  const std::size_t end =
      std::min(digits.find_first_not_of("0123456789", digits[0] == '-' ? 1 : 0), digits.size());
  std::optional<int> places = places_of(std::string_view(digits).substr(end));
  std::int64_t number = 0;
  const auto [last, fault] = std::from_chars(digits.data(), digits.data() + end, number);
  if (!places || last != digits.data() + end || fault == std::errc::invalid_argument)
    return std::nullopt;
  const std::int64_t limit = digits[0] == '-' ? INT64_MIN : INT64_MAX;
  if (fault == std::errc::result_out_of_range) return limit;
  for (; *places > 0 && number != 0; --*places)
    if (__builtin_mul_overflow(number, 10, &number)) return limit;
  return number;
}

}  // namespace

std::int64_t whole_number(std::string_view option, std::string_view text, std::int64_t least,
                          std::int64_t most) {
  const std::string told(option), got = ", got " + quotation(text);
  const auto number = read(text);
  if (!number) throw Error(told + " must be a whole number" + got);
  if (*number < least) throw Error(told + " must be at least " + std::to_string(least) + got);
  if (*number > most) throw Error(told + " must be at most " + std::to_string(most) + got);
  return *number;
}

}  // namespace rayaudit
