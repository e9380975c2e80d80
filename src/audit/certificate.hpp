#pragma once

#include <cstdint>

#include "audit/cause.hpp"
#include "audit/histogram.hpp"
#include "audit/worst.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// What running error bounds prove of a subject, beside what its errors were seen to be: both are
/// distances from the same routine without rounding, whatever the truth.
struct Certificate {
  /// Observed errors below so many ulps say nothing of how loose a bound is.
  static constexpr double least_observed = 0.01;

  std::uint64_t cases = 0;                ///< that were run with bounds
  std::uint64_t certified = 0;            ///< with every comparison proved, and a finite bound
  std::uint64_t compared = 0;             ///< certified, and held against the exact replay
  std::uint64_t wrong = 0;                ///< of those, that differ from it: a flaw of ours
  Histogram looseness;                    ///< proved / observed of certified hits
  std::optional<Worst> proved, observed;  ///< the largest, in ulps, of the same hits
  std::optional<Worst> first_wrong;

  void add(Settled& settled, const Proved& answer, const replay::Replay& replay,
           const Format& format, std::uint64_t place);
  void merge(const Certificate& other);
};

}  // namespace rayaudit
