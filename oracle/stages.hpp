#pragma once

#include <array>
#include <span>

#include "oracle/bounded.hpp"
#include "oracle/stretch.hpp"

/// The stages of truth, each behind a function that rounds to nearest when it returns.
namespace rayaudit::oracle {

/// The outline of each case in CGAL's intervals, up to its first proper crossing; unsure
/// where an interval does not tell a sign. The cases are valid.
void outline_by_intervals(std::span<const Case* const> cases, std::span<Outline> outlines);

/// The outline of a valid case in exact numbers, never unsure.
Outline outline_exactly(const Case& question);

/// The t of every root, each at its place, in double-word numbers with their proved bound, for
/// every case whose outline has a crossing.
using Values = std::array<Bounded, Truth::most_roots>;
void values_by_bounds(std::span<const Case* const> cases, std::span<const Outline> outlines,
                      std::span<Values> values);

/// What integers find: of a line that lies in a patch the stretch, whose ends that are roots have
/// the first two values.
struct InIntegers {
  Outline outline;
  bool constant;  ///< as ExactRoots has it
  Stretch stretch;
  Values values;
};

/// Settles a valid case, up to its first proper crossing or with all its roots, in whole numbers of
/// the units that its own are multiples of; false where its largest takes more bits than allowed of
/// its unit, or that is no power near 1. A range may take more bits than that.
bool settle_in_integers(const Case& question, int most_bits, bool all, InIntegers& found);
/// The widths there are: a case takes the first that it fits.
inline constexpr std::array widths_of_integers = {18, 59, 123};

}  // namespace rayaudit::oracle
