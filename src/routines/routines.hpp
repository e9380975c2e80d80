#pragma once

#include <tuple>

#include "routines/closest_approach.hpp"
#include "routines/division_free.hpp"
#include "routines/handout.hpp"
#include "routines/stable_quadratic.hpp"
#include "routines/textbook.hpp"
#include "routines/unit_direction.hpp"
#include "routines/unit_space.hpp"

namespace rayaudit {

/// Every routine there is. A new one is a header beside this file and a word in this list.
using Routines = std::tuple<Handout, Textbook, UnitDirection, UnitSpace, StableQuadratic,
                            ClosestApproach, DivisionFree>;

}  // namespace rayaudit
