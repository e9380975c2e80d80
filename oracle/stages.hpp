#pragma once

#include <span>

#include "oracle/bounded.hpp"
#include "oracle/settle.hpp"

/// The stages of truth, each behind a function that rounds to nearest when it returns.
namespace rayaudit::oracle {

/// Stage 1: the outline of each case in CGAL's intervals, up to its first proper crossing; unsure
/// where an interval does not tell a sign. The cases are valid.
void outline_by_intervals(std::span<const Case* const> cases, std::span<Outline> outlines);

/// Stage 2: the outline of a valid case in exact numbers, never unsure.
Outline outline_exactly(const Case& question);

/// The t of every root, each at its place, in double-word numbers with their proved bound, for
/// every case whose outline has a crossing.
using Values = std::array<Bounded, Truth::most_roots>;
void values_by_bounds(std::span<const Case* const> cases, std::span<const Outline> outlines,
                      std::span<Values> values);

}  // namespace rayaudit::oracle
