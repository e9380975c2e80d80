#include "cli/convention_option.hpp"

#include <array>

#include "cli/names.hpp"
#include "cli/pieces.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {

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
    const std::size_t kind = 1 + place_of("kind of touch", piece.substr(0, equals), kinds);
    convention.stances[kind] =
        Stance{static_cast<std::uint8_t>(place_of("stance", piece.substr(equals + 1), stances))};
  }
  return convention;
}

}  // namespace rayaudit
