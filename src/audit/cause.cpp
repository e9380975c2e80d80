#include "audit/cause.hpp"

#include <array>
#include <cmath>

#include "audit/transformation.hpp"

namespace rayaudit {
namespace {

using replay::Exactly;
using replay::Repair;

/// An experiment's answer held against the truth that the wrong one was held against.
class Bench {
 public:
  Bench(const Wrong& wrong, const Subject& subject, const Convention& convention)
      : wrong_(wrong), format_(subject.format), convention_(convention) {}

  bool mends(const Answer& answer) const {
    const Judgement judgement = judge(wrong_.settled, answer, format_, convention_);
    if (is_wrong(judgement.verdict)) return false;
    return !wrong_.most_ulps || !(judgement.ulps > *wrong_.most_ulps);
  }
  bool mends(const Exactly& exactly) const {
    return exactly.end == Exactly::End::answered && mends(exactly.answer);
  }

 private:
  const Wrong& wrong_;
  const Format& format_;
  const Convention& convention_;
};

bool has_normal(const Case& question) {
  return std::visit(
      [](const auto& shape) {
        return requires { shape.normal; };
      },
      question.shape);
}

/// What is taken for granted, where taking care of that mends the exact replay.
std::string_view assumption(const Bench& bench, const replay::Replay& replay,
                            const Case& question) {
  if (bench.mends(replay.exactly(question, Repair::direction))) return "a direction of length 1";
  if (!has_normal(question)) return {};
  if (bench.mends(replay.exactly(question, Repair::normal))) return "a normal of length 1";
  if (bench.mends(replay.exactly(question, Repair::both)))
    return "a direction and a normal of length 1";
  return {};
}

/// The first comparison that, answered as it is exactly, mends the run in the routine's number.
Diagnosis turned(const Bench& bench, const replay::Replay& replay, const Case& question,
                 const Format& format) {
  const auto run = replay.watched(question, format, -1, replay::Wanted::parting);
  if (!run) return {Cause::unknown};
  for (const replay::Step& step : run->steps) {
    const auto forced = replay.watched(question, format, step.comparison, replay::Wanted::parting);
    if (forced && bench.mends(forced->answer)) return {Cause::flip, {}, step};
  }
  return {Cause::rounding};
}

Diagnosis by_replay(const Wrong& wrong, const Bench& bench, const replay::Replay& replay,
                    const Format& format) {
  const Case& question = wrong.settled.question();
  const Exactly exactly = replay.exactly(question);
  if (exactly.end == Exactly::End::given_up) return {Cause::unknown};
  if (exactly.end == Exactly::End::undefined) return {Cause::formula, exactly.undefined};
  if (bench.mends(exactly)) return turned(bench, replay, question, format);
  if (wrong.settled.truth().invalid != oracle::Invalid::no) return {Cause::formula};
  if (const std::string_view granted = assumption(bench, replay, question); !granted.empty())
    return {Cause::assumption, granted};
  return {Cause::formula};
}

}  // namespace

std::string_view name(Cause cause) {
  constexpr std::array<std::string_view, cause_count> names = {
      "formula", "assumption", "convention", "flip", "rounding", "unknown"};
  return names[static_cast<std::size_t>(cause)];
}

std::string told(const Diagnosis& diagnosis) {
  std::string text(name(diagnosis.cause));
  if (diagnosis.cause == Cause::assumption) text += " of";
  if (diagnosis.cause == Cause::formula && !diagnosis.about.empty()) text += ":";
  if (!diagnosis.about.empty()) (text += ' ') += diagnosis.about;
  if (diagnosis.turned)
    text +=
        " at " + std::string(diagnosis.turned->file) + ':' + std::to_string(diagnosis.turned->line);
  return text;
}

Diagnosis diagnosis(const Wrong& wrong, const Subject& subject, const replay::Replay* replay,
                    const Convention& convention) {
  // What is declared otherwise is no matter of arithmetic either.
  if (wrong.judgement.verdict == Verdict::touch || wrong.judgement.claim == Claim::declined)
    return {Cause::convention};
  const Bench bench(wrong, subject, convention);
  if (replay != nullptr) return by_replay(wrong, bench, *replay, subject.format);
  if (wrong.settled.truth().invalid != oracle::Invalid::no) return {Cause::unknown};
  // What hangs would do so again and again.
  if (wrong.answer.form == Answer::Form::timed_out) return {Cause::unknown};
  return diagnosis_from_outside(wrong, subject, convention);
}

}  // namespace rayaudit
