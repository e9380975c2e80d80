#include "subjects/flat_convention.hpp"

namespace rayaudit {

std::optional<Convention> from_flat(const rayaudit_convention& convention) {
  const std::array stances = {convention.tangent, convention.rim, convention.apex,
                              convention.start,   convention.end, convention.within};
  Convention made;
  for (std::size_t i = 0; i < stances.size(); ++i) {
    if (stances[i] < RAYAUDIT_EITHER || stances[i] > RAYAUDIT_IS_MISS) return {};
    made.stances[1 + i] = Convention::Stance{static_cast<std::uint8_t>(stances[i])};
  }
  if (convention.inside < RAYAUDIT_INSIDE_IS_HIT || convention.inside > RAYAUDIT_INSIDE_IS_START)
    return {};
  made.inside = Convention::Inside{static_cast<std::uint8_t>(convention.inside)};
  made.unit_direction = convention.unit_direction != 0;
  made.line = convention.line != 0;
  if (convention.t_min == 0 && convention.t_max == 0) return made;
  if (!(convention.t_min < convention.t_max)) return {};
  made.t_min = convention.t_min;
  made.t_max = convention.t_max;
  return made;
}

}  // namespace rayaudit
