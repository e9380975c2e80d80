#include "audit/ladder.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace rayaudit {
namespace {

/// Errors of fewer hits say nothing of how an error rises.
constexpr std::uint64_t fewest_hits = 16;

Errors errors(const Histogram& of) {
  if (of.count() == 0) return {Judgement::unmeasured, Judgement::unmeasured, Judgement::unmeasured};
  return {of.quantile(0.5), of.quantile(0.99), of.largest()};
}

Rung rung(int k, const Tally& tally) {
  return {.k = k,
          .cases = tally.cases,
          .wrong = tally.wrong(),
          .ulps = errors(tally.ulps),
          .forced = errors(tally.forced),
          .own = errors(tally.own),
          .condition = errors(tally.condition),
          .narrow_margin = tally.curve.quantile(0.1),
          .half_margin = tally.curve.quantile(0.5)};
}

/// The slope of log2(value) over k, by least squares.
class Line {
 public:
  void add(int k, double value) {
    if (!(value > 0) || std::isinf(value)) return;
    const double x = k, y = std::log2(value);
    ++count_, x_ += x, y_ += y, xx_ += x * x, xy_ += x * y;
  }
  double slope() const {
    if (count_ < 3) return Judgement::unmeasured;
    return (count_ * xy_ - x_ * y_) / (count_ * xx_ - x_ * x_);
  }

 private:
  double count_ = 0, x_ = 0, y_ = 0, xx_ = 0, xy_ = 0;
};

/// A climb on its way.
struct Climber {
  Climb climb;
  Line ulps = {}, own = {}, condition = {};

  void take(int k, const Audit& audit) {
    const Tally& tally = audit.tally;
    climb.rungs.push_back(rung(k, tally));
    if (tally.own.count() >= fewest_hits) {
      ulps.add(k, tally.ulps.quantile(0.5));
      own.add(k, tally.own.quantile(0.99));
      condition.add(k, tally.condition.quantile(0.5));
    }
    if (climb.broken) return;
    const std::vector alone = {audit};  // what is broken points into it
    const std::vector<Broken> all = broken(climb.held_to, alone);
    if (all.empty()) return;
    const Broken& first = all.front();
    climb.broken = Break{k, *first.bound, first.limit, first.seen, {}};
    if (first.worst != nullptr) climb.broken->worst = *first.worst;
  }
  Climb finished() {
    climb.slopes = {ulps.slope(), own.slope(), condition.slope()};
    return std::move(climb);
  }
};

/// What an audit is held to: the bounds that speak of it, else the yardstick.
std::vector<Bound> bounds_of(const LadderPlan& plan, const Audit& audit) {
  std::vector<Bound> bounds;
  for (const Bound& bound : plan.bounds)
    if (bound.is_about(audit)) bounds.push_back(bound);
  if (bounds.empty()) bounds.push_back(yardstick(*plan.family));
  return bounds;
}

Plan plan_of(const LadderPlan& ladder, const std::vector<const Subject*>& subjects,
             std::optional<int> k) {
  return {.subjects = subjects,
          .families = {ladder.family},
          .shapes = ladder.shapes,
          .cases = ladder.cases,
          .seed = ladder.seed,
          .difficulty = k,
          .causes = false,
          .threads = ladder.threads};
}

bool contains(const std::vector<int>& rungs, int k) { return std::ranges::binary_search(rungs, k); }

}  // namespace

Bound yardstick(const Family& family) {
  const auto limit = [](std::string_view name, double most) {
    return Limit{&*std::ranges::find(quantities(), name, &Quantity::name), most};
  };
  return {"*", "*", std::string(family.id), {limit("max_own", 64), limit("wrong_margin", 16)}};
}

std::optional<int> Climb::holds_to() const {
  std::optional<int> last;
  for (const Rung& rung : rungs)
    if (!broken || rung.k < broken->k) last = rung.k;
  return last;
}

std::vector<int> rungs_of(const Family& family, const Format& format) {
  const int least = family.difficulty->least, most = family.difficulty->most(format);
  const int step = std::max(1, (most - least + most_rungs - 2) / (most_rungs - 1));
  std::vector<int> rungs;
  for (int k = least; k < most; k += step) rungs.push_back(k);
  rungs.push_back(most);
  return rungs;
}

std::vector<Climb> climb(const LadderPlan& plan, const std::function<void(Progress)>& tell) {
  std::vector<Climber> climbers;
  for (const Audit& audit : planned(plan_of(plan, plan.subjects, {})))
    climbers.push_back({{audit.subject, audit.shape, bounds_of(plan, audit)}});
  std::set<int> all_rungs;
  std::uint64_t all = 0, done = 0;
  for (const Climber& each : climbers) {
    const auto rungs = rungs_of(*plan.family, each.climb.subject->drawn_in());
    all_rungs.insert(rungs.begin(), rungs.end());
    all += plan.cases * rungs.size();
  }
  for (const int k : all_rungs) {
    std::vector<const Subject*> subjects;
    for (const Subject* subject : plan.subjects)
      if (contains(rungs_of(*plan.family, subject->drawn_in()), k)) subjects.push_back(subject);
    for (const Audit& audit : run(plan_of(plan, subjects, k))) {
      const auto climber = std::ranges::find_if(climbers, [&](const Climber& each) {
        return each.climb.subject == audit.subject && each.climb.shape == audit.shape;
      });
      climber->take(k, audit);
      done += audit.tally.cases;
    }
    if (tell) tell({done, all});
  }
  std::vector<Climb> climbs;
  climbs.reserve(climbers.size());
  for (Climber& each : climbers) climbs.push_back(each.finished());
  return climbs;
}

}  // namespace rayaudit
