#include "audit/accuracy.hpp"

#include <cmath>

namespace rayaudit {
namespace {

/// The worst error, where not telling t is worse than any and no proper hit as good as none.
double error_of(const Accuracy& accuracy) {
  if (accuracy.bare > 0) return std::numeric_limits<double>::infinity();
  return std::isnan(accuracy.error) ? 0 : accuracy.error;
}

/// The power of two nearest to it, as its exponent.
double scale_of(const Accuracy& accuracy) { return std::round(std::log2(error_of(accuracy))); }

/// How far chance may move a share of wrong answers: twice the deviation of a count.
double chance(const Accuracy& accuracy) {
  const double cases = static_cast<double>(accuracy.cases);
  return 2 * std::sqrt(accuracy.share() / cases);
}

}  // namespace

void Accuracy::add(const Tally& tally, const Format& format) {
  Accuracy one = {tally.cases, tally.wrong(), tally.verdicts, tally.bare};
  if (const Worst* widest = tally.widest()) one.wrong_margin = widest->severity;
  if (tally.ulps.count() > 0) one.ulps = tally.ulps.largest();
  one.error = std::ldexp(tally.proper_own, float_format.precision - format.precision);
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
  if (const auto by_share = a.share() <=> b.share(); std::is_neq(by_share)) return by_share;
  return scale_of(a) <=> scale_of(b);
}

bool is_clearly_more_accurate(const Accuracy& a, const Accuracy& b) {
  if (a.wrong == 0 && b.wrong > 0) return true;
  const double less = b.share() - a.share();
  const double by_chance = std::hypot(chance(a), chance(b));
  if (std::fabs(less) > by_chance) return less > 0;
  return 2 * error_of(a) <= error_of(b) && error_of(b) > 0;
}

}  // namespace rayaudit
