#include <cmath>
#include <limits>

#include "oracle/truth.hpp"
#include "scenes/tracer.hpp"

namespace rayaudit {
namespace {

/// The first crossing within the range, which is open: no start and no end.
const oracle::Crossing* first_crossing(const oracle::Truth& truth) {
  for (const oracle::Crossing& crossing : truth.crossings())
    if (crossing.kind != oracle::Kind::start && crossing.kind != oracle::Kind::end)
      return &crossing;
  return nullptr;
}

template <class N, class Tell>
void settle(std::span<const Case> cases, const Tell& tell) {
  thread_local std::vector<oracle::Truth> truths;
  truths.resize(cases.size());
  oracle::truth(cases, truths, oracle::bits_for(format_of<N>));
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const oracle::Crossing* const crossing = first_crossing(truths[i]);
    tell(i, crossing ? Answer::hit(real(oracle::rounded<N>(cases[i], *crossing))) : Answer::miss());
  }
}

template <class N>
void answer(std::span<const Case> cases, std::span<Answer> answers) {
  settle<N>(cases, [&](std::size_t i, const Answer& said) { answers[i] = said; });
}

/// What is rounded once is off by at most half an ulp.
template <class N>
void prove(std::span<const Case> cases, std::span<Proved> answers) {
  using Limits = std::numeric_limits<N>;
  settle<N>(cases, [&](std::size_t i, const Answer& said) {
    const double bound = std::fabs(said.t.high) * (double{Limits::epsilon()} / 2);
    answers[i] = {said, std::isfinite(bound), bound + double{Limits::denorm_min()}};
  });
}

template <class N>
Subject exact() {
  Subject subject = {.name = "exact/" + std::string(format_of<N>.name),
                     .format = format_of<N>,
                     .answer = {},
                     .dear = 12,
                     .by_name_only = true};
  subject.answer.fill(answer<N>);
  subject.prove.fill(prove<N>);
  return subject;
}

}  // namespace

const Subject& exact_subject(const Format& format) {
  static const Subject in_float = exact<float>(), in_double = exact<double>();
  return format == float_format ? in_float : in_double;
}

}  // namespace rayaudit
