#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace rayaudit {

/// The median of what rounds measured, and the quartiles around it.
struct Spread {
  double low = 0, median = 0, high = 0;
};

/// The spread of at least one number.
inline Spread spread(std::vector<double> rounds) {
  std::sort(rounds.begin(), rounds.end());
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(rounds.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double rest = place - static_cast<double>(below);
    return rest == 0 ? rounds[below] : rounds[below] * (1 - rest) + rounds[below + 1] * rest;
  };
  return {at(0.25), at(0.5), at(0.75)};
}

/// Nothing is concluded from medians that differ by less than this share, or where spreads overlap.
inline constexpr double apart = 0.1;

inline bool is_clearly_less(const Spread& a, const Spread& b) {
  return a.high < b.low && a.median * (1 + apart) < b.median;
}

}  // namespace rayaudit
