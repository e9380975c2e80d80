#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "audit/judge.hpp"

namespace rayaudit {

/// So many margins of each chunk and subject may be worked out in exact numbers; beyond, a case
/// that needs them is not looked at for the largest margin, nor counted in the curve.
inline constexpr std::size_t slow_margins_a_chunk = 16;

/// The margins of a chunk's cases, of which only some few may take long.
class Margins {
 public:
  /// A thorough one works out all, however long it takes.
  Margins(const Format& format, bool thorough)
      : precision_(format.precision), is_thorough_(thorough) {}

  /// The margin of a case in u of the format; NaN for an invalid one, and where it would take long
  /// and this has been so too often.
  double of(Settled& settled) {
    const std::optional<double> quick = settled.quick_reach();
    if (!quick && !is_thorough_ && ++slow_ > slow_margins_a_chunk) return Judgement::unmeasured;
    return std::ldexp(quick ? *quick : settled.reach(), precision_);
  }

 private:
  int precision_;
  bool is_thorough_;
  std::size_t slow_ = 0;
};

}  // namespace rayaudit
