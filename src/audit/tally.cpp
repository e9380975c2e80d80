#include "audit/tally.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rayaudit {
namespace {

/// How bad a case is of its verdict's kind. A miss is the worse the less its hit depends on the
/// last bits of the inputs: |t| / (sum |x_j dt/dx_j|) is 1 at most, and near 0 at a grazing hit.
double severity(Settled& settled, const Judgement& judgement) {
  if (judgement.verdict == Verdict::false_miss) {
    const Real& forced = settled.sensitivity(judgement.crossing).forced;
    const Real& t = settled.truth().crossings()[judgement.crossing].t;
    if (!is_finite(forced) || sign(forced) == 0) return 0;
    const int e = binade(forced);
    return std::fabs(scaled(t, e) / scaled(forced, e));
  }
  return std::isnan(judgement.ulps) ? 0 : judgement.ulps;
}

bool is_worse(const Worst& a, const Worst& b) {
  return a.severity != b.severity ? a.severity > b.severity : a.place < b.place;
}

void keep_worse(std::optional<Worst>& kept, const Worst& other) {
  if (!kept || is_worse(other, *kept)) kept = other;
}

/// Builds the Worst only where it will be kept.
void note(std::optional<Worst>& kept, double severity, std::uint64_t place, const Settled& settled,
          const Answer& answer, const Judgement& judgement) {
  if (kept && !(severity > kept->severity || (severity == kept->severity && place < kept->place)))
    return;
  kept = Worst{severity, place, settled.question(), answer, judgement};
}

}  // namespace

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

std::uint64_t Tally::of(Claim claim) const {
  std::uint64_t sum = 0;
  for (const Outcome& each : outcomes)
    if (each.claim == claim) sum += each.count;
  return sum;
}

const Worst* Tally::worst(Verdict verdict) const {
  const Worst* found = nullptr;
  for (const Outcome& each : outcomes)
    if (each.verdict == verdict && each.worst &&
        (found == nullptr || is_worse(*each.worst, *found)))
      found = &*each.worst;
  return found;
}

Outcome& Tally::outcome(Verdict verdict, Claim claim) {
  const auto place = std::find_if(outcomes.begin(), outcomes.end(), [&](const Outcome& each) {
    return std::tie(each.verdict, each.claim) >= std::tie(verdict, claim);
  });
  if (place != outcomes.end() && place->verdict == verdict && place->claim == claim) return *place;
  return *outcomes.insert(place, {verdict, claim});
}

std::uint64_t Tally::wrong() const {
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (is_wrong(static_cast<Verdict>(i))) sum += verdicts[i];
  return sum;
}

void Tally::add(Settled& settled, const Answer& answer, const Judgement& judgement,
                std::uint64_t place) {
  ++cases;
  ++verdicts[static_cast<std::size_t>(judgement.verdict)];
  if (judgement.side != Side::unknown) ++sides[static_cast<std::size_t>(judgement.side)];
  if (judgement.touch) {
    TouchCount& seen = touches[static_cast<std::size_t>(*judgement.touch)];
    ++(judgement.taken ? seen.taken : seen.passed);
  }
  if (settled.truth().invalid == oracle::Invalid::no)
    ++(settled.truth().stage == oracle::Stage::interval ? by_interval : by_exact);
  ulps.add(judgement.ulps);
  forced.add(judgement.forced);
  distance.add(judgement.distance);
  Outcome& here = outcome(judgement.verdict, judgement.claim);
  ++here.count;
  note(here.worst, severity(settled, judgement), place, settled, answer, judgement);
  if (!std::isnan(judgement.forced))
    note(worst_forced, judgement.forced, place, settled, answer, judgement);
}

void Tally::merge(const Tally& other) {
  const auto add_all = [](auto& into, const auto& from) {
    for (std::size_t i = 0; i < into.size(); ++i) into[i] += from[i];
  };
  cases += other.cases;
  add_all(verdicts, other.verdicts);
  add_all(sides, other.sides);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    touches[i].taken += other.touches[i].taken;
    touches[i].passed += other.touches[i].passed;
  }
  by_interval += other.by_interval;
  by_exact += other.by_exact;
  ulps.merge(other.ulps);
  forced.merge(other.forced);
  distance.merge(other.distance);
  for (const Outcome& theirs : other.outcomes) {
    Outcome& ours = outcome(theirs.verdict, theirs.claim);
    ours.count += theirs.count;
    if (theirs.worst) keep_worse(ours.worst, *theirs.worst);
  }
  if (other.worst_forced) keep_worse(worst_forced, *other.worst_forced);
}

}  // namespace rayaudit
