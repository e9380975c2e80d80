#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "audit/judge.hpp"

namespace rayaudit {

/// Counts of non-negative numbers in eighths of an octave: quantiles that merge exactly.
class Histogram {
 public:
  void add(double value);
  void merge(const Histogram& other);
  std::uint64_t count() const { return count_; }
  /// A number that at least the share p of all values do not exceed, an eighth of an octave sharp,
  /// and never above the largest value; 0 where there are none.
  double quantile(double p) const;
  double largest() const { return largest_; }

 private:
  static constexpr int least_exponent = -10, octaves = 140, steps = 8;

  std::array<std::uint64_t, octaves* steps + 2> counts_ = {};  ///< first: below, last: above
  std::uint64_t count_ = 0;
  double largest_ = 0;
};

/// The worst case of a kind, kept whole.
struct Worst {
  double severity = 0;
  std::uint64_t place = 0;  ///< which case of the audit it was, from 0
  Case question = {};
  Answer answer = {};
  Judgement judgement = {};
};

/// The cases of one verdict that make one claim, and the worst of them: of hits that were measured
/// the one with the most ulps; of false misses the best conditioned; of the rest the first.
struct Outcome {
  Verdict verdict;
  Claim claim;
  std::uint64_t count = 0;
  std::optional<Worst> worst = {};
};

/// What became of the touches of one kind on offer.
struct TouchCount {
  std::uint64_t taken = 0, passed = 0;
};

/// All verdicts of one subject on one shape and family. Merging is exact and in any order.
struct Tally {
  std::uint64_t cases = 0;
  std::array<std::uint64_t, verdict_count> verdicts = {};
  std::vector<Outcome> outcomes = {};  ///< those that occurred, by verdict, then claim
  std::array<std::uint64_t, side_count> sides = {};
  std::array<TouchCount, 7> touches = {};  ///< by oracle::Kind
  std::uint64_t by_interval = 0, by_exact = 0;
  Histogram ulps, forced, distance;
  std::optional<Worst> worst_forced = {};

  std::uint64_t of(Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
  std::uint64_t of(Claim claim) const;
  /// The worst case of a verdict, or null where there is none.
  const Worst* worst(Verdict verdict) const;
  std::uint64_t wrong() const;
  /// The outcome of a verdict and claim, made where it has not occurred.
  Outcome& outcome(Verdict verdict, Claim claim);
  void add(Settled& settled, const Answer& answer, const Judgement& judgement, std::uint64_t place);
  void merge(const Tally& other);
};

}  // namespace rayaudit
