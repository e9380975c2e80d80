#pragma once

#include <compare>
#include <limits>

#include "audit/tally.hpp"

namespace rayaudit {

/// How right a subject is, over one audit or several: what its price is held against.
struct Accuracy {
  static constexpr double unmeasured = Judgement::unmeasured;

  std::uint64_t cases = 0, wrong = 0;
  std::array<std::uint64_t, verdict_count> verdicts = {};
  std::uint64_t bare = 0;            ///< answers that say yes and not where
  double wrong_margin = unmeasured;  ///< the largest, in u of the subject's format
  double ulps = unmeasured;          ///< the largest error of t, in the subject's format
  double forced = unmeasured;        ///< the same in units of what rounding the case once would do
  /// The largest of its own of proper hits, in units of float: of the larger of an ulp and the
  /// forced error in float, whatever the format.
  double error = unmeasured;

  void add(const Tally& tally, const Format& format);
  void add(const Accuracy& other);

  double share() const { return static_cast<double>(wrong) / static_cast<double>(cases); }
  double per_million(Verdict verdict) const {
    return 1e6 * static_cast<double>(verdicts[static_cast<std::size_t>(verdict)]) /
           static_cast<double>(cases);
  }
};

/// Less is more accurate: fewer wrong answers, or as many and a worst error of a smaller power of
/// two. Who says yes and not where comes after all that tell t; who had no proper hit to tell,
/// before.
std::partial_ordering operator<=>(const Accuracy& a, const Accuracy& b);

/// Is a more accurate, and not by chance: never wrong where b is, or less often by more than twice
/// the deviation of the counts, or neither and its worst error half as large at most?
bool is_clearly_more_accurate(const Accuracy& a, const Accuracy& b);

}  // namespace rayaudit
