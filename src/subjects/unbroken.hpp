#pragma once

#include <chrono>
#include <functional>
#include <mutex>
#include <span>

#include "subjects/plugin_child.hpp"

namespace rayaudit {

/// Answers to cases of one shape from a subject in a child, whatever it does to that: of a batch
/// that crashes, hangs or answers garbage each case is asked alone, so that what comes in place of
/// its answer is told of the case that it is due to, and the others have theirs.
class Unbroken {
 public:
  using Ask = std::function<Asked(std::span<const Case>, std::span<Answer>, Manner)>;

  /// Of one call so many crashes are told, then the rest is unasked; of all calls so many, then all
  /// is. A case that is asked alone is so in any case, but for time-outs.
  static constexpr std::size_t crashes_a_call = 16, most_crashes = 512;
  /// As many time-outs are told as can be waited for in so long, or the least number. So much again
  /// is left to those that are asked alone.
  static constexpr std::chrono::seconds waiting_a_call{4}, most_waiting{6};
  static constexpr std::size_t least_time_outs_a_call = 2, least_time_outs = 3;
  static constexpr std::size_t largest_batch = 1024;

  /// What asks is patient for so long.
  Unbroken(Ask ask, std::chrono::milliseconds patience);

  /// From any thread, one call at a time.
  void answer(std::span<const Case> cases, std::span<Answer> answers);

 private:
  struct Troubles {
    std::size_t crashes = 0, time_outs = 0;
  };
  /// What asking each case alone has come to.
  struct Each {
    std::size_t asked = 0, troubles = 0;
    double nanoseconds = 0;
  };

  Answer answer_to(const Case& question);
  std::size_t answer_part(std::span<const Case> cases, std::span<Answer> answers, Troubles& call);
  Each ask_each(std::span<const Case> cases, std::span<Answer> answers, Troubles& call);
  void blame(Asked trouble, std::span<const Case> cases, std::span<Answer> answers, Troubles& call);
  void count(const Asked& trouble, Troubles& call);
  bool is_enough(const Troubles& call) const;
  void keep_pace(double nanoseconds, std::size_t cases);

  const Ask ask_;
  const std::chrono::nanoseconds patience_;
  const std::size_t time_outs_a_call_, most_time_outs_;
  std::mutex mutex_;
  Manner manner_ = Manner::at_once;
  std::size_t at_once_ = largest_batch;
  Troubles all_;
  std::size_t time_outs_alone_ = 0;
};

}  // namespace rayaudit
