#include "subjects/exact.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <cfenv>
#include <cmath>
#include <filesystem>
#include <thread>
#include <tuple>
#include <vector>

#include "audit/judge.hpp"
#include "oracle/truth.hpp"
#include "tests/families/drawn.hpp"

using namespace rayaudit;

namespace {

const Subject& subject_of(std::string_view name) {
  static const std::vector<Subject> subjects = exact_subjects();
  for (const Subject& subject : subjects)
    if (subject.name == name) return subject;
  throw Error("no subject " + std::string(name));
}

std::vector<Answer> answers_of(const Subject& subject, std::size_t shape,
                               const std::vector<Case>& cases) {
  std::vector<Answer> answers(cases.size());
  subject.answer[shape](cases, answers);
  return answers;
}

/// The first proper crossing with its t rounded, every touch passed by.
Answer true_answer(const Case& question) {
  const oracle::Truth truth = oracle::truth(question);
  const oracle::Crossing* hit = truth.hit();
  return hit ? Answer::hit(real(oracle::rounded<double>(question, *hit))) : Answer::miss();
}

/// Calls visit(family, shape, cases) with cases of every family and shape in double.
template <class V>
void each_family(std::size_t count, V&& visit) {
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      if (family.draw[shape] != nullptr)
        visit(family, shape, drawn(family, shape, double_format, {}, 3, count));
}

/// Holds holds(answer, true answer) of every case of every family.
template <class H>
void hold_everywhere(std::string_view name, std::size_t count, H&& holds) {
  each_family(count, [&](const Family& family, std::size_t shape, const std::vector<Case>& cases) {
    const std::vector<Answer> answers = answers_of(subject_of(name), shape, cases);
    for (std::size_t i = 0; i < cases.size(); ++i)
      if (!holds(cases[i], answers[i])) {
        std::string line = case_line(cases[i]) + ' ';
        write(line, answers[i]);
        BOOST_ERROR(name << ", " << family.id << ": " << line);
        return;
      }
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(cases_worked_by_hand_are_answered_right) {
  const char* lines[] = {
      "disk 0 0 0 0 0 2 1 ray 0 0 5 0 0 -1 hit 5 # along the normal",
      "disk 0 0 0 0 0 2 1 ray 2 0 5 0 0 -1 miss # beside",
      "disk 0 0 0 0 0 2 1 ray 1 0 5 0 0 -1 miss # the rim, passed by",
      "disk 0 0 0 0 0 2 1 ray 0 0 5 0 0 1 miss # behind",
      "disk 0 0 0 0 0 2 1 ray -5 0 0 1 0 0 miss # within the plane",
      "disk 0 0 1 0 0 2 1 ray 0 0 -0x1p-53 0 0 1 hit 1 # a tie goes to the even double",
      "disk 0 0 0x1.0000000000001p+0 0 0 2 1 ray 0 0 -0x1p-53 0 0 1 hit 0x1.0000000000002p+0",
      "disk 0 0 0x1.8p-539 0 0 2 1 ray 0 0 0 0 0 0x1p535 hit 0x1p-1073 # a subnormal tie",
      "disk 0 0 0x1p1023 0 0 2 0x1p1000 ray 0 0 -0x1p1023 0 0 0.25 hit inf # 2^1026",
      "sphere 0 0 0 1 ray -3 0 0 1 0 0 hit 2 # from outside",
      "sphere 0 0 0 1 ray 0 0 0 2 0 0 hit 0.5 # from inside",
      "sphere 0 0 0 1 ray -3 1 0 1 0 0 miss # tangent, passed by",
      "sphere 0 0 0 1 ray -1 0 0 1 0 0 hit 2 # starts on it",
      "sphere 0 0 0 1 ray -3 0 0 1 0 0 range 3 inf hit 4 # the second crossing",
      "sphere 0 0 0 1 ray -3 0 0 1 0 0 range 0 2 miss # ends on it",
      "sphere 0 0 0 0x1p-540 ray 0x1p-539 0 0 -0x1p500 0 0 hit 0x1p-1040 # tiny and fast",
      "sphere 0 0 0 0 ray -3 0 0 1 0 0 miss # no radius",
      "cylinder 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 hit 2 # across",
      "cylinder 0 0 0 0 1 0 1 ray -3 0 0 1 0 0 miss # along the rim",
      "cylinder 0 0 0 0 1 0 1 ray 0 -1 0 0 1 0 miss # along the axis",
      "cylinder 0 0 0 0 1 0 1 ray -3 0.5 1 1 0 0 miss # tangent, passed by",
      "cylinder 0 0 0 0 1 0 1 ray -1.5 1.5 0 2 -1 0 hit 1.25 # in at the open top",
      "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 hit 2.5 # across",
      "cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0 miss # the mirrored nappe",
      "cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0 miss # over the apex, passed by",
      "cone 0 0 0 0 1 0 1 ray 0 -1 0 0 1 0 hit 2 # through the apex from inside",
      "cone 0 0 0 0 1 0 1 ray 2 0 0 -1 1 0 range 0.5 inf miss # along a line of the other nappe",
      "cone 0 0 0 0 1 0 1 ray 0 -0.5 0 1 1 0 hit 0.75 # parallel to a generator",
  };
  for (const char* line : lines) {
    const CaseLine told = read_case_line(line);
    for (const Subject& subject : exact_subjects())
      BOOST_TEST((answer_one(subject, told.question) == *told.answer),
                 subject.name << ": " << line);
  }
}

BOOST_AUTO_TEST_CASE(no_exact_number_takes_what_underflows_for_zero) {
  const char* line = "disk 0 0 0x1p600 0 0 2 1 ray 0 0 -0x1p600 0 0 0.25 hit 0x1p603";
  const CaseLine told = read_case_line(line);
  for (const Subject& subject : exact_subjects())
    if (subject.name != "interval/double")
      BOOST_TEST((answer_one(subject, told.question) == *told.answer),
                 subject.name << ": " << line);
}

BOOST_AUTO_TEST_CASE(exact_numbers_give_the_truth_correctly_rounded) {
  for (const Subject& subject : exact_subjects())
    if (subject.name != "interval/double" && subject.name != "epeck/double")
      hold_everywhere(
          subject.name, subject.name == "epeck_sqrt/double" ? 40 : 512,
          [](const Case& question, const Answer& said) { return said == true_answer(question); });
}

BOOST_AUTO_TEST_CASE(lazy_numbers_give_the_truth_and_its_t_to_40_bits) {
  hold_everywhere("epeck/double", 512, [](const Case& question, const Answer& said) {
    const Answer truth = true_answer(question);
    if (said.form != truth.form || said == truth) return said.form == truth.form;
    const double gap = std::fabs(said.t.high - truth.t.high);
    return gap <= 0x1p-40 * std::fabs(truth.t.high);
  });
}

BOOST_AUTO_TEST_CASE(what_intervals_prove_is_so) {
  std::size_t proved = 0, all = 0;
  hold_everywhere("interval/double", 512, [&](const Case& question, const Answer& said) {
    if (said.stage == 0) return oracle::truth(question).invalid != oracle::Invalid::no;
    ++all;
    if (said.stage != 1) return true;
    ++proved;
    return said.form == true_answer(question).form &&
           !is_wrong(judge(question, said, double_format).verdict);
  });
  BOOST_TEST(proved > all / 2);
  BOOST_TEST(proved < all);
}

BOOST_AUTO_TEST_CASE(intervals_prove_what_is_nothing_special_and_guess_tangents) {
  for (const auto& [id, least, most] : {std::tuple{"anywhere", 0.99, 1.0}, {"tangent", 0.0, 0.6}})
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      if (family_of(id).draw[shape] == nullptr) continue;
      double proved = 0;
      for (const Answer& said : answers_of(subject_of("interval/double"), shape,
                                           drawn(family_of(id), shape, double_format)))
        proved += said.stage == 1 ? 1. / chunk_cases : 0;
      BOOST_TEST(proved >= least, id << ' ' << shape_names[shape] << ": " << proved);
      BOOST_TEST(proved <= most, id << ' ' << shape_names[shape] << ": " << proved);
    }
}

BOOST_AUTO_TEST_CASE(the_oracle_tells_who_decided) {
  hold_everywhere("oracle/double", 64, [](const Case& question, const Answer& said) {
    const oracle::Truth truth = oracle::truth(question);
    if (truth.invalid != oracle::Invalid::no) return said.stage == 0;
    return said.stage == (truth.stage >= oracle::Stage::integers   ? 3
                          : truth.stage == oracle::Stage::interval ? 2
                                                                   : 1);
  });
}

BOOST_AUTO_TEST_CASE(a_guess_may_be_wrong) {
  int guessed = 0, wrong = 0;
  hold_everywhere("interval/double", 512, [&](const Case& question, const Answer& said) {
    if (said.stage == 2) {
      ++guessed;
      wrong += is_wrong(judge(question, said, double_format).verdict) ? 1 : 0;
    }
    return true;
  });
  BOOST_TEST(guessed > 1000);
  BOOST_TEST(wrong > 100);
  BOOST_TEST(wrong < guessed / 2);
}

BOOST_AUTO_TEST_CASE(the_answer_does_not_depend_on_its_batch) {
  for (const Subject& subject : exact_subjects())
    hold_everywhere(subject.name, subject.dear > 10 ? 8 : 150,
                    [&](const Case& question, const Answer& said) {
                      const Answer alone = answer_one(subject, question);
                      return alone == said && alone.stage == said.stage;
                    });
}

BOOST_AUTO_TEST_CASE(threads_get_the_same_answers) {
  for (const Subject& subject : exact_subjects()) {
    const std::vector<Case> cases = drawn(family_of("tangent-near"), 3, double_format, {}, 0, 64);
    const std::vector<Answer> alone = answers_of(subject, 3, cases);
    std::vector<Answer> one, other;
    std::thread first([&] { one = answers_of(subject, 3, cases); });
    std::thread second([&] { other = answers_of(subject, 3, cases); });
    first.join(), second.join();
    BOOST_TEST((one == alone && other == alone), subject.name);
  }
}

BOOST_AUTO_TEST_CASE(upward_rounding_never_leaves_the_intervals) {
  const std::vector<Case> cases = drawn(family_of("anywhere"), 3, double_format, {}, 0, 128);
  for (const Subject& subject : exact_subjects()) {
    answers_of(subject, 3, cases);
    BOOST_TEST(std::fegetround() == FE_TONEAREST, subject.name);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_written_into_the_folder_that_we_run_in) {
  namespace fs = std::filesystem;
  const fs::path before = fs::current_path();
  const fs::path empty = fs::temp_directory_path() / ("exact_test." + std::to_string(getpid()));
  fs::create_directory(empty);
  fs::current_path(empty);
  for (const std::string_view id : {"tangent-near", "scale", "grazing"})
    answers_of(subject_of("epeck_sqrt/double"), 3,
               drawn(family_of(id), 3, double_format, {}, 0, 100));
  BOOST_TEST(fs::is_empty(empty));
  fs::current_path(before);
  fs::remove_all(empty);
}

BOOST_AUTO_TEST_CASE(an_empty_batch_is_answered) {
  for (const Subject& subject : exact_subjects())
    for (const Subject::Batch& answer : subject.answer) answer({}, {});
}
