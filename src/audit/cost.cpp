#include "audit/cost.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>

#include "audit/timing.hpp"

namespace rayaudit {
namespace {

/// Subjects up to so dear are judged by all cases.
constexpr int affordable = 50;
/// Subjects up to so dear are timed on a whole chunk.
constexpr int quick = 2;

/// Fewer cases for a subject that is dearer than it may be, but not below the least.
std::uint64_t share_of(std::uint64_t cases, int dear, int may_be, std::uint64_t least) {
  if (dear <= may_be) return cases;
  const std::uint64_t afforded = cases * static_cast<std::uint64_t>(may_be) / dear;
  return std::max(afforded, std::min(cases, least));
}

/// Reads every case and answers nothing of worth: what all subjects do besides.
void answer_idly(std::span<const Case> cases, std::span<Answer> answers) {
  for (std::size_t i = 0; i < cases.size(); ++i) {
    double sum = 0;
    each_number(cases[i], [&](double x) { sum += x; });
    answers[i].form = Answer::Form::hit;
    answers[i].t = real(sum);
  }
}

Subject idle_subject() {
  Subject subject = {"idle", double_format, {}};
  subject.answer.fill(answer_idly);
  return subject;
}

/// Measures a plan, and drops from it the subjects that fail.
class Measurement {
 public:
  Measurement(const CostPlan& plan, const std::function<void(Progress)>& tell)
      : plan_(plan), tell_(tell) {
    for (const std::size_t shape : plan.shapes)
      for (const Family* family : plan.families)
        if (family->draw[shape] != nullptr) add_cell(shape, *family);
    for (const Cell& cell : cells_)
      for (const Way& way : cell.ways) all_ += judged_cases(plan_, *way.subject);
    all_ *= 2;  // half of the way is timing
  }

  Cost made() {
    {
      const Pinned here;
      for (Cell& cell : cells_) {
        leave_out_untimed(cell);
        time(cell);
      }
    }
    std::map<std::uint64_t, std::vector<const Subject*>> by_cases;
    for (const Subject* subject : plan_.subjects)
      if (!is_untimed(subject)) by_cases[judged_cases(plan_, *subject)].push_back(subject);
    for (const auto& [cases, subjects] : by_cases) judge(cases, subjects);
    for (Cell& cell : cells_) leave_out_untimed(cell);
    std::erase_if(cells_, [](const Cell& cell) { return cell.ways.empty(); });
    Cost cost;
    if (!idle_rounds_.empty()) cost.idle = spread(std::move(idle_rounds_));
    for (const std::size_t shape : plan_.shapes) add_shape(cost.cells, shape);
    cost.untimed = std::move(untimed_);
    return cost;
  }

 private:
  void add_cell(std::size_t shape, const Family& family) {
    Cell cell = {shape, Scope::family, &family, {}};
    for (const Subject* subject : plan_.subjects)
      if (subject->answers(shape))
        cell.ways.push_back({subject, {}, {}, timed_cases(plan_, *subject), {}});
    if (!cell.ways.empty()) cells_.push_back(std::move(cell));
  }

  bool is_untimed(const Subject* subject) const {
    return std::ranges::count(untimed_, subject, &Untimed::subject) > 0;
  }
  void drop(const Subject* subject, const NoAnswer& why) {
    if (!is_untimed(subject)) untimed_.push_back({subject, why.what()});
  }

  void leave_out_untimed(Cell& cell) {
    std::erase_if(cell.ways, [&](const Way& way) { return is_untimed(way.subject); });
  }

  void told(std::uint64_t done) {
    done_ += done;
    if (tell_) tell_({std::min(done_, all_), all_});
  }

  void time(Cell& cell) {
    std::vector<Case> cases(std::min<std::uint64_t>(chunk_cases, plan_.cases));
    draw(*cell.family, cell.shape, float_format, {}, plan_.seed, 0, cases);
    std::vector<Course> courses;
    for (const Way& way : cell.ways) courses.push_back({way.subject, cases, way.timed});
    courses.push_back({&idle_, cases, cases.size()});
    const auto fail = [&](const Course& course, const NoAnswer& why) { drop(course.subject, why); };
    const auto times = timed(courses, plan_.rounds, fail);
    std::uint64_t done = 0;
    for (std::size_t i = 0; i < cell.ways.size(); ++i) {
      cell.ways[i].rounds = times[i];
      done += judged_cases(plan_, *cell.ways[i].subject);
    }
    idle_rounds_.insert(idle_rounds_.end(), times.back().begin(), times.back().end());
    told(done);
  }

  /// Judges subjects together; where one fails, each half of them alone.
  void judge(std::uint64_t cases, const std::vector<const Subject*>& subjects) {
    const Plan plan = {.subjects = subjects,
                       .families = plan_.families,
                       .shapes = plan_.shapes,
                       .cases = cases,
                       .seed = plan_.seed,
                       .drawn_in = float_format,
                       .causes = false,
                       .threads = plan_.threads};
    try {
      const std::uint64_t before = done_;
      const auto audits = run(plan, [&](const Progress& progress) {
        if (tell_) tell_({std::min(before + progress.done, all_), all_});
      });
      for (const Audit& audit : audits) {
        done_ += audit.tally.cases;
        accuracies_[{audit.subject, audit.shape, audit.family}].add(audit.tally,
                                                                    audit.subject->format);
      }
    } catch (const NoAnswer& why) {
      if (subjects.size() == 1) return drop(subjects.front(), why);
      const auto middle = subjects.begin() + static_cast<std::ptrdiff_t>(subjects.size() / 2);
      judge(cases, {subjects.begin(), middle});
      judge(cases, {middle, subjects.end()});
    }
  }

  void add_shape(std::vector<Cell>& cells, std::size_t shape) {
    for (const Scope scope : {Scope::all, Scope::easy, Scope::hard})
      if (Cell sum = summed(shape, scope); !sum.ways.empty()) cells.push_back(std::move(sum));
    for (const Cell& cell : cells_)
      if (cell.shape == shape) cells.push_back(finished(cell, {cell.family}));
  }

  Cell summed(std::size_t shape, Scope scope) {
    Cell sum = {shape, scope, nullptr, {}};
    std::vector<const Family*> families;
    for (const Cell& cell : cells_) {
      if (cell.shape != shape || !counts_in(scope, *cell.family)) continue;
      families.push_back(cell.family);
      if (sum.ways.empty()) {
        sum.ways = cell.ways;
        continue;
      }
      for (std::size_t i = 0; i < sum.ways.size(); ++i) {
        auto& rounds = sum.ways[i].rounds;
        std::transform(rounds.begin(), rounds.end(), cell.ways[i].rounds.begin(), rounds.begin(),
                       std::plus());
      }
    }
    for (Way& way : sum.ways) {
      way.timed *= families.size();
      for (double& round : way.rounds) round /= static_cast<double>(families.size());
    }
    return finished(std::move(sum), families);
  }

  /// The cell with all that follows from times and verdicts.
  Cell finished(Cell cell, const std::vector<const Family*>& families) {
    for (Way& way : cell.ways) {
      way.nanoseconds = spread(way.rounds);
      for (const Family* family : families)
        way.accuracy.add(accuracies_[{way.subject, cell.shape, family}]);
    }
    mark_front(cell.ways);
    return cell;
  }

  const CostPlan& plan_;
  const std::function<void(Progress)>& tell_;
  std::vector<Cell> cells_;  ///< one for each shape and family
  std::map<std::tuple<const Subject*, std::size_t, const Family*>, Accuracy> accuracies_;
  std::vector<Untimed> untimed_;
  Subject idle_ = idle_subject();
  std::vector<double> idle_rounds_;
  std::uint64_t done_ = 0, all_ = 0;
};

/// How many times as much the one took as the other, in the same rounds.
Spread ratio(const Way& much, const Way& little) {
  std::vector<double> ratios(much.rounds.size());
  std::transform(much.rounds.begin(), much.rounds.end(), little.rounds.begin(), ratios.begin(),
                 std::divides());
  return spread(std::move(ratios));
}

}  // namespace

std::uint64_t judged_cases(const CostPlan& plan, const Subject& subject) {
  return share_of(plan.cases, subject.dear, affordable, 64);
}

std::size_t timed_cases(const CostPlan& plan, const Subject& subject) {
  return share_of(std::min<std::uint64_t>(plan.cases, chunk_cases), subject.dear, quick, 16);
}

std::string_view name(Scope scope) {
  constexpr std::array<std::string_view, 4> names = {"family", "all", "easy", "hard"};
  return names[static_cast<std::size_t>(scope)];
}

bool counts_in(Scope scope, const Family& family) {
  switch (scope) {
    case Scope::easy:
      return family.strength == Strength::anywhere;
    case Scope::hard:
      return family.strength != Strength::anywhere;
    default:
      return true;
  }
}

void mark_front(std::vector<Way>& ways) {
  std::vector<Way*> by_accuracy;
  for (Way& way : ways) {
    way.on_front = false;
    by_accuracy.push_back(&way);
  }
  std::ranges::stable_sort(by_accuracy, [](const Way* a, const Way* b) {
    const auto order = a->accuracy <=> b->accuracy;
    return std::is_neq(order) ? std::is_lt(order) : a->nanoseconds.median < b->nanoseconds.median;
  });
  std::vector<Way*> faster;  // each clearly so than the one before, and than all more accurate ones
  double least = std::numeric_limits<double>::infinity();  // of all that are more accurate
  for (Way* way : by_accuracy) {
    const Spread& time = way->nanoseconds;
    if (faster.empty() ||
        (time.median < least && is_clearly_less(time, faster.back()->nanoseconds)))
      faster.push_back(way);
    least = std::min(least, time.median);
  }
  std::ranges::reverse(faster);
  const Way* last = nullptr;
  for (Way* way : faster) {
    if (last != nullptr && !is_clearly_more_accurate(way->accuracy, last->accuracy)) continue;
    way->on_front = true;
    last = way;
  }
}

std::vector<const Way*> Cell::front() const {
  std::vector<const Way*> front;
  for (const Way& way : ways)
    if (way.on_front) front.push_back(&way);
  std::ranges::sort(front, {}, [](const Way* way) { return way->nanoseconds.median; });
  return front;
}

std::vector<Step> Cell::steps() const {
  std::vector<Step> steps;
  const auto along = front();
  for (std::size_t i = 1; i < along.size(); ++i)
    steps.push_back({along[i - 1], along[i], ratio(*along[i], *along[i - 1])});
  return steps;
}

std::vector<Price> Cost::prices(std::size_t shape) const {
  const auto cell_of = [&](Scope scope) {
    const auto found = std::ranges::find_if(
        cells, [&](const Cell& cell) { return cell.shape == shape && cell.scope == scope; });
    return found == cells.end() ? nullptr : &*found;
  };
  const Cell *easy = cell_of(Scope::easy), *hard = cell_of(Scope::hard);
  std::vector<Price> prices;
  if (easy == nullptr || hard == nullptr) return prices;
  for (std::size_t i = 0; i < easy->ways.size(); ++i)
    prices.push_back({&easy->ways[i], &hard->ways[i], ratio(hard->ways[i], easy->ways[i])});
  return prices;
}

Cost measure(const CostPlan& plan, const std::function<void(Progress)>& tell) {
  return Measurement(plan, tell).made();
}

}  // namespace rayaudit
