#include "subjects/unbroken.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <csignal>
#include <set>
#include <vector>

#include "geometry/case_line.hpp"

using namespace rayaudit;
using namespace std::chrono_literals;

namespace {

using End = Asked::End;

/// A subject that stands for one in a process: says yes, ends at some cases, told by the x that
/// their rays begin at, and may mind being asked for too many at once.
struct Feigned {
  std::set<double> crashing = {}, hanging = {}, garbling = {};
  std::size_t largest = SIZE_MAX;  ///< a larger batch ends as follows
  End of_larger = End::died;
  double nanoseconds = 1000;  ///< a case takes
  double patience = 2e9;
  std::size_t requests = 0, ends = 0, most_at_once = 0, deaths = 0, silences = 0;

  Asked ask(std::span<const Case> cases, std::span<Answer> answers, Manner manner) {
    ++requests;
    const bool alone = manner == Manner::one_by_one;
    if (!alone) most_at_once = std::max(most_at_once, cases.size());
    Asked asked;
    if (!alone && cases.size() > largest) asked.end = of_larger;
    for (std::size_t i = 0; i < cases.size() && asked.end == End::answered; ++i) {
      const double x = cases[i].ray.origin.x;
      if (crashing.contains(x)) asked.end = End::died, asked.signal = SIGSEGV;
      if (hanging.contains(x)) asked.end = End::silent;
      if (garbling.contains(x)) asked.end = End::garbled;
      if (!alone && nanoseconds * static_cast<double>(i) > patience) asked.end = End::silent;
      if (asked.end == End::answered && alone) answers[asked.answers++] = Answer::yes();
    }
    deaths += asked.end == End::died;
    silences += asked.end == End::silent;
    if (asked.end != End::answered) return asked;
    std::fill(answers.begin(), answers.begin() + static_cast<std::ptrdiff_t>(cases.size()),
              Answer::yes());
    asked.answers = cases.size();
    asked.nanoseconds = nanoseconds * static_cast<double>(cases.size());
    return asked;
  }

  Unbroken unbroken(std::chrono::milliseconds waiting = 2s) {
    return Unbroken([this](std::span<const Case> cases, std::span<Answer> answers,
                           Manner manner) { return ask(cases, answers, manner); },
                    waiting);
  }
};

/// So many cases whose rays begin at 0, 1, ...
std::vector<Case> cases(std::size_t count, std::size_t first = 0) {
  const Case question = read_case_line("sphere 0 0 0 1 ray 0 0 0 1 0 0").question;
  std::vector<Case> all(count, question);
  for (std::size_t i = 0; i < count; ++i) all[i].ray.origin.x = static_cast<double>(first + i);
  return all;
}

std::vector<Answer> answers(Unbroken& subject, const std::vector<Case>& questions) {
  std::vector<Answer> said(questions.size(), Answer::garbage());
  subject.answer(questions, said);
  return said;
}

std::vector<Answer> yes(std::size_t count) { return std::vector<Answer>(count, Answer::yes()); }

auto count(const std::vector<Answer>& all, Answer::Form form) {
  return std::count_if(all.begin(), all.end(),
                       [&](const Answer& answer) { return answer.form == form; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_goes_well_is_asked_in_batches) {
  Feigned feigned;
  Unbroken subject = feigned.unbroken();
  BOOST_TEST((answers(subject, cases(16384)) == yes(16384)));
  BOOST_TEST(feigned.requests == 16);
}

BOOST_AUTO_TEST_CASE(a_trouble_is_told_of_the_case_that_it_is_due_to_and_the_others_are_answered) {
  Feigned feigned = {.crashing = {1500}, .hanging = {2000}, .garbling = {2500}};
  Unbroken subject = feigned.unbroken();
  auto told = yes(5000);
  told[1500] = Answer::crashed(SIGSEGV);
  told[2000] = Answer::timed_out();
  told[2500] = Answer::garbage();
  const auto said = answers(subject, cases(5000));
  BOOST_TEST((said == told));
  BOOST_TEST(said[1500].signal == SIGSEGV);
}

BOOST_AUTO_TEST_CASE(one_crash_costs_two_processes) {
  Feigned feigned = {.crashing = {1500}};
  Unbroken subject = feigned.unbroken();
  answers(subject, cases(5000));
  BOOST_TEST(feigned.deaths == 2);
}

BOOST_AUTO_TEST_CASE(the_first_and_the_last_of_a_batch_may_crash) {
  Feigned feigned = {.crashing = {0, 1023, 1024}};
  Unbroken subject = feigned.unbroken();
  const auto said = answers(subject, cases(2000));
  BOOST_TEST(count(said, Answer::Form::crashed) == 3);
  BOOST_TEST(count(said, Answer::Form::yes) == 1997);
}

BOOST_AUTO_TEST_CASE(after_so_many_crashes_the_rest_of_a_call_is_unasked_but_not_the_next) {
  Feigned feigned;
  for (int i = 0; i < 100; ++i) feigned.crashing.insert(i);
  Unbroken subject = feigned.unbroken();
  const auto said = answers(subject, cases(5000));
  BOOST_TEST(count(said, Answer::Form::crashed) == 16);
  BOOST_TEST(count(said, Answer::Form::unasked) == 5000 - 16);
  BOOST_TEST((answers(subject, cases(100, 200)) == yes(100)));
}

BOOST_AUTO_TEST_CASE(who_crashes_without_end_is_asked_no_more) {
  Feigned feigned;
  for (int i = 0; i < 100; ++i) feigned.crashing.insert(i);
  Unbroken subject = feigned.unbroken();
  std::ptrdiff_t crashes = 0;
  for (int i = 0; i < 100; ++i)
    crashes += count(answers(subject, cases(100)), Answer::Form::crashed);
  BOOST_TEST(crashes == 512);
  const std::size_t requests = feigned.requests;
  BOOST_TEST(count(answers(subject, cases(100, 200)), Answer::Form::unasked) == 100);
  BOOST_TEST(feigned.requests == requests);
}

BOOST_AUTO_TEST_CASE(who_always_hangs_is_waited_for_four_times_in_batches_and_three_times_alone) {
  Feigned feigned;
  for (int i = 0; i < 100; ++i) feigned.hanging.insert(i);
  Unbroken subject = feigned.unbroken();
  std::ptrdiff_t told = 0;
  for (int i = 0; i < 10; ++i) {
    const auto said = answers(subject, cases(100));
    told += count(said, Answer::Form::timed_out);
    BOOST_TEST(count(said, Answer::Form::timed_out) + count(said, Answer::Form::unasked) == 100);
  }
  BOOST_TEST(told == 3);
  BOOST_TEST(feigned.silences == 4);
  for (int i = 0; i < 10; ++i) answers(subject, cases(1));
  BOOST_TEST(feigned.silences == 7);
  BOOST_TEST(count(answers(subject, cases(1)), Answer::Form::unasked) == 1);
}

/// Of a subject that hangs at every case, and is waited for so long, the time-outs told in the
/// first of many calls, in all of them, and by cases alone.
struct TimeOuts {
  std::ptrdiff_t first = 0, all = 0, alone = 0;

  explicit TimeOuts(std::chrono::milliseconds patience) {
    Feigned feigned;
    for (int i = 0; i < 500; ++i) feigned.hanging.insert(i);
    Unbroken subject = feigned.unbroken(patience);
    first = all = count(answers(subject, cases(500)), Answer::Form::timed_out);
    for (int i = 0; i < 10; ++i)
      all += count(answers(subject, cases(500)), Answer::Form::timed_out);
    for (int i = 0; i < 500; ++i)
      alone += count(answers(subject, cases(1)), Answer::Form::timed_out);
  }
};

BOOST_AUTO_TEST_CASE(the_less_patience_the_more_time_outs_are_told) {
  const TimeOuts little(50ms), more(1s), much(100s);
  BOOST_TEST(little.first == 80);
  BOOST_TEST(little.all == 120);
  BOOST_TEST(little.alone == 120);
  BOOST_TEST(more.first == 4);
  BOOST_TEST(more.all == 6);
  BOOST_TEST(more.alone == 6);
  BOOST_TEST(much.first == 2);
  BOOST_TEST(much.all == 3);
  BOOST_TEST(much.alone == 3);
}

BOOST_AUTO_TEST_CASE(a_case_that_is_asked_alone_is_so_after_any_number_of_crashes) {
  Feigned feigned;
  for (int i = 0; i < 100; ++i) feigned.crashing.insert(i);
  Unbroken subject = feigned.unbroken();
  for (int i = 0; i < 40; ++i) answers(subject, cases(100));
  BOOST_TEST(count(answers(subject, cases(1)), Answer::Form::crashed) == 1);
  BOOST_TEST(count(answers(subject, cases(1, 500)), Answer::Form::yes) == 1);
}

BOOST_AUTO_TEST_CASE(a_batch_that_fails_though_none_of_its_cases_does_is_told_once) {
  for (const End end : {End::died, End::garbled, End::silent}) {
    Feigned feigned = {.largest = 5, .of_larger = end};
    Unbroken subject = feigned.unbroken();
    const auto said = answers(subject, cases(3000));
    BOOST_TEST(count(said, Answer::Form::yes) == 2999);
    BOOST_TEST(!said[0].is_given());
    BOOST_TEST((answers(subject, cases(3000)) == yes(3000)));
    BOOST_TEST(feigned.silences <= 1);
  }
}

BOOST_AUTO_TEST_CASE(who_is_slow_does_not_hang_and_is_asked_for_less) {
  Feigned feigned = {.nanoseconds = 5e6};
  Unbroken subject = feigned.unbroken();
  BOOST_TEST((answers(subject, cases(3000)) == yes(3000)));
  BOOST_TEST(feigned.silences == 1);
  feigned.most_at_once = 0;
  for (int i = 0; i < 10; ++i) BOOST_TEST((answers(subject, cases(3000)) == yes(3000)));
  BOOST_TEST(feigned.most_at_once == 100);
  BOOST_TEST(feigned.silences == 1);
}

BOOST_AUTO_TEST_CASE(who_gets_slower_is_asked_for_less_before_it_takes_too_long) {
  Feigned feigned = {.nanoseconds = 1e6};
  Unbroken subject = feigned.unbroken();
  answers(subject, cases(1024));
  feigned.nanoseconds = 3e6;
  answers(subject, cases(3000));
  BOOST_TEST(feigned.silences == 0);
}
