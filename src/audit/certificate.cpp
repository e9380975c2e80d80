#include "audit/certificate.hpp"

#include <cmath>

#include "oracle/position.hpp"

namespace rayaudit {
namespace {

/// More than the exact replay, known to 2^-90, can be off, in ulps of long double.
constexpr double observed_error = 0x1p-24;

/// The t of a hit, to 2^-100 of itself.
Real t_of(const Case& question, const Answer& answer) {
  if (answer.form == Answer::Form::hit) return answer.t;
  return oracle::projection(question.ray, answer.point, 100);
}

double in_ulps(double bound, const Real& exact, const Format& format) {
  return scaled({bound, 0, 0, 0}, spacing_exponent(exact, format));
}

}  // namespace

void Certificate::add(Settled& settled, const Proved& proof, const replay::Replay& replay,
                      const Format& format, std::uint64_t place) {
  ++cases;
  if (!proof.certified) return;
  ++certified;
  const Case& question = settled.question();
  const replay::Exactly exactly = replay.exactly(question);
  if (exactly.end == replay::Exactly::End::given_up) return;
  ++compared;
  const auto note_wrong = [&] {
    ++wrong;
    keep_worse(first_wrong, {.place = place, .question = question, .answer = proof.answer});
  };
  if (exactly.end == replay::Exactly::End::undefined || exactly.answer.form != proof.answer.form)
    return note_wrong();
  const auto form = proof.answer.form;
  if (form != Answer::Form::hit && form != Answer::Form::at) return;
  const Real exact = t_of(question, exactly.answer);
  const double off = ulps(t_of(question, proof.answer), exact, format);
  const double bound = in_ulps(proof.bound, exact, format);
  if (!(off <= bound + observed_error)) return note_wrong();
  if (off < least_observed) return;
  looseness.add(bound / off);
  const auto keep = [&](std::optional<Worst>& kept, double ulps) {
    keep_worse(kept,
               {.severity = ulps, .place = place, .question = question, .answer = proof.answer});
  };
  keep(proved, bound);
  keep(observed, off);
}

void Certificate::merge(const Certificate& other) {
  cases += other.cases;
  certified += other.certified;
  compared += other.compared;
  wrong += other.wrong;
  looseness.merge(other.looseness);
  const auto keep = [](std::optional<Worst>& kept, const std::optional<Worst>& theirs) {
    if (theirs) keep_worse(kept, *theirs);
  };
  keep(proved, other.proved);
  keep(observed, other.observed);
  keep(first_wrong, other.first_wrong);
}

}  // namespace rayaudit
