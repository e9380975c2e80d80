#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "audit/cause.hpp"
#include "audit/certificate.hpp"
#include "audit/histogram.hpp"
#include "audit/judge.hpp"
#include "audit/margin_curve.hpp"
#include "audit/worst.hpp"

namespace rayaudit {

/// The causes found for wrong answers of one kind.
struct CauseCount {
  /// A comparison that was seen turned, and how often.
  struct Turned {
    std::string_view file;
    int line;
    std::string_view text;
    std::uint64_t count;

    auto key() const { return std::tie(file, line); }
  };
  /// What a formula or an assumption was found to be about, and how often.
  struct About {
    Cause cause;
    std::string_view about;
    std::uint64_t count;

    auto key() const { return std::tie(cause, about); }
  };

  std::array<std::uint64_t, cause_count> counts = {};
  std::vector<Turned> turned = {};  ///< by file and line
  std::vector<About> about = {};    ///< by cause and words

  std::uint64_t of(Cause cause) const { return counts[static_cast<std::size_t>(cause)]; }
  std::uint64_t replayed() const;
  void add(const Diagnosis& diagnosis);
  void merge(const CauseCount& other);
};

/// The cases of one verdict that make one claim, and the worst of them: of wrong ones the one with
/// the largest margin, of others the one with the most ulps.
struct Outcome {
  Verdict verdict;
  Claim claim;
  std::uint64_t count = 0;
  std::optional<Worst> worst = {};
  CauseCount causes = {};             ///< of the share that was replayed
  std::uint64_t beyond_rounding = 0;  ///< those of them that a run found rounding not to excuse
};

/// How many of the cases each cause is likely to account for, by those that were replayed; by the
/// worst alone where none was.
using CauseShare = std::array<double, cause_count>;
CauseShare by_cause(const Outcome& outcome);
void add(CauseShare& sum, const CauseShare& other);

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
  std::array<TouchCount, 7> touches = {};                          ///< by oracle::Kind
  std::array<std::uint64_t, oracle::stage_count> decided_by = {};  ///< by oracle::Stage
  std::uint64_t bare = 0;  ///< answers that say yes and not where
  /// Cases that were not put to a subject, for it had crashed or timed out too often; not in cases.
  std::uint64_t unasked = 0;
  Histogram ulps, forced, own, distance, condition;
  /// The largest own error of hits that are no matter of convention; NaN where there are none.
  double proper_own = Judgement::unmeasured;
  std::optional<Worst> worst_ulps = {}, worst_forced = {}, worst_own = {};
  MarginCurve curve;  ///< of the share that is looked into closely
  Certificate certificate;
  std::array<std::uint64_t, 4> stages = {};  ///< of a subject that works in stages, from 1

  std::uint64_t of(Verdict verdict) const { return verdicts[static_cast<std::size_t>(verdict)]; }
  std::uint64_t of(Claim claim) const;
  std::uint64_t of(oracle::Stage stage) const {
    return decided_by[static_cast<std::size_t>(stage)];
  }
  /// The cases whose truth is known: all but the invalid ones.
  std::uint64_t decided() const {
    return std::accumulate(decided_by.begin(), decided_by.end(), std::uint64_t{0});
  }
  /// The worst case of a verdict, or null where there is none.
  const Worst* worst(Verdict verdict) const;
  /// The wrong case with the largest margin, invalid cases aside, or null where there is none.
  const Worst* widest() const;
  std::uint64_t wrong() const;
  /// The causes of all wrong answers, and of right ones that were off by more than they may be.
  CauseCount causes() const;
  /// The wrong answers by cause, of each outcome as those that were replayed; not invalid cases.
  CauseShare wrong_by_cause() const;
  /// The outcome of a verdict and claim, made where it has not occurred.
  Outcome& outcome(Verdict verdict, Claim claim);
  /// Adds a judged answer to a case of a margin in u, NaN where it is not known.
  void add(const Settled& settled, const Answer& answer, const Judgement& judgement,
           std::uint64_t place, double margin, bool beyond_rounding = false);
  void merge(const Tally& other);
};

}  // namespace rayaudit
