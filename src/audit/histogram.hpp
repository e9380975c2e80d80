#pragma once

#include <array>
#include <cstdint>

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

}  // namespace rayaudit
