#include "audit/accuracy.hpp"

#include <cmath>

namespace rayaudit {
namespace {

/// The power of two nearest to the worst error, as its exponent.
double scale_of(const Accuracy& accuracy) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  if (accuracy.bare > 0) return infinity;
  return std::isnan(accuracy.error) ? -infinity : std::round(std::log2(accuracy.error));
}

}  // namespace

void Accuracy::add(const Tally& tally, const Format& format) {
  Accuracy one = {tally.cases, tally.wrong(), tally.verdicts, tally.bare};
  if (const Worst* widest = tally.widest()) one.wrong_margin = widest->severity;
  if (tally.ulps.count() > 0) one.ulps = tally.ulps.largest();
  one.error = std::ldexp(tally.proper_ulps, float_format.precision - format.precision);
  if (tally.forced.count() > 0) one.forced = tally.forced.largest();
  add(one);
}

void Accuracy::add(const Accuracy& other) {
  cases += other.cases;
  wrong += other.wrong;
  bare += other.bare;
  for (std::size_t i = 0; i < verdict_count; ++i) verdicts[i] += other.verdicts[i];
  // Of a number and a NaN, the number.
  wrong_margin = std::fmax(wrong_margin, other.wrong_margin);
  ulps = std::fmax(ulps, other.ulps);
  forced = std::fmax(forced, other.forced);
  error = std::fmax(error, other.error);
}

std::partial_ordering operator<=>(const Accuracy& a, const Accuracy& b) {
  if (const auto by_share = a.share() <=> b.share(); by_share != 0) return by_share;
  return scale_of(a) <=> scale_of(b);
}

}  // namespace rayaudit
