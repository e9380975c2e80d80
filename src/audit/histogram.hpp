#pragma once

#include <array>
#include <cstdint>
#include <tuple>

namespace rayaudit {

/// Counts of non-negative numbers in eighths of an octave: quantiles that merge exactly.
class Histogram {
  static constexpr int least_exponent = -10, octaves = 140, steps = 8;

 public:
  static constexpr int least_octave = least_exponent - 1, most_octave = least_exponent + octaves;

  void add(double value);
  void merge(const Histogram& other);
  std::uint64_t count() const { return count_; }
  /// A number that at least the share p of all values do not exceed, an eighth of an octave sharp,
  /// and never above the largest value; 0 where there are none.
  double quantile(double p) const;
  double largest() const { return largest_; }
  /// How many values lie from 2^exponent to 2^(exponent + 1), for exponents from least_octave to
  /// most_octave: the first holds all that are smaller too, the last all that are larger.
  std::uint64_t octave(int exponent) const;
  /// All that it holds, to be written and read exactly.
  auto parts() { return std::tie(counts_, count_, largest_); }
  auto parts() const { return std::tie(counts_, count_, largest_); }

 private:
  std::array<std::uint64_t, octaves* steps + 2> counts_ = {};  ///< first: below, last: above
  std::uint64_t count_ = 0;
  double largest_ = 0;
};

}  // namespace rayaudit
