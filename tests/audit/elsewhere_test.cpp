#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <vector>

#include "audit/audit.hpp"
#include "tests/audit/named.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t sphere = 1;

/// A subject elsewhere that is none: it answers here, and notes what it is asked.
struct Elsewhere {
  std::vector<std::size_t> batches;
  std::vector<Case> asked;
  Answer answer = Answer::miss();
  Subject subject = {"elsewhere/double", double_format, {}};

  Elsewhere() {
    subject.is_elsewhere = true;
    subject.answer[sphere] = [this](std::span<const Case> cases, std::span<Answer> answers) {
      batches.push_back(cases.size());
      asked.insert(asked.end(), cases.begin(), cases.end());
      for (Answer& each : answers) each = answer;
    };
  }

  Plan plan(std::uint64_t cases) {
    return {.subjects = {&subject},
            .families = {family_of("anywhere"), family_of("grazing")},
            .shapes = {sphere},
            .cases = cases,
            .seed = 7,
            .causes = false};
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(a_subject_elsewhere_is_asked_in_order_in_long_batches) {
  for (const int threads : {1, 2}) {
    Elsewhere elsewhere;
    Plan plan = elsewhere.plan(batch_elsewhere + 2000);
    plan.threads = threads;
    const std::vector<Audit> audits = run(plan);
    const std::vector<std::size_t> batches = {batch_elsewhere, 2000, batch_elsewhere, 2000};
    BOOST_TEST(elsewhere.batches == batches, boost::test_tools::per_element());
    std::vector<Case> first(chunk_cases), second(chunk_cases);
    draw(*plan.families[0], sphere, double_format, {}, plan.seed, 0, first);
    draw(*plan.families[0], sphere, double_format, {}, plan.seed, 1, second);
    first.insert(first.end(), second.begin(), second.end());
    BOOST_TEST(std::equal(first.begin(), first.end(), elsewhere.asked.begin()));
    for (const Audit& audit : audits) BOOST_TEST(audit.tally.cases == plan.cases);
  }
}

BOOST_AUTO_TEST_CASE(a_crash_is_tallied_and_cases_that_were_not_asked_are_not) {
  Elsewhere elsewhere;
  elsewhere.subject.answer[sphere] = [](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i)
      answers[i] = i < 10 ? Answer::crashed(11) : Answer::unasked();
  };
  const Audit audit = run(elsewhere.plan(1500))[0];
  BOOST_TEST(audit.tally.cases == 10u);
  BOOST_TEST(audit.tally.of(Verdict::crashed) == 10u);
  BOOST_TEST(audit.tally.unasked == 1490u);
  BOOST_TEST(audit.tally.worst(Verdict::crashed)->answer.signal == 11);
  elsewhere.answer = Answer::unasked();
  elsewhere.subject.answer[sphere] = [](std::span<const Case>, std::span<Answer> answers) {
    for (Answer& answer : answers) answer = Answer::unasked();
  };
  BOOST_TEST(run(elsewhere.plan(1500)).empty());
}

BOOST_AUTO_TEST_CASE(a_finding_of_a_subject_elsewhere_is_asked_again_alone) {
  Elsewhere elsewhere;
  elsewhere.answer = Answer::crashed(6);
  Plan plan = elsewhere.plan(1000);
  plan.causes = true;
  BOOST_TEST(run(plan)[0].tally.worst(Verdict::crashed)->repeats);
  // It crashes among others only.
  elsewhere.subject.answer[sphere] = [](std::span<const Case> cases, std::span<Answer> answers) {
    for (Answer& answer : answers) answer = cases.size() > 1 ? Answer::crashed(6) : Answer::miss();
  };
  BOOST_TEST(!run(plan)[0].tally.worst(Verdict::crashed)->repeats);
}
