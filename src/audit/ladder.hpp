#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace rayaudit {

/// One family at rising difficulty k, up to where the format itself gives out.
struct LadderPlan {
  std::vector<const Subject*> subjects;
  const Family* family = nullptr;  ///< one that has a difficulty
  std::vector<std::size_t> shapes;
  std::uint64_t cases = 0;  ///< for each subject and shape at each k
  std::uint64_t seed = 0;
  std::vector<Bound> bounds;  ///< what subjects are held to
  int threads = 0;            ///< 0: one for each processor
};

/// The most rungs that a ladder has: beyond, k rises by more than 1.
inline constexpr int most_rungs = 64;

/// What a subject is held to that no other bound speaks of: errors of its own up to 64 units, and
/// no wrong answer that a change of the numbers by more than 16 u would not excuse.
Bound yardstick(const Family& family);

/// Half of the errors, 99 of 100 and all do not exceed these; NaN where none was measured.
struct Errors {
  double half, most, all;
};

/// A subject at one difficulty.
struct Rung {
  int k = 0;
  std::uint64_t cases = 0, wrong = 0;
  Errors ulps, forced, own;
  Errors condition;  ///< what rounding the case once would do to t, in ulps
  /// Margins that a tenth and half of the cases do not exceed, in u, as powers of two, of the share
  /// that is looked into closely; nothing where all are touches.
  std::optional<int> narrow_margin, half_margin;
};

/// Powers of two by which an error rises with each k, by least squares over rungs with a few hits;
/// NaN where there are less than three such. Ulps and condition are those of half of the hits, to
/// be held against each other; the error of its own is that which 99 of 100 hits keep.
struct Slopes {
  double ulps, own, condition;
};

/// The limit that broke first.
struct Break {
  int k;
  Bound bound;
  Limit limit;
  double seen;
  std::optional<Worst> worst;  ///< nothing where cases were left unasked and none is wrong
};

/// One subject on one shape, from the lowest rung to the highest of its format.
struct Climb {
  const Subject* subject;
  std::size_t shape;
  std::vector<Bound> held_to = {};
  std::vector<Rung> rungs = {};
  std::optional<Break> broken = {};
  Slopes slopes = {};

  /// The last k up to which every bound is held; nothing where the first rung breaks one.
  std::optional<int> holds_to() const;
};

/// The difficulties of the family in a format.
std::vector<int> rungs_of(const Family& family, const Format& format);

/// Climbs with every subject on every shape, in the order of the plan; empty where nothing fits.
std::vector<Climb> climb(const LadderPlan& plan, const std::function<void(Progress)>& tell = {});

}  // namespace rayaudit
