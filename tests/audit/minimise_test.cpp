#include "audit/minimise.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "audit/finding.hpp"
#include "audit/simpler.hpp"
#include "audit/transformation.hpp"
#include "geometry/case_line.hpp"
#include "subjects/subject_of.hpp"
#include "tests/audit/named.hpp"
#include "tests/oracle/replay/planted.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2, cone = 3;

Plan plan_of(std::vector<const Subject*> subjects, std::initializer_list<std::string_view> ids,
             std::vector<std::size_t> shapes, std::uint64_t cases = 2048) {
  Plan plan;
  plan.subjects = std::move(subjects), plan.shapes = std::move(shapes);
  plan.cases = cases, plan.seed = 3;
  for (const std::string_view id : ids) plan.families.push_back(family_of(id));
  return plan;
}

/// A wrong answer of a subject to a case, as the worst of an audit.
Worst wrong(const Subject& subject, std::string_view line) {
  Worst worst;
  worst.question = read_case_line(line).question;
  worst.answer = answer_one(subject, worst.question);
  const oracle::Truth truth = oracle::truth(worst.question, oracle::bits_for(subject.format));
  Settled settled(worst.question, truth);
  worst.judgement = judge(settled, worst.answer, subject.format, subject.convention);
  BOOST_REQUIRE(is_wrong(worst.judgement.verdict));
  worst.diagnosis = diagnosis({settled, worst.answer, worst.judgement, {}}, subject,
                              replay::replay_of(subject.name), subject.convention);
  worst.severity = std::ldexp(settled.reach(), subject.format.precision);
  return worst;
}

Audit audit_of(const Subject& subject, std::size_t shape) {
  return {&subject, family_of("anywhere"), shape, {}, {}};
}

std::optional<Minimal> minimal_of(const Subject& subject, std::string_view line) {
  const Worst worst = wrong(subject, line);
  return minimal({}, audit_of(subject, worst.question.shape.index()), worst);
}

/// The case in decimals that a person would write.
std::string shown(const std::optional<Minimal>& minimal) {
  if (!minimal) return "none";
  std::string text;
  each_number(minimal->question, [&](double x) {
    const std::string digits = std::to_string(x);
    text += digits.substr(0, digits.find_last_not_of(".0") + 1) + (x == 0 ? "0 " : " ");
  });
  return text;
}

/// Is the answer to a case one of the same failure? Told from scratch.
bool is_alike(const Subject& subject, const Worst& worst, const Case& question) {
  const Answer answer = answer_one(subject, question);
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(subject.format));
  if (truth.invalid != oracle::Invalid::no) return false;
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, subject.format, subject.convention);
  if (judgement.verdict != worst.judgement.verdict || judgement.claim != worst.judgement.claim)
    return false;
  const double margin = std::ldexp(settled.reach(), subject.format.precision);
  if (margin < std::min(worst.severity, 0x1p10)) return false;
  const Diagnosis found = diagnosis({settled, answer, judgement, {}}, subject,
                                    replay::replay_of(subject.name), subject.convention);
  return found.cause == worst.diagnosis.cause && found.about == worst.diagnosis.about;
}

bool are_floats(const Case& question) {
  bool all = true;
  each_number(question, [&](double x) { all = all && static_cast<float>(x) == x; });
  return all;
}

template <class Routine, class N>
Subject planted_subject() {
  return subject_of<Routine, N>();
}

/// The same in a process of its own, as far as the audit can tell; counts how often it is asked.
template <class Routine, class N>
Subject elsewhere(std::size_t shape, int& askings, std::size_t& largest) {
  Subject made = subject_of<Routine, N>();
  made.is_elsewhere = true;
  made.answer[shape] = [&, answer = made.answer[shape]](std::span<const Case> cases,
                                                        std::span<Answer> answers) {
    ++askings;
    largest = std::max(largest, cases.size());
    answer(cases, answers);
  };
  return made;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_step_is_simpler_and_the_simplest_comes_first) {
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      if (family.draw[shape] == nullptr || family.id == "invalid") continue;
      std::vector<Case> cases(20);
      draw(family, shape, float_format, {}, 5, 0, cases);
      for (const Case& question : cases) {
        Simplicity last;
        for (const Case& each : simpler(question, float_format)) {
          BOOST_TEST_REQUIRE((simplicity(each) < simplicity(question)), case_line(each));
          BOOST_TEST_REQUIRE((simplicity(each) >= last), case_line(each));
          BOOST_TEST_REQUIRE(are_floats(each), case_line(each));
          last = simplicity(each);
        }
      }
    }
}

BOOST_AUTO_TEST_CASE(nothing_is_simpler_than_the_unit_sphere_from_its_centre) {
  const Case least = read_case_line("sphere 0 0 0 1 ray 0 0 0 1 0 0").question;
  std::string lines;
  for (const Case& each : simpler(least, double_format)) lines += case_line(each) + '\n';
  // An invalid case, which the oracle tells apart: it has no direction.
  BOOST_TEST(lines == case_line(read_case_line("sphere 0 0 0 1 ray 0 0 0 0 0 0").question) + '\n');
}

BOOST_AUTO_TEST_CASE(zeros_count_before_whole_numbers_before_bits_before_exponents) {
  const auto is = [](std::string_view line) { return simplicity(read_case_line(line).question); };
  const Simplicity fewer = is("sphere 0 0 0 1 ray 0 0 0.7 0 0 1");
  const Simplicity whole = is("sphere 0 0 0 1 ray 0 7 5 0 0 1");
  const Simplicity few_bits = is("sphere 0 0 0 1 ray 0 7 0.5 0 0 1");
  const Simplicity many_bits = is("sphere 0 0 0 1 ray 0 7 0.7 0 0 1");
  const Simplicity near = is("sphere 0 0 0 1 ray 0 7 5 0 0 1");
  const Simplicity far = is("sphere 0 0 0 1 ray 0 7 5 0 0 8");
  const Simplicity negative = is("sphere 0 0 0 1 ray 0 7 5 0 0 -1");
  BOOST_TEST((fewer < whole && whole < few_bits && few_bits < many_bits));
  BOOST_TEST((near < far && near < negative && negative < far));
}

BOOST_AUTO_TEST_CASE(a_flaw_is_shown_by_the_case_that_a_person_would_write) {
  // Any hit shows a wrong factor.
  BOOST_TEST(shown(minimal_of(planted_subject<planted::WrongFactor, double>(),
                              "sphere 1.5 0.25 3 1.75 ray 9.25 0.75 2.875 -3 0.125 0.25")) ==
             "0 0 0 0 1 0 0 0 0 1 ");
}

BOOST_AUTO_TEST_CASE(a_minimal_case_is_of_the_same_failure_and_no_step_is_left) {
  const Plan plan =
      plan_of({subject_of("handout/float"), subject_of("textbook/float"),
               subject_of("unit_direction/double")},
              {"anywhere", "far", "slender", "lattice"}, {disk, sphere, cylinder, cone});
  const std::vector<Audit> audits = run(plan);
  int found = 0;
  for (const Finding& finding : findings(audits)) {
    const Worst& worst = finding.example;
    const Subject& subject = *finding.audit->subject;
    BOOST_REQUIRE(worst.minimal.has_value());
    const Case& least = worst.minimal->question;
    const std::string line = subject.name + ": " + case_line(least);
    BOOST_TEST((simplicity(least) <= simplicity(worst.question)), line);
    BOOST_TEST(is_alike(subject, worst, least), line);
    BOOST_TEST((worst.minimal->answer == answer_one(subject, least)), line);
    if (subject.format == float_format) BOOST_TEST(are_floats(least), line);
    for (const Case& each : simpler(least, subject.drawn_in()))
      BOOST_TEST(!is_alike(subject, worst, each), line + " and yet " + case_line(each));
    ++found;
  }
  BOOST_TEST(found > 20);
}

BOOST_AUTO_TEST_CASE(a_case_that_rounding_does_not_excuse_shrinks_into_none_that_it_does) {
  const Subject& subject = *subject_of("textbook/float");
  const Worst worst =
      wrong(subject,
            "sphere -0x1.15198p-3 0x1.65ce58p-3 -0x1.b7ad3ep-1 0x1.a2d666p+1 ray 0x1.57f0d6p+13 "
            "0x1.656956p+13 0x1.60127cp+13 -0x1.a7ed0ap-1 -0x1.b876d4p-1 -0x1.b24f06p-1");
  const auto least = minimal({}, audit_of(subject, sphere), worst);
  BOOST_REQUIRE(least.has_value());
  BOOST_TEST(least->margin >= std::min(worst.severity, telling_margin));
  BOOST_TEST((least->diagnosis.cause == Cause::flip));
}

BOOST_AUTO_TEST_CASE(a_minimal_case_is_posed_as_the_subject_is_asked) {
  Subject subject = planted_subject<planted::WrongFactor, float>();
  subject.convention.unit_direction = true;
  subject.convention.t_max = 1024;
  const Case drawn =
      posed(read_case_line("sphere 1.5 0.25 3 1.75 ray 9.25 0.75 2.875 -3 0.5 0.25").question,
            subject.convention, float_format);
  const auto least = minimal_of(subject, case_line(drawn));
  BOOST_REQUIRE(least.has_value());
  const Ray<double>& ray = least->question.ray;
  BOOST_TEST(std::sqrt(dot(ray.direction, ray.direction)) == 1, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(ray.t_max <= 1024);
}

BOOST_AUTO_TEST_CASE(an_unknown_cause_may_be_told_by_the_minimal_case) {
  const Subject subject = planted_subject<planted::WrongFactor, double>();
  const std::string_view line = "sphere 1.53 0.25 3 1.75 ray 9.25 0.75 2.875 -3 0.125 0.25";
  BOOST_TEST((wrong(subject, line).diagnosis.cause == Cause::unknown));
  BOOST_TEST(told(minimal_of(subject, line)->diagnosis) == "formula: in small whole numbers");
}

BOOST_AUTO_TEST_CASE(a_subject_elsewhere_is_asked_a_round_at_a_time_and_once_more) {
  int askings = 0;
  std::size_t largest = 0;
  const Subject subject = elsewhere<planted::WrongFactor, double>(sphere, askings, largest);
  const Worst worst = wrong(subject, "sphere 1.53 0.25 3 1.75 ray 9.25 0.75 2.875 -3 0.125 0.25");
  askings = 0;
  const auto least = minimal({}, audit_of(subject, sphere), worst);
  BOOST_TEST(shown(least) == "0 0 0 0 1 0 0 0 0 1 ");
  // Each round a batch, and alone the case that it found; at the end what shows the cause.
  BOOST_TEST(askings <= 2 * minimal_rounds_elsewhere + 2);
  BOOST_TEST(askings > 5);
  BOOST_TEST(largest > 50);
}

BOOST_AUTO_TEST_CASE(an_answer_that_does_not_repeat_or_never_came_has_no_minimal_case) {
  const Subject subject = planted_subject<planted::WrongFactor, double>();
  Worst worst = wrong(subject, "sphere 1.5 0.25 3 1.75 ray 9.25 0.75 2.875 -3 0.125 0.25");
  worst.repeats = false;
  BOOST_TEST(!minimal({}, audit_of(subject, sphere), worst).has_value());
  worst.repeats = true;
  worst.answer = Answer::timed_out();
  BOOST_TEST(!minimal({}, audit_of(subject, sphere), worst).has_value());
}

BOOST_AUTO_TEST_CASE(a_case_that_ends_a_process_is_asked_alone) {
  int together = 0;
  Subject subject = {"ends", double_format, {}};
  subject.is_elsewhere = true;
  subject.answer[sphere] = [&](std::span<const Case> cases, std::span<Answer> answers) {
    together += cases.size() > 1;
    for (std::size_t i = 0; i < cases.size(); ++i)
      answers[i] = cases[i].ray.origin.x > 2 ? Answer::crashed(11) : Answer::miss();
  };
  const auto least =
      minimal_of(subject, "sphere 1.5 0.25 3 1.75 ray 9.25 0.75 2.875 -3 0.125 0.25");
  BOOST_REQUIRE(least.has_value());
  BOOST_TEST(together == 2);  // the causes of the case found and of the minimal one
  BOOST_TEST(least->question.ray.origin.x > 2);
  BOOST_TEST(least->question.ray.origin.y == 0);
}

BOOST_AUTO_TEST_CASE(what_takes_a_process_a_question_is_asked_few) {
  for (const Answer& none : {Answer::crashed(11), Answer::garbage()}) {
    std::size_t asked = 0;
    Subject subject = {"ends", double_format, {}};
    subject.is_elsewhere = true;
    subject.answer[sphere] = [&](std::span<const Case> cases, std::span<Answer> answers) {
      asked += cases.size();
      for (std::size_t i = 0; i < cases.size(); ++i)
        answers[i] = cases[i].ray.origin.x > 8.7 ? none : Answer::miss();
    };
    const Worst worst =
        wrong(subject, "sphere 1.53 0.27 3.11 1.71 ray 9.27 0.73 2.87 -3.13 0.127 0.253");
    asked = 0;
    const auto least = minimal({}, audit_of(subject, sphere), worst);
    BOOST_REQUIRE(least.has_value());
    BOOST_TEST((simplicity(least->question) < simplicity(worst.question)));
    // The last may be asked again, and for its cause.
    BOOST_TEST(asked <= minimal_cases_without_answer + 1 + transformations().size());
    BOOST_TEST(asked >= minimal_cases_without_answer);
  }
}

BOOST_AUTO_TEST_CASE(who_crashes_at_simpler_cases_is_asked_no_more_before_long) {
  constexpr std::size_t at_once = 8;
  std::size_t crashes = 0;
  Subject subject = {"ends", double_format, {}};
  subject.is_elsewhere = true;
  subject.answer[sphere] = [&](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const bool ends = cases.size() > at_once && i < at_once;
      answers[i] = ends ? Answer::crashed(11) : Answer::miss();
      crashes += ends;
    }
  };
  const Worst worst =
      wrong(subject, "sphere 1.53 0.27 3.11 1.71 ray 9.27 0.73 2.87 -3.13 0.127 0.253");
  crashes = 0;
  const auto least = minimal({}, audit_of(subject, sphere), worst);
  BOOST_REQUIRE(least.has_value());
  BOOST_TEST(crashes >= minimal_cases_without_answer);
  BOOST_TEST(crashes <= minimal_cases_without_answer + 2 * at_once);  // its cause is looked for too
}

BOOST_AUTO_TEST_CASE(conduct_on_an_invalid_case_is_shown_by_one_as_invalid) {
  Subject subject = {"hits", double_format, {}};
  subject.answer[disk] = [](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = Answer::hit(real(1.0));
  };
  const auto least = minimal_of(subject, "disk 1 2 3 0 0 0 1.5 ray 0.1 0.2 0.3 0.4 0.5 0.6");
  BOOST_REQUIRE(least.has_value());
  BOOST_TEST((oracle::truth(least->question).invalid == oracle::Invalid::zero_normal));
  BOOST_TEST(shown(least) == "0 0 0 0 0 1 0 0 0 0 0 0 1 ");
}

BOOST_AUTO_TEST_CASE(minimal_cases_are_the_same_for_any_number_of_threads) {
  Plan plan = plan_of({subject_of("textbook/float"), subject_of("handout/double")},
                      {"anywhere", "far"}, {sphere, cone}, 512);
  const auto lines = [&](int threads) {
    plan.threads = threads;
    std::string all;
    const std::vector<Audit> audits = run(plan);
    for (const Finding& finding : findings(audits))
      all += case_line(finding.example.minimal->question) + '\n';
    return all;
  };
  BOOST_TEST(lines(1) == lines(4));
}

BOOST_AUTO_TEST_CASE(where_no_causes_are_wanted_nothing_is_minimised) {
  Plan plan = plan_of({subject_of("handout/float")}, {"anywhere"}, {sphere}, 512);
  plan.causes = false;
  const std::vector<Audit> audits = run(plan);
  BOOST_REQUIRE(!findings(audits).empty());
  BOOST_TEST(!findings(audits)[0].example.minimal.has_value());
}
