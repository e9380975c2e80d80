#include "audit/accuracy.hpp"

#include <cmath>

namespace rayaudit {
namespace {

/// The nearest power of two, as its exponent.
double scale_of(double error) {
  if (std::isnan(error)) return std::numeric_limits<double>::infinity();
  return std::round(std::log2(error));
}

}  // namespace

void Accuracy::add(const Tally& tally, const Format& format) {
  Accuracy one = {tally.cases, tally.wrong(), tally.verdicts};
  if (const Worst* widest = tally.widest()) one.wrong_margin = widest->severity;
  if (tally.ulps.count() > 0) {
    one.ulps = tally.ulps.largest();
    one.error = std::ldexp(one.ulps, float_format.precision - format.precision);
  }
  if (tally.forced.count() > 0) one.forced = tally.forced.largest();
  add(one);
}

void Accuracy::add(const Accuracy& other) {
  cases += other.cases;
  wrong += other.wrong;
  for (std::size_t i = 0; i < verdict_count; ++i) verdicts[i] += other.verdicts[i];
  // Of a number and a NaN, the number.
  wrong_margin = std::fmax(wrong_margin, other.wrong_margin);
  ulps = std::fmax(ulps, other.ulps);
  forced = std::fmax(forced, other.forced);
  error = std::fmax(error, other.error);
}

std::partial_ordering operator<=>(const Accuracy& a, const Accuracy& b) {
  if (const auto by_share = a.share() <=> b.share(); by_share != 0) return by_share;
  return scale_of(a.error) <=> scale_of(b.error);
}

}  // namespace rayaudit
