#include "subjects/flat_convention.hpp"

#include <string>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

std::string none_such(std::int32_t value, const std::string& towards, const std::string& word) {
  return "its convention has " + std::to_string(value) + " for " + towards + ", which is no " +
         word + " (0, 1 or 2)";
}

Convention::Stance stance(const char* towards, std::int32_t value) {
  if (value < RAYAUDIT_EITHER || value > RAYAUDIT_IS_MISS)
    throw Error(none_such(value, towards, "rayaudit_stance"));
  return Convention::Stance{static_cast<std::uint8_t>(value)};
}

Convention::Inside inside(std::int32_t value) {
  if (value < RAYAUDIT_INSIDE_IS_HIT || value > RAYAUDIT_INSIDE_IS_START)
    throw Error(none_such(value, "inside", "rayaudit_inside"));
  return Convention::Inside{static_cast<std::uint8_t>(value)};
}

}  // namespace

Convention from_flat(const rayaudit_convention& said) {
  using oracle::Kind;
  Convention made;
  made.of(Kind::tangent) = stance("tangent", said.tangent);
  made.of(Kind::rim) = stance("rim", said.rim);
  made.of(Kind::apex) = stance("apex", said.apex);
  made.of(Kind::start) = stance("start", said.start);
  made.of(Kind::end) = stance("end", said.end);
  made.of(Kind::within) = stance("within", said.within);
  made.inside = inside(said.inside);
  made.unit_direction = said.unit_direction != 0;
  made.line = said.line != 0;
  if (said.t_min == 0 && said.t_max == 0) return made;
  made.t_min = said.t_min, made.t_max = said.t_max;
  if (!has_range(made)) throw Error("its convention has " + empty_range(made));
  return made;
}

}  // namespace rayaudit
