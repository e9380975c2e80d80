#include "cli/line_of.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <optional>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

struct Place {
  std::string file;
  std::uint64_t line;
};

/// FILE:LINE, where it is that.
std::optional<Place> place_in_file(const std::string& word) {
  const std::size_t colon = word.rfind(':');
  if (colon == word.npos || colon == 0) return std::nullopt;
  Place place = {word.substr(0, colon), 0};
  const char* end = word.data() + word.size();
  const auto [last, fault] = std::from_chars(word.data() + colon + 1, end, place.line);
  if (fault != std::errc() || last != end || place.line == 0) return std::nullopt;
  return place;
}

std::string line_at(const Place& place) {
  std::ifstream file(place.file);
  const auto unreadable = [&] {
    return Error("`" + place.file + "` cannot be read: " + std::strerror(errno));
  };
  if (!file) throw unreadable();
  std::string line;
  std::uint64_t number = 0;
  while (number < place.line && std::getline(file, line)) ++number;
  if (file.bad()) throw unreadable();
  if (number < place.line)
    throw Error(fmt::format("`{}` has no line {}, only {}", place.file, place.line, number));
  if (is_blank(line)) throw Error(fmt::format("{}:{}: no case here", place.file, place.line));
  return line;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) (line += line.empty() ? "" : " ") += word;
  return line;
}

}  // namespace

std::string line_of(const std::vector<std::string>& words) {
  constexpr const char* wanted = "explain: expected a case line or FILE:LINE";
  constexpr const char* counted = "; lines count from 1";
  if (words.empty()) throw Error(std::string(wanted) + counted);
  if (words.size() > 1) return joined(words);
  const std::string& word = words[0];
  if (const auto place = place_in_file(word)) return line_at(*place);
  if (word.find_first_of(" \t") == word.npos)
    throw Error(std::string(wanted) + ", got " + quotation(word) + counted);
  return word;
}

}  // namespace rayaudit
