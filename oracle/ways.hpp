#pragma once

#include <span>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"

/// Ways to answer a case with the oracle's fields: in intervals alone, in exact numbers alone, or
/// as the truth does it. Each takes the first proper crossing, passes by every touch, and misses an
/// invalid case; what it costs is its own.
namespace rayaudit::oracle {

/// answers[i] is the answer to cases[i]. Throws UnfitArithmetic (oracle/environment.hpp) in a
/// thread that does not compute as IEEE 754 has it.
using Way = void(std::span<const Case> cases, std::span<Answer> answers);

/// In CGAL::Interval_nt. Where that proves every sign, and t to 2^-8 |t|, the answer is proved and
/// its stage is 1; t is the middle of its interval. Elsewhere the same fields in plain double
/// guess: stage 2.
Way answer_by_intervals;

/// In CGAL::Mpzf, with no intervals in front; never wrong, t correctly rounded to double.
Way answer_by_mpzf;
/// The same in CGAL::Gmpq.
Way answer_by_gmpq;
/// In the lazy numbers of CGAL's kernel with exact predicates and constructions; never wrong. t is
/// computed in double from what CGAL::to_double tells of the field, and kept where it is within
/// 2^-40 |t|, else correctly rounded: to round each would make each number exact.
Way answer_by_epeck;

/// In the numbers of that kernel with roots (CORE::Expr), which hold the root itself; never wrong,
/// t correctly rounded to double, by the signs of CORE: its own double of a number is cut off, and
/// may be 0 where exponents are far apart. One batch at a time in the whole program, for CORE is
/// not safe in threads.
Way answer_by_epeck_sqrt;

/// By the truth, t correctly rounded to double; the stage is 1 where lanes decided, 2
/// where intervals did, 3 where exact numbers.
Way answer_by_truth;

}  // namespace rayaudit::oracle
