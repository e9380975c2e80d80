#include "audit/library_times.hpp"

#include <algorithm>

#include "audit/timing.hpp"

namespace rayaudit {
namespace {

/// So many cases a round, in so many rounds.
constexpr std::size_t each_round = 128;
constexpr int rounds = 5;

const Family& timed_family() {
  return *std::find_if(families().begin(), families().end(),
                       [](const Family& family) { return family.id == "unit"; });
}

const Subject* textbook_beside(const Subject& subject, std::size_t shape) {
  const std::vector<Subject>& all = built_in_subjects();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Subject& each) {
    return each.name == "textbook/" + std::string(subject.format.name);
  });
  return found != all.end() && found->answers(shape) ? &*found : nullptr;
}

std::optional<TimeBeside> measured(const Plan& plan, const Subject& subject, std::size_t shape) {
  std::vector<Case> cases(chunk_cases);
  draw(timed_family(), shape, subject.drawn_in(), {}, plan.seed, 0, cases);
  for (Case& question : cases)
    question = posed(question, convention_of(plan, subject), subject.drawn_in());
  std::vector<Course> courses = {{&subject, cases, each_round}};
  if (const Subject* textbook = textbook_beside(subject, shape))
    courses.push_back({textbook, cases, each_round});
  const auto times = timed(courses, rounds, [](const Course&, const NoAnswer&) {});
  if (times[0].empty()) return {};
  TimeBeside made = {&subject, shape, spread(times[0])};
  if (times.size() > 1 && !times[1].empty()) made.textbook = spread(times[1]);
  return made;
}

}  // namespace

std::vector<TimeBeside> times_beside_textbook(const Plan& plan) {
  std::vector<TimeBeside> all;
  const Pinned here;
  for (const Subject* subject : plan.subjects)
    for (const std::size_t shape : plan.shapes)
      if (subject->answers(shape) && timed_family().draw[shape] != nullptr)
        if (const auto one = measured(plan, *subject, shape)) all.push_back(*one);
  return all;
}

}  // namespace rayaudit
