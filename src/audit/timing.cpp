#include "audit/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <string>

namespace rayaudit {
namespace {

using Clock = std::chrono::steady_clock;

/// Nanoseconds that a batch may take.
constexpr double longest = 2e9;

/// Nanoseconds that a subject takes to answer. Its batch is another source's: no compiler can
/// leave out answers that nobody reads.
double nanoseconds(const Subject* subject, std::span<const Case> cases, std::span<Answer> answers) {
  const std::size_t shape = cases.front().shape.index();
  if (subject->timed[shape]) return subject->timed[shape](cases, answers);
  const auto start = Clock::now();
  subject->answer[shape](cases, answers);
  return std::chrono::duration<double, std::nano>(Clock::now() - start).count();
}

/// The cases of a round, from 0; the round to warm up has those of the first.
std::span<const Case> cases_of(const Course& course, int round) {
  const std::size_t windows = course.cases.size() / course.each_round;
  const std::size_t window = static_cast<std::size_t>(std::max(round, 0)) % windows;
  return course.cases.subspan(window * course.each_round, course.each_round);
}

}  // namespace

Pinned::Pinned() {
  const int here = sched_getcpu();
  cpu_set_t before, only;
  if (here < 0 || sched_getaffinity(0, sizeof before, &before) != 0) return;
  CPU_ZERO(&only);
  CPU_SET(here, &only);
  if (sched_setaffinity(0, sizeof only, &only) == 0) before_ = before;
}

Pinned::~Pinned() {
  if (before_) sched_setaffinity(0, sizeof *before_, &*before_);
}

std::vector<std::vector<double>> timed(
    std::span<const Course> courses, int rounds,
    const std::function<void(const Course&, const NoAnswer&)>& fail) {
  std::vector<std::vector<double>> times(courses.size());
  std::vector<bool> failed(courses.size());
  std::size_t most = 0;
  for (const Course& course : courses) most = std::max(most, course.each_round);
  std::vector<Answer> answers(most);
  for (int round = -1; round < rounds; ++round)
    for (std::size_t i = 0; i < courses.size(); ++i) {
      const std::size_t place = (i + static_cast<std::size_t>(round + 1)) % courses.size();
      const Course& course = courses[place];
      const std::size_t size = course.each_round;
      if (failed[place]) continue;
      try {
        const double taken =
            nanoseconds(course.subject, cases_of(course, round), std::span(answers).first(size));
        if (taken > longest)
          throw NoAnswer(course.subject->name +
                         " needs too long: " + std::to_string(std::lround(taken / 1e9)) +
                         " s for " + std::to_string(size) + " cases");
        if (round >= 0) times[place].push_back(taken / static_cast<double>(size));
      } catch (const NoAnswer& reason) {
        failed[place] = true;
        times[place].clear();
        fail(course, reason);
      }
    }
  return times;
}

}  // namespace rayaudit
