#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

namespace rayaudit {

/// How many of the cases at each margin, in powers of two of u, are answered wrongly.
class MarginCurve {
 public:
  /// The first step holds all margins below too, the last all above, also those without end.
  static constexpr int least = -10, most = 40;

  struct Step {
    std::uint64_t cases = 0, wrong = 0;
  };

  /// A margin of 0 is a touch, and off the curve.
  void add(double margin, bool wrong) {
    if (!(margin > 0)) return;
    Step& step = steps_[std::clamp(exponent(margin), least, most) - least];
    ++step.cases;
    step.wrong += wrong;
  }
  void merge(const MarginCurve& other) {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      steps_[i].cases += other.steps_[i].cases;
      steps_[i].wrong += other.steps_[i].wrong;
    }
  }
  /// The least exponent with at least the share p of all cases at or below it; nothing where there
  /// are none.
  std::optional<int> quantile(double p) const {
    std::uint64_t all = 0, seen = 0;
    for (const Step& step : steps_) all += step.cases;
    if (all == 0) return {};
    int exponent = least;
    while (static_cast<double>(seen += at(exponent).cases) < p * static_cast<double>(all))
      ++exponent;
    return exponent;
  }
  /// The cases with a margin from 2^exponent to 2^(exponent + 1).
  const Step& at(int exponent) const { return steps_[exponent - least]; }
  /// All that it holds, to be written and read exactly.
  auto parts() { return std::tie(steps_); }
  auto parts() const { return std::tie(steps_); }

 private:
  static int exponent(double margin) { return std::isinf(margin) ? most : std::ilogb(margin); }

  std::array<Step, most - least + 1> steps_ = {};
};

}  // namespace rayaudit
