#include "subjects/certified.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "audit/judge.hpp"
#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "oracle/truth.hpp"

using namespace rayaudit;

namespace {

/// Calls visit(shape, cases) with cases of every family and shape in a format.
template <class V>
void each_family(const Format& format, std::size_t of_each, V&& visit) {
  std::vector<Case> cases(of_each);
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      if (family.draw[shape] != nullptr) {
        draw(family, shape, format, {}, 11, 0, cases);
        visit(shape, cases);
      }
}

Real rounded_crossing(const Format& format, const Case& question,
                      const oracle::Crossing& crossing) {
  return format == float_format ? real(oracle::rounded<float>(question, crossing))
                                : real(oracle::rounded<double>(question, crossing));
}

/// Is t the rounded one of an acceptable crossing?
bool is_rounded_correctly(const Format& format, const Case& question, const Real& t) {
  const oracle::Truth truth = oracle::truth(question);
  for (const oracle::Crossing& crossing : truth.crossings()) {
    if (crossing.kind == oracle::Kind::within) return true;
    if (rounded_crossing(format, question, crossing) == t) return true;
  }
  return false;
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_answer_is_never_wrong_and_its_t_is_rounded_correctly) {
  for (const Subject& subject : {certified_float(), certified_double()}) {
    std::array<int, 4> stages = {};
    each_family(subject.format, 150, [&](std::size_t shape, const std::vector<Case>& cases) {
      std::vector<Answer> answers(cases.size());
      subject.answer[shape](cases, answers);
      for (std::size_t i = 0; i < cases.size(); ++i) {
        ++stages[answers[i].stage];
        const Verdict verdict = judge(cases[i], answers[i], subject.format).verdict;
        if (is_wrong(verdict)) BOOST_FAIL(name(verdict) << ": " << case_line(cases[i]));
        if (answers[i].form == Answer::Form::hit &&
            !is_rounded_correctly(subject.format, cases[i], answers[i].t))
          BOOST_FAIL("t is not the nearest: " << case_line(cases[i]));
      }
    });
    BOOST_TEST(stages[0] == 0);
    for (const int stage : {1, 2, 3}) BOOST_TEST(stages[stage] > 0, "stage " << stage);
    BOOST_TEST(stages[1] > stages[2] + stages[3]);
  }
}

BOOST_AUTO_TEST_CASE(the_answer_does_not_depend_on_its_batch) {
  const Subject subject = certified_double();
  each_family(double_format, 20, [&](std::size_t shape, const std::vector<Case>& cases) {
    std::vector<Answer> answers(cases.size());
    subject.answer[shape](cases, answers);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const Answer alone = answer_one(subject, cases[i]);
      if (!(alone == answers[i]) || alone.stage != answers[i].stage)
        BOOST_FAIL(case_line(cases[i]));
    }
  });
}

BOOST_AUTO_TEST_CASE(a_certified_t_lies_within_its_error) {
  each_family(double_format, 60, [&](std::size_t shape, const std::vector<Case>& cases) {
    std::vector<Certified> certified(cases.size());
    std::vector<Answer> answers(cases.size());
    certify(cases, certified);
    certified_double().answer[shape](cases, answers);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (certified[i].stage == 1 && certified[i].hit != (answers[i].form == Answer::Form::hit))
        BOOST_FAIL("hit or not: " << case_line(cases[i]));
      if (!certified[i].hit || answers[i].form != Answer::Form::hit) continue;
      const double nearest = answers[i].t.high;
      if (std::isinf(nearest) && certified[i].t == nearest) continue;
      // Half an ulp for the rounding of the one, and what the error itself may be rounded.
      if (!(std::fabs(certified[i].t - nearest) <=
            certified[i].error * (1 + 0x1p-40) + std::fabs(nearest) * 0x1p-52 + 0x1p-1074))
        BOOST_FAIL("t is farther off than its error: " << case_line(cases[i]));
    }
  });
}

BOOST_AUTO_TEST_CASE(an_empty_batch_is_answered) {
  for (const Subject& subject : {certified_float(), certified_double()})
    for (const Subject::Batch& answer : subject.answer) answer({}, {});
  certify({}, {});
}
