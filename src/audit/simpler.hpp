#pragma once

#include <compare>
#include <vector>

#include "geometry/case.hpp"
#include "geometry/format.hpp"

/// Cases that are simpler than another, one step away from it.
namespace rayaudit {

/// How far a case is from a simple one, what counts most first.
struct Simplicity {
  /// Components that are not 0, or in which the two ends of an axis differ, with what of radius and
  /// range is not 1, 0 and infinite.
  int apart = 0;
  int large = 0;  ///< numbers that are no whole numbers from -8 to 8
  int bits = 0;   ///< of all significands
  int size = 0;   ///< of all exponents, by how far they are from 0
  int signs = 0;  ///< numbers below 0, a -0 too

  // NOLINTNEXTLINE(modernize-use-nullptr): clang-tidy 14 takes the 0 of orderings for a pointer.
  friend auto operator<=>(const Simplicity&, const Simplicity&) = default;
};
Simplicity simplicity(const Case& question);

/// Every case that is one step away and simpler, the simplest first; where the format holds the
/// numbers of the case, it holds those of each.
std::vector<Case> simpler(const Case& question, const Format& format);

}  // namespace rayaudit
