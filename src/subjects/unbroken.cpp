#include "subjects/unbroken.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rayaudit {
namespace {

Answer in_place_of_answer(const Asked& trouble) {
  switch (trouble.end) {
    case Asked::End::silent:
      return Answer::timed_out();
    case Asked::End::garbled:
      return Answer::garbage();
    default:
      return Answer::crashed(trouble.signal);
  }
}

/// How many time-outs fit into a time.
std::size_t fitting(std::chrono::milliseconds time, std::chrono::milliseconds patience,
                    std::size_t least) {
  return std::max(least, static_cast<std::size_t>(time / patience));
}

}  // namespace

Unbroken::Unbroken(Ask ask, std::chrono::milliseconds patience)
    : ask_(std::move(ask)),
      patience_(patience),
      time_outs_a_call_(fitting(waiting_a_call, patience, least_time_outs_a_call)),
      most_time_outs_(fitting(most_waiting, patience, least_time_outs)) {}

void Unbroken::answer(std::span<const Case> cases, std::span<Answer> answers) {
  const std::lock_guard lock(mutex_);
  if (cases.size() == 1) {
    answers[0] = answer_to(cases[0]);
    return;
  }
  Troubles call;
  std::size_t i = 0;
  while (i < cases.size() && !is_enough(call)) {
    const std::size_t size = std::min(at_once_, cases.size() - i);
    i += answer_part(cases.subspan(i, size), answers.subspan(i, size), call);
  }
  for (; i < cases.size(); ++i) answers[i] = Answer::unasked();
}

Answer Unbroken::answer_to(const Case& question) {
  if (time_outs_alone_ == most_time_outs_) return Answer::unasked();
  Answer said;
  const Asked asked = ask_({&question, 1}, {&said, 1}, Manner::at_once);
  if (asked.end == Asked::End::answered) return said;
  time_outs_alone_ += asked.end == Asked::End::silent;
  return in_place_of_answer(asked);
}

/// Answers as many of the cases, from the first on, as may be asked; tells how many.
std::size_t Unbroken::answer_part(std::span<const Case> cases, std::span<Answer> answers,
                                  Troubles& call) {
  if (manner_ == Manner::one_by_one) return ask_each(cases, answers, call).asked;
  const Asked whole = ask_(cases, answers, Manner::at_once);
  if (whole.end == Asked::End::answered) {
    keep_pace(whole.nanoseconds, cases.size());
    return cases.size();
  }
  const Each each = ask_each(cases, answers, call);
  const bool is_silent = whole.end == Asked::End::silent;
  if (each.troubles > 0) {
    // Once is enough to wait for a batch before its case is found.
    if (is_silent) manner_ = Manner::one_by_one;
  } else if (is_silent && each.nanoseconds > static_cast<double>(patience_.count()) / 2) {
    keep_pace(each.nanoseconds, cases.size());  // it does not hang, but is slow
  } else {
    blame(whole, cases, answers, call);
  }
  return each.asked;
}

Unbroken::Each Unbroken::ask_each(std::span<const Case> cases, std::span<Answer> answers,
                                  Troubles& call) {
  Each each;
  while (each.asked < cases.size() && !is_enough(call)) {
    const Asked asked =
        ask_(cases.subspan(each.asked), answers.subspan(each.asked), Manner::one_by_one);
    each.asked += asked.answers;
    each.nanoseconds += asked.nanoseconds;
    if (asked.end == Asked::End::answered) break;
    answers[each.asked++] = in_place_of_answer(asked);
    ++each.troubles;
    count(asked, call);
  }
  return each;
}

/// Of a batch that fails though no case of it does alone, the trouble is told of the first case of
/// the least part that still fails; asked again, alone, it will not repeat. From then on cases are
/// asked alone.
void Unbroken::blame(Asked trouble, std::span<const Case> cases, std::span<Answer> answers,
                     Troubles& call) {
  std::vector<Answer> ignored(cases.size());
  std::size_t first = 0, size = cases.size();
  const auto fails = [&](std::size_t from, std::size_t of) {
    const Asked again = ask_(cases.subspan(from, of), ignored, Manner::at_once);
    if (again.end == Asked::End::answered) return false;
    trouble = again, first = from, size = of;
    return true;
  };
  // A hang is too dear to be pursued.
  while (size > 1 && trouble.end != Asked::End::silent) {
    const std::size_t from = first, half = size / 2, rest = size - half;
    if (!fails(from, half) && !fails(from + half, rest)) break;
  }
  answers[first] = in_place_of_answer(trouble);
  count(trouble, call);
  manner_ = Manner::one_by_one;
}

void Unbroken::count(const Asked& trouble, Troubles& call) {
  const auto which = trouble.end == Asked::End::silent ? &Troubles::time_outs : &Troubles::crashes;
  ++(call.*which), ++(all_.*which);
}

bool Unbroken::is_enough(const Troubles& call) const {
  return call.crashes >= crashes_a_call || call.time_outs >= time_outs_a_call_ ||
         all_.crashes >= most_crashes || all_.time_outs >= most_time_outs_;
}

/// From what cases took, how many of them may be asked at once: a quarter of its patience is left
/// to each batch.
void Unbroken::keep_pace(double nanoseconds, std::size_t cases) {
  const double each = std::max(1.0, nanoseconds / static_cast<double>(cases));
  const double fitting = static_cast<double>(patience_.count()) / 4 / each;
  at_once_ = static_cast<std::size_t>(std::clamp(fitting, 1.0, static_cast<double>(largest_batch)));
}

}  // namespace rayaudit
