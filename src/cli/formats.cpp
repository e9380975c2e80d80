#include "cli/formats.hpp"

#include <array>

#include "cli/names.hpp"

namespace rayaudit {

const Format& known_format(std::string_view name) {
  static constexpr std::array formats = {float_format, double_format, long_double_format};
  return formats[place_of("format", name, names_of(formats, &Format::name))];
}

bool is_in(const Case& question, const Format& format) {
  if (format != float_format) return true;
  bool all = true;
  const auto see = [&](double x) { all = all && (x != x || static_cast<float>(x) == x); };
  each_number(question, see);
  see(question.ray.t_min), see(question.ray.t_max);
  return all;
}

}  // namespace rayaudit
