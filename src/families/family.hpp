#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "families/random.hpp"
#include "geometry/case.hpp"
#include "geometry/format.hpp"

namespace rayaudit {

/// How hard a family presses: anywhere at all, exactly on a degenerate case, or just off it.
enum class Strength : std::uint8_t { anywhere, degenerate, near };

/// What k means to a family, and the range it may be asked in; drawn evenly there when none is.
struct Difficulty {
  int least;
  int most_float, most_double;
  std::string_view about;

  int most(const Format& format) const {
    return format.precision == float_format.precision ? most_float : most_double;
  }
};

/// Draws one case in a format, of difficulty k (without a meaning where the family has none).
using Draw = Case (*)(Random& random, const Format& format, int k);

/// A seeded generator of cases after one weakness.
struct Family {
  std::string_view id;
  std::string_view about;
  Strength strength;
  std::optional<Difficulty> difficulty;
  std::array<Draw, shape_count> draw;  ///< by shape, in the order of the list; null: makes no sense
};

/// Every family there is. A new one is one function and a row in this table.
std::span<const Family> families();

/// Cases in a chunk, the unit that is drawn independently of all others.
inline constexpr std::size_t chunk_cases = 1024;

/// The first cases of a chunk, as many as the span holds, at most chunk_cases. They depend on the
/// arguments alone; every number is one of the format, which is float or double. The family must
/// draw the shape; a difficulty must lie in its range and is ignored where the family has none.
void draw(const Family& family, std::size_t shape, const Format& format,
          std::optional<int> difficulty, std::uint64_t seed, std::uint64_t chunk,
          std::span<Case> cases);

}  // namespace rayaudit
