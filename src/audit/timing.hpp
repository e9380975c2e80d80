#pragma once

#include <sched.h>

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "subjects/subject.hpp"

namespace rayaudit {

/// Keeps this thread, and processes it starts, on the processor that it is on, for a scope.
class Pinned {
 public:
  Pinned();
  ~Pinned();
  Pinned(const Pinned&) = delete;
  Pinned& operator=(const Pinned&) = delete;

 private:
  std::optional<cpu_set_t> before_;  ///< where it might run; nothing where it could not be pinned
};

/// A subject on cases of one shape, so many in each round: the next ones each time, and after the
/// last the first again.
struct Course {
  const Subject* subject;
  std::span<const Case> cases;
  std::size_t each_round;
};

/// Nanoseconds a case in each round, for each course, and nothing for a subject that failed on its
/// way, or took over two seconds for a batch. A round takes every course once, each time another
/// first; the round before the first warms all up, and does not count.
std::vector<std::vector<double>> timed(
    std::span<const Course> courses, int rounds,
    const std::function<void(const Course&, const NoAnswer&)>& fail);

}  // namespace rayaudit
