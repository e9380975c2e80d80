#include <algorithm>
#include <cmath>

#include "audit/judge.hpp"
#include "geometry/flat_case.hpp"
#include "rayaudit/oracle.h"
#include "tests/families/drawn.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t few = 128;

bool is_alike(const Case& question, const oracle::Crossing& crossing,
              const rayaudit_crossing& flat) {
  return flat.kind == static_cast<int>(crossing.kind) &&
         flat.t.in_float == oracle::rounded<float>(question, crossing) &&
         flat.t.in_double == oracle::rounded<double>(question, crossing) &&
         flat.t.in_long_double == oracle::rounded<long double>(question, crossing) &&
         flat.t_last.in_float == oracle::rounded_last<float>(question, crossing) &&
         flat.t_last.in_double == oracle::rounded_last<double>(question, crossing) &&
         flat.t_last.in_long_double == oracle::rounded_last<long double>(question, crossing);
}

bool is_alike(const Case& question, const oracle::Truth& truth, const rayaudit_truth& flat) {
  if (flat.invalid != static_cast<int>(truth.invalid)) return false;
  if (truth.invalid != oracle::Invalid::no) return true;
  if (flat.count != truth.count || (flat.hit != 0) != (truth.hit() != nullptr)) return false;
  for (std::size_t i = 0; i < truth.count; ++i)
    if (!is_alike(question, truth.listed[i], flat.crossings[i])) return false;
  return true;
}

bool is_alike(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

/// An answer that is not quite right.
Answer answer_to(const Case& question) {
  const oracle::Truth truth = oracle::truth(question);
  if (truth.hit() == nullptr) return Answer::hit(real(1.0));
  return Answer::hit(real(oracle::rounded<float>(question, *truth.hit())));
}

bool is_judged_alike(const Case& question) {
  const rayaudit_case asked = flat(question);
  const Answer answer = answer_to(question);
  const rayaudit_answer said = flat(answer);
  rayaudit_judgement ours;
  if (rayaudit_judge(&asked, &said, RAYAUDIT_FLOAT, nullptr, &ours) != RAYAUDIT_DONE) return false;
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(float_format));
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, float_format);
  return ours.verdict == static_cast<int>(judgement.verdict) &&
         ours.claim == static_cast<int>(judgement.claim) &&
         ours.touch == static_cast<int>(judgement.touch.value_or(oracle::Kind::proper)) &&
         (ours.taken != 0) == judgement.taken && ours.crossing == judgement.crossing &&
         ours.side == static_cast<int>(judgement.side) && is_alike(ours.ulps, judgement.ulps) &&
         is_alike(ours.relative, judgement.relative) && is_alike(ours.forced, judgement.forced) &&
         is_alike(ours.own, judgement.own) && is_alike(ours.distance, judgement.distance) &&
         is_alike(ours.margin, std::ldexp(settled.reach(), 24));
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_truth_is_that_of_the_oracle_and_every_t_correctly_rounded) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    const std::vector<Case> questions = drawn(family, shape, format, {}, 0, few);
    std::vector<rayaudit_case> cases;
    cases.reserve(questions.size());
    for (const Case& question : questions) cases.push_back(flat(question));
    std::vector<rayaudit_truth> truths(cases.size());
    BOOST_REQUIRE(rayaudit_truths(cases.data(), cases.size(), truths.data()) == RAYAUDIT_DONE);
    std::size_t i = 0;
    require_each(family, shape, format, questions, [&](const Case& question) {
      return is_alike(question, oracle::truth(question), truths[i++]);
    });
  });
}

BOOST_AUTO_TEST_CASE(every_judgement_is_that_of_the_judge) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    require_each(family, shape, format, drawn(family, shape, format, {}, 0, few / 4),
                 is_judged_alike);
  });
}
