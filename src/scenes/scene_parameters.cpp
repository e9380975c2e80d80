#include "scenes/scene_parameters.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

constexpr std::size_t most_parameters = 1000;

constexpr std::array<std::string_view, 19> types = {
    "integer",   "float",  "point",   "point2",  "point3",  "vector", "vector2",
    "vector3",   "normal", "normal3", "rgb",     "color",   "xyz",    "spectrum",
    "blackbody", "bool",   "string",  "texture", "texture2"};

constexpr std::string_view blanks = " \t\r\f\v";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

/// No sentence needs more of it, and no search for what is near.
std::string_view shortened(std::string_view name) { return name.substr(0, 100); }

}  // namespace

Parameters::Parameters(Tokens& tokens, std::string owner, SceneNotes& notes)
    : owner_(std::move(owner)), begin_(tokens.peek()), notes_(&notes) {
  while (tokens.peek().kind == Token::Kind::string) {
    if (parameters_.size() == most_parameters)
      rayaudit::refuse(tokens.peek(),
                       fmt::format("{}: more than {} parameters", owner_, most_parameters));
    parameters_.push_back(read(tokens));
  }
}

Parameters::Parameter Parameters::read(Tokens& tokens) const {
  const Token declaration = tokens.next();
  const std::string_view text = trimmed(declaration.text);
  const std::size_t gap = std::min(text.find_first_of(blanks), text.size());
  Parameter parameter = {declaration, text.substr(0, gap), trimmed(text.substr(gap))};
  if (parameter.name.empty())
    rayaudit::refuse(declaration, owner_ + R"(: expected a parameter, as "float radius", got )" +
                                      told(declaration));
  if (std::find(types.begin(), types.end(), parameter.type) == types.end())
    rayaudit::refuse(declaration,
                     owner_ + ": " + unknown_name("type", shortened(parameter.type), types));
  if (tokens.peek().kind != Token::Kind::open) {
    read_value(parameter, tokens.next());
    return parameter;
  }
  const Token open = tokens.next();
  while (tokens.peek().kind != Token::Kind::close) {
    if (tokens.peek().kind == Token::Kind::end) rayaudit::refuse(open, "`[` without its `]`");
    read_value(parameter, tokens.next());
  }
  tokens.next();
  return parameter;
}

void Parameters::read_value(Parameter& parameter, const Token& value) const {
  const bool is_truth =
      value.kind == Token::Kind::word && (value.text == "true" || value.text == "false");
  if (value.kind == Token::Kind::string || is_truth) {
    parameter.words.push_back(value.text);
  } else {
    parameter.numbers.push_back(read_number(value, owner_, shortened(parameter.name)));
  }
  if (!parameter.words.empty() && !parameter.numbers.empty())
    rayaudit::refuse(
        value, fmt::format("{}: {} mixes numbers and words", owner_, quotation(parameter.name)));
}

const Parameters::Parameter* Parameters::find(std::string_view name) const {
  const auto last = std::find_if(parameters_.rbegin(), parameters_.rend(),
                                 [&](const Parameter& p) { return p.name == name; });
  return last == parameters_.rend() ? nullptr : &*last;
}

const Parameters::Parameter* Parameters::ask(std::string_view name) {
  asked_.push_back(name);
  for (Parameter& parameter : parameters_)
    if (parameter.name == name) parameter.used = true;
  return find(name);
}

bool Parameters::has(std::string_view name) { return ask(name) != nullptr; }

Place Parameters::place(std::string_view name) const {
  const Parameter* parameter = find(name);
  return (parameter != nullptr ? parameter->declaration : begin_).place();
}

void Parameters::refuse(std::string_view name, const std::string& what) const {
  throw SceneError(place(name), owner_ + ": " + what);
}

void Parameters::require_numbers(const Parameter& parameter, std::size_t count) const {
  if (parameter.numbers.size() != count)
    refuse(parameter.name,
           fmt::format("{} must be {}, got {}", quotation(parameter.name),
                       count == 1 ? "one number" : fmt::format("{} numbers", count),
                       parameter.words.empty() ? fmt::format("{}", parameter.numbers.size())
                                               : quotation(parameter.words.front())));
}

std::vector<double> Parameters::numbers(std::string_view name, std::size_t count) {
  const Parameter* parameter = ask(name);
  if (parameter == nullptr) return {};
  require_numbers(*parameter, count);
  return parameter->numbers;
}

double Parameters::number(std::string_view name, double fallback) {
  const Parameter* parameter = ask(name);
  if (parameter == nullptr) return fallback;
  require_numbers(*parameter, 1);
  return parameter->numbers.front();
}

std::int64_t Parameters::whole(std::string_view name, std::int64_t fallback, std::int64_t least,
                               std::int64_t most) {
  const double value = number(name, static_cast<double>(fallback));
  if (value == std::floor(value) && value >= static_cast<double>(least) &&
      value <= static_cast<double>(most))
    return static_cast<std::int64_t>(value);
  refuse(name, fmt::format("{} must be a whole number from {} to {}, got {:g}", quotation(name),
                           least, most, value));
}

Vec3<double> Parameters::vector(std::string_view name, const Vec3<double>& fallback) {
  const std::vector<double> components = numbers(name, 3);
  if (components.empty()) return fallback;
  return {components[0], components[1], components[2]};
}

std::string_view Parameters::word(std::string_view name, std::string_view fallback) {
  const Parameter* parameter = ask(name);
  if (parameter == nullptr) return fallback;
  if (parameter->words.size() != 1)
    refuse(name, quotation(name) + " must be one word between double quotes");
  return parameter->words.front();
}

Colour Parameters::colour(std::string_view name, const Colour& fallback) {
  const Parameter* parameter = ask(name);
  if (parameter == nullptr) return fallback;
  const bool is_grey = parameter->type == "float";
  if (!is_grey && parameter->type != "rgb" && parameter->type != "color") {
    notes_->skip(parameter->declaration.place(),
                 fmt::format("{}: {} of type {} is not supported, taken as {:g} {:g} {:g}", owner_,
                             quotation(name), quotation(parameter->type), fallback.x, fallback.y,
                             fallback.z));
    return fallback;
  }
  require_numbers(*parameter, is_grey ? 1 : 3);
  const std::vector<double>& n = parameter->numbers;
  const Colour colour = is_grey ? Colour{n[0], n[0], n[0]} : Colour{n[0], n[1], n[2]};
  if (colour.x < 0 || colour.y < 0 || colour.z < 0)
    refuse(name, quotation(name) + " must not be negative");
  return colour;
}

Colour Parameters::reflectance(std::string_view name, const Colour& fallback) {
  const Colour part = colour(name, fallback);
  if (part.x > 1 || part.y > 1 || part.z > 1)
    refuse(name,
           quotation(name) + " must not be above 1: no surface gives more light than falls on it");
  return part;
}

void Parameters::ignore(std::initializer_list<std::string_view> names) {
  for (Parameter& parameter : parameters_)
    if (std::find(names.begin(), names.end(), parameter.name) != names.end()) parameter.used = true;
}

void Parameters::finish() {
  for (const Parameter& parameter : parameters_)
    if (!parameter.used)
      notes_->skip(parameter.declaration.place(),
                   owner_ + ": " + unknown_name("parameter", shortened(parameter.name), asked_));
}

}  // namespace rayaudit
