#include "subjects/flat_convention.hpp"

#include <string>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

std::string none_such(std::int32_t value, const std::string& towards, const std::string& word,
                      const char* known = "0, 1 or 2") {
  return "its convention has " + std::to_string(value) + " for " + towards + ", which is no " +
         word + " (" + known + ")";
}

/// One of three words, by its number.
std::uint8_t word(const char* about, std::int32_t value, const char* kind) {
  if (value < 0 || value > 2) throw Error(none_such(value, about, kind));
  return static_cast<std::uint8_t>(value);
}

Convention::Stance stance(const char* towards, std::int32_t value) {
  if (value < RAYAUDIT_EITHER || value > RAYAUDIT_IS_MISS)
    throw Error(none_such(value, towards, "rayaudit_stance"));
  return Convention::Stance{static_cast<std::uint8_t>(value)};
}

Convention::Inside inside(std::int32_t value) {
  if (value < RAYAUDIT_INSIDE_IS_HIT || value > RAYAUDIT_INSIDE_IS_ANY)
    throw Error(none_such(value, "inside", "rayaudit_inside", "0 to 3"));
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
  made.extent = Extent{word("extent", said.extent, "rayaudit_extent")};
  made.stand = Convention::Stand{word("stand", said.stand, "rayaudit_stand")};
  made.opening = Convention::Opening{word("opening", said.opening, "rayaudit_opening")};
  made.segment = said.segment != 0;
  if (said.t_min != 0 || said.t_max != 0) made.t_min = said.t_min, made.t_max = said.t_max;
  if (const std::string wrong = contradiction(made); !wrong.empty())
    throw Error("its convention has " + wrong);
  return made;
}

}  // namespace rayaudit
