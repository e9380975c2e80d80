#include "audit/tally.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rayaudit {
namespace {

/// How bad a case is of its verdict's kind: a wrong one the more, the further it lies from any case
/// with another truth; else the more its t is off.
double severity(const Judgement& judgement, double margin) {
  if (is_wrong(judgement.verdict)) return std::isnan(margin) ? 0 : margin;
  return std::isnan(judgement.ulps) ? 0 : judgement.ulps;
}

/// Builds the Worst only where it will be kept.
void note(std::optional<Worst>& kept, double severity, std::uint64_t place, const Settled& settled,
          const Answer& answer, const Judgement& judgement, bool beyond_rounding = false) {
  if (kept &&
      (kept->beyond_rounding != beyond_rounding
           ? kept->beyond_rounding
           : !(severity > kept->severity || (severity == kept->severity && place < kept->place))))
    return;
  kept = Worst{severity, place, settled.question(), answer, judgement, {}};
  kept->beyond_rounding = beyond_rounding;
}

/// Adds to the count of an element, in its place among the others.
template <class Element>
void count_in(std::vector<Element>& list, const Element& element) {
  const auto place = std::find_if(list.begin(), list.end(),
                                  [&](const Element& each) { return each.key() >= element.key(); });
  if (place != list.end() && place->key() == element.key())
    place->count += element.count;
  else
    list.insert(place, element);
}

}  // namespace

std::uint64_t CauseCount::replayed() const {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : counts) sum += count;
  return sum;
}

void CauseCount::add(const Diagnosis& diagnosis) {
  ++counts[static_cast<std::size_t>(diagnosis.cause)];
  if (const auto& step = diagnosis.turned)
    count_in(turned, Turned{step->file, step->line, step->text, 1});
  if (!diagnosis.about.empty()) count_in(about, About{diagnosis.cause, diagnosis.about, 1});
}

void CauseCount::merge(const CauseCount& other) {
  for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += other.counts[i];
  for (const Turned& each : other.turned) count_in(turned, each);
  for (const About& each : other.about) count_in(about, each);
}

CauseShare by_cause(const Outcome& outcome) {
  CauseShare share = {};
  const auto count = static_cast<double>(outcome.count);
  const auto replayed = static_cast<double>(outcome.causes.replayed());
  if (replayed == 0 && outcome.worst)
    share[static_cast<std::size_t>(outcome.worst->diagnosis.cause)] = count;
  for (std::size_t i = 0; replayed > 0 && i < cause_count; ++i)
    share[i] = count * static_cast<double>(outcome.causes.counts[i]) / replayed;
  return share;
}

void add(CauseShare& sum, const CauseShare& other) {
  for (std::size_t i = 0; i < cause_count; ++i) sum[i] += other[i];
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

const Worst* Tally::widest() const {
  const Worst* found = nullptr;
  for (const Outcome& each : outcomes)
    if (is_wrong(each.verdict) && each.verdict != Verdict::invalid_mishandled && each.worst &&
        (found == nullptr || is_worse(*each.worst, *found)))
      found = &*each.worst;
  return found;
}

CauseCount Tally::causes() const {
  CauseCount sum;
  for (const Outcome& each : outcomes) sum.merge(each.causes);
  return sum;
}

CauseShare Tally::wrong_by_cause() const {
  CauseShare sum = {};
  for (const Outcome& each : outcomes)
    if (is_wrong(each.verdict) && each.verdict != Verdict::invalid_mishandled)
      rayaudit::add(sum, by_cause(each));
  return sum;
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

void Tally::add(const Settled& settled, const Answer& answer, const Judgement& judgement,
                std::uint64_t place, double margin, bool beyond_rounding) {
  ++cases;
  ++verdicts[static_cast<std::size_t>(judgement.verdict)];
  if (judgement.side != Side::unknown) ++sides[static_cast<std::size_t>(judgement.side)];
  if (judgement.touch) {
    TouchCount& seen = touches[static_cast<std::size_t>(*judgement.touch)];
    ++(judgement.taken ? seen.taken : seen.passed);
  }
  if (settled.truth().invalid == oracle::Invalid::no)
    ++decided_by[static_cast<std::size_t>(settled.truth().stage)];
  bare += answer.form == Answer::Form::yes;
  if (judgement.verdict != Verdict::touch) proper_own = std::fmax(proper_own, judgement.own);
  ulps.add(judgement.ulps);
  forced.add(judgement.forced);
  own.add(judgement.own);
  distance.add(judgement.distance);
  condition.add(judgement.condition);
  Outcome& here = outcome(judgement.verdict, judgement.claim);
  ++here.count;
  here.beyond_rounding += beyond_rounding;
  note(here.worst, severity(judgement, margin), place, settled, answer, judgement, beyond_rounding);
  if (!std::isnan(judgement.ulps))
    note(worst_ulps, judgement.ulps, place, settled, answer, judgement);
  if (!std::isnan(judgement.forced))
    note(worst_forced, judgement.forced, place, settled, answer, judgement);
  if (!std::isnan(judgement.own)) note(worst_own, judgement.own, place, settled, answer, judgement);
  if (answer.stage > 0) ++stages[answer.stage];
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
  add_all(decided_by, other.decided_by);
  bare += other.bare;
  unasked += other.unasked;
  proper_own = std::fmax(proper_own, other.proper_own);
  ulps.merge(other.ulps);
  forced.merge(other.forced);
  own.merge(other.own);
  distance.merge(other.distance);
  condition.merge(other.condition);
  for (const Outcome& theirs : other.outcomes) {
    Outcome& ours = outcome(theirs.verdict, theirs.claim);
    ours.count += theirs.count;
    ours.beyond_rounding += theirs.beyond_rounding;
    if (theirs.worst) keep_worse(ours.worst, *theirs.worst);
    ours.causes.merge(theirs.causes);
  }
  curve.merge(other.curve);
  certificate.merge(other.certificate);
  add_all(stages, other.stages);
  if (other.worst_ulps) keep_worse(worst_ulps, *other.worst_ulps);
  if (other.worst_forced) keep_worse(worst_forced, *other.worst_forced);
  if (other.worst_own) keep_worse(worst_own, *other.worst_own);
}

}  // namespace rayaudit
