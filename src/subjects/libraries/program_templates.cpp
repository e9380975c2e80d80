#include "subjects/libraries/program_templates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "subjects/libraries/template_texts.hpp"

namespace rayaudit {
namespace {

/// The next line of a text, which is then shorter by it.
std::string_view next_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::optional<std::string_view> after(std::string_view line, std::string_view start) {
  if (!line.starts_with(start)) return {};
  return line.substr(start.size());
}

/// A literal that reads back as x.
std::string literal(double x, const Format& format, std::string_view ending) {
  const bool is_cpp = ending == ".cpp";
  if (std::isinf(x)) return std::string(x < 0 ? "-" : "") + (is_cpp ? "INFINITY" : "Infinity");
  const auto shown = static_cast<float>(x);
  const bool is_float = format == float_format && is_cpp && static_cast<double>(shown) == x;
  std::string text = is_float ? fmt::format("{}", shown) : fmt::format("{}", x);
  if (text.find_first_of(".en") == text.npos) text += ".0";
  return is_float ? text + 'f' : text;
}

using Numbers = std::map<std::string, double, std::less<>>;

void put(Numbers& numbers, const std::string& name, const Vec3<double>& v) {
  numbers[name + 'x'] = v.x, numbers[name + 'y'] = v.y, numbers[name + 'z'] = v.z;
}

/// Of a shape that stands upright the larger coordinate of its top or apex.
double half_height(const Vec3<double>& tip) { return std::max(tip.y, tip.z); }

Numbers numbers_of(const Case& question) {
  Numbers numbers;
  put(numbers, "o", question.ray.origin);
  put(numbers, "d", question.ray.direction);
  numbers["t_min"] = question.ray.t_min, numbers["t_max"] = question.ray.t_max;
  std::visit(
      [&](const auto& shape) {
        numbers["r"] = shape.radius;
        if constexpr (requires { shape.centre; }) put(numbers, "c", shape.centre);
        if constexpr (requires { shape.normal; }) put(numbers, "n", shape.normal);
        if constexpr (requires { shape.base; }) put(numbers, "a", shape.base);
        if constexpr (requires { shape.top; })
          put(numbers, "b", shape.top), numbers["h"] = half_height(shape.top);
        if constexpr (requires { shape.apex; })
          put(numbers, "b", shape.apex), numbers["h"] = half_height(shape.apex);
      },
      question.shape);
  return numbers;
}

}  // namespace

ProgramTemplate read_template(std::string_view file, std::string_view text) {
  ProgramTemplate made = {file, "", {}, ""};
  while (text.starts_with("// ")) {
    std::string_view rest = text;
    const std::string_view line = next_line(rest);
    if (const auto build = after(line, "// build: ")) {
      made.build = *build;
    } else if (const auto says = after(line, "// says ")) {
      const std::size_t colon = says->find(": ");
      made.says.push_back({std::string(says->substr(0, colon)),
                           std::string(colon == says->npos ? "" : says->substr(colon + 2))});
    } else {
      break;
    }
    text = rest;
  }
  made.body = text;
  return made;
}

std::optional<ProgramTemplate> program_template(std::string_view routine, std::size_t shape) {
  const std::string start = std::string(routine) + '.' + std::string(shape_names[shape]) + '.';
  for (const auto& [file, text] : template_texts())
    if (file.starts_with(start)) return read_template(file, text);
  return {};
}

std::optional<std::string> says_of(const ProgramTemplate& program, std::string_view key) {
  for (const std::string_view wanted : {key, std::string_view("any")})
    for (const Says& says : program.says)
      if (says.key == wanted) return says.sentence;
  return {};
}

std::string filled(const ProgramTemplate& program, const Case& question, const Format& format) {
  const Numbers numbers = numbers_of(question);
  std::string text;
  std::string_view rest = program.body;
  while (!rest.empty()) {
    const std::size_t at = std::min(rest.find('@'), rest.size());
    text += rest.substr(0, at);
    rest.remove_prefix(at);
    if (rest.empty()) break;
    const std::size_t end = rest.find('@', 1);
    const std::string_view place = end == rest.npos ? "" : rest.substr(1, end - 1);
    const auto number = numbers.find(place);
    if (place == "real") {
      text += format == float_format ? "float" : "double";
    } else if (number != numbers.end()) {
      text += literal(number->second, format, program.ending());
    } else {
      text += '@';
      rest.remove_prefix(1);
      continue;
    }
    rest.remove_prefix(end + 1);
  }
  return text;
}

}  // namespace rayaudit
