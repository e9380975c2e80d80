#include "audit/histogram.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rayaudit {

void Histogram::add(double value) {
  if (std::isnan(value)) return;
  ++count_;
  largest_ = std::max(largest_, value);
  const int last = octaves * steps + 1;
  int bin = 0;
  if (value >= std::ldexp(1.0, least_exponent)) {
    int exponent = 0;
    const double fraction = std::frexp(std::min(value, 0x1p1000), &exponent);  // in [1/2, 1)
    const int step = static_cast<int>((fraction - 0.5) * (2 * steps));
    bin = std::min(last, 1 + (exponent - 1 - least_exponent) * steps + step);
  }
  ++counts_[bin];
}

void Histogram::merge(const Histogram& other) {
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  count_ += other.count_;
  largest_ = std::max(largest_, other.largest_);
}

std::uint64_t Histogram::octave(int exponent) const {
  if (exponent == least_octave) return counts_.front();
  if (exponent == most_octave) return counts_.back();
  const std::ptrdiff_t octaves_below = exponent - least_exponent;
  const auto first = counts_.begin() + 1 + octaves_below * steps;
  return std::accumulate(first, first + steps, std::uint64_t{0});
}

double Histogram::quantile(double p) const {
  if (count_ == 0) return 0;
  const auto wanted = static_cast<std::uint64_t>(std::ceil(p * static_cast<double>(count_)));
  std::uint64_t seen = 0;
  int bin = 0;
  while ((seen += counts_[bin]) < wanted) ++bin;
  if (bin == octaves * steps + 1) return largest_;
  const double above = std::ldexp(1 + (bin % steps) / double{steps}, bin / steps + least_exponent);
  return std::min(above, largest_);
}

}  // namespace rayaudit
