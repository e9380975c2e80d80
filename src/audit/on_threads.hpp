#pragma once

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>
#include <vector>

#include "subjects/subject.hpp"

/// Work for all processors, and what of it must be done in order.
namespace rayaudit {

/// Calls work(i) for each i below count, on so many threads, or one for each processor where that
/// is 0.
template <class Work>
void on_threads(int threads, std::size_t count, const Work& work) {
  // Unasked, TBB gives no more threads than there are processors.
  std::optional<tbb::global_control> allowed;
  if (threads > 0) allowed.emplace(tbb::global_control::max_allowed_parallelism, threads);
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, count, 1),
        [&](const auto& range) {
          for (std::size_t i = range.begin(); i < range.end(); ++i) work(i);
        },
        tbb::simple_partitioner());
  });
}

/// Calls work(i) for each i, for which subjects[i] is asked; a subject elsewhere by one thread and
/// in this order.
template <class Work>
void in_turn(int threads, const std::vector<const Subject*>& subjects, const Work& work) {
  std::vector<std::vector<std::size_t>> turns;
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    const auto same = std::find_if(turns.begin(), turns.end(), [&](const auto& turn) {
      return subjects[i]->is_elsewhere && subjects[turn.front()] == subjects[i];
    });
    (same == turns.end() ? turns.emplace_back() : *same).push_back(i);
  }
  on_threads(threads, turns.size(), [&](std::size_t turn) {
    for (const std::size_t i : turns[turn]) work(i);
  });
}

}  // namespace rayaudit
