#include "cli/convention_option.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>

#include "cli/names.hpp"
#include "cli/pieces.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

double number(std::string_view name, std::string_view text) {
  const std::string whole(text);
  char* end = nullptr;
  const double x = std::strtod(whole.c_str(), &end);
  if (whole.empty() || *end != '\0' || std::isnan(x))
    throw Error("--convention: expected a number for " + std::string(name) + ", got " +
                quotation(text));
  return x;
}

/// Half, line or segment; both of these are the line through two points.
void read_ray(std::uint8_t word, Convention& convention) {
  convention.line = word == 1 || (word == 2 && convention.line);
  convention.segment = word == 2 || (word == 1 && convention.segment);
}

/// Reads what is no stance towards a touch; false where it is none of these.
bool read_contract(std::string_view name, std::string_view value, Convention& convention) {
  static constexpr std::array<std::string_view, 4> insides = {"hit", "miss", "start", "any"};
  static constexpr std::array<std::string_view, 2> directions = {"any", "unit"};
  static constexpr std::array<std::string_view, 3> rays = {"half", "line", "segment"};
  static constexpr std::array<std::string_view, 3> extents = {"bounded", "unbounded",
                                                              "both_nappes"};
  static constexpr std::array<std::string_view, 3> stands = {"anywhere", "upright_y", "upright_z"};
  static constexpr std::array<std::string_view, 3> openings = {"radius", "angle", "cosine"};
  const auto word = [&](std::string_view what, const auto& words) {
    return static_cast<std::uint8_t>(place_of(what, value, words));
  };
  if (name == "inside")
    convention.inside = Convention::Inside{word("word for inside", insides)};
  else if (name == "direction")
    convention.unit_direction = word("kind of direction", directions) == 1;
  else if (name == "ray")
    read_ray(word("kind of ray", rays), convention);
  else if (name == "extent")
    convention.extent = Extent{word("extent", extents)};
  else if (name == "stand")
    convention.stand = Convention::Stand{word("stand", stands)};
  else if (name == "opening")
    convention.opening = Convention::Opening{word("opening", openings)};
  else if (name == "t_min")
    convention.t_min = number(name, value);
  else if (name == "t_max")
    convention.t_max = number(name, value);
  else
    return false;
  return true;
}

}  // namespace

Convention read_convention(std::string_view text) {
  using Stance = Convention::Stance;
  using oracle::Kind;
  static constexpr std::array<std::string_view, 3> stances = {"either", "hit", "miss"};
  static const std::array kinds = {name(Kind::tangent), name(Kind::rim), name(Kind::apex),
                                   name(Kind::start),   name(Kind::end), name(Kind::within)};
  Convention convention;
  auto stated = pieces(text, ',');
  if (stated.empty()) stated = {text};
  for (const std::string_view piece : stated) {
    const std::size_t equals = piece.find('=');
    if (equals == piece.npos)
      throw Error("--convention: expected KIND=hit or KIND=miss, got " + quotation(piece));
    if (read_contract(piece.substr(0, equals), piece.substr(equals + 1), convention)) continue;
    const std::size_t kind = 1 + place_of("kind of touch", piece.substr(0, equals), kinds);
    convention.stances[kind] =
        Stance{static_cast<std::uint8_t>(place_of("stance", piece.substr(equals + 1), stances))};
  }
  // Of an opening it may be the subject that declares how cones stand.
  Convention alone = convention;
  alone.opening = Convention::Opening::radius;
  if (const std::string wrong = contradiction(alone); !wrong.empty())
    throw Error("--convention has " + wrong);
  return convention;
}

}  // namespace rayaudit
