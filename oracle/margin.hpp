#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "oracle/truth.hpp"

/// How far a case lies from the nearest case with another truth.
namespace rayaudit::oracle {

/// A sign that the truth rests on.
enum class Sign : std::uint8_t {
  touch,         ///< the truth has a touch: some sign is 0 already
  discriminant,  ///< whether F has real roots; of an endless surface, whether this one is at
                 ///< infinity
  start,         ///< of t - t_min
  end,           ///< of t_max - t
  side,          ///< of a side condition
};
std::string_view name(Sign sign);

/// The least move that changes the truth, to first order: every number of the case by at most this
/// share of the largest component of its vector (a radius, t_min, t_max: of itself). It is
/// |s| / sum W_j |ds/dx_j| for the sign s that flips; where several must flip together, the largest
/// of theirs. To two digits; see ARCHITECTURE.md for where first order tells the truth.
struct Margin {
  double reach = 0;  ///< 0 for a touch, else above; at most 1. In units of u: reach 2^precision
  Sign sign = Sign::touch;   ///< the sign whose flip is the dearest of those that are needed
  std::int8_t side = 0;      ///< which side condition that is, from 0
  std::int8_t root = 0;      ///< at which real root of F in order along the line, from 0; of a
                             ///< discriminant that is 0 or less, at the tangent point
  std::int8_t together = 1;  ///< how many signs flip together
  std::int8_t patch = 0;  ///< else than 0 where it is not F's root but a cap's, as in Crossing; the
                          ///< side condition there is -F
};

/// The margin of a valid case, of which this is the truth.
Margin margin(const Case& question, const Truth& truth);

/// Its stages, for a valid case whose truth has no touch: by double-word numbers, nothing where
/// they do not tell; and by exact ones.
std::optional<Margin> margin_by_bounds(const Case& question);
Margin margin_exactly(const Case& question);

}  // namespace rayaudit::oracle
