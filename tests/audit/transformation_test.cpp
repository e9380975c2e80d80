#include "audit/transformation.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "routines/textbook.hpp"
#include "routines/unit_direction.hpp"
#include "subjects/subject_of.hpp"
#include "tests/oracle/replay/planted.hpp"

using namespace rayaudit;

namespace {

/// The cause of a wrong answer that is not replayed.
std::string cause_of(const Subject& subject, std::string_view line) {
  const Case question = read_case_line(line).question;
  const Answer answer = answer_one(subject, question);
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(subject.format));
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, subject.format, subject.convention);
  BOOST_TEST_REQUIRE(is_wrong(judgement.verdict), line);
  return told(
      diagnosis_from_outside({settled, answer, judgement, {}}, subject, subject.convention));
}

template <class Answers>
Subject made_of(std::size_t shape, const Answers& answer) {
  Subject subject = {"made", double_format, {}};
  subject.answer[shape] = [=](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = answer(cases[i]);
  };
  return subject;
}

constexpr std::size_t sphere = 1, cylinder = 2;

/// Right by the textbook, but for what is said first.
Answer by_textbook(const Case& question) {
  Answer said;
  const Textbook routine;
  std::visit([&](const auto& shape) { write(said, routine(question.ray, shape)); }, question.shape);
  return said;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_change_leaves_the_truth_alone) {
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      if (family.draw[shape] == nullptr || family.id == "invalid") continue;
      std::vector<Case> cases(50);
      draw(family, shape, float_format, {}, 5, 0, cases);
      for (const Case& question : cases)
        for (const Transformation& each : transformations()) {
          const auto other = each.change(question, float_format);
          if (!other || each.shows != Transformation::Shows::to_the_bit) continue;
          const oracle::Truth was = oracle::truth(question), is = oracle::truth(other->question);
          BOOST_REQUIRE(was.count == is.count);
          for (int i = 0; i < was.count; ++i) {
            Real t = was.listed[i].t;
            t.exponent += other->t_exponent;
            BOOST_TEST((was.listed[i].kind == is.listed[i].kind), case_line(question));
            BOOST_TEST(compare(t, is.listed[i].t) == 0, case_line(question));
          }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_direction_taken_for_unit_shows_by_its_length) {
  BOOST_TEST(
      cause_of(subject_of<UnitDirection, double>(), "sphere 0 0 0 1 ray 0.5 0.25 -8 0 0 2") ==
      "assumption of the length of the direction");
}

BOOST_AUTO_TEST_CASE(a_direction_that_no_power_of_two_makes_unit_shows_by_its_length_too) {
  BOOST_TEST(
      cause_of(subject_of<UnitDirection, float>(), "cylinder 2 0 0 0 0 0 1 ray 0 0 0 1 0 1") ==
      "assumption of the length of the direction");
}

BOOST_AUTO_TEST_CASE(a_degenerate_case_that_a_rounded_direction_leaves_shows_no_length) {
  for (const std::string ray : {"6 -3 0 1 1 3", "6 -3 0 3 1 5", "6 -3 0 1 2 5", "6 -3 0 5 1 7"})
    BOOST_TEST(cause_of(subject_of<planted::NoParallelCheck, float>(),
                        "disk 0 0 0 1 2 -1 1 ray " + ray) == "formula: in small whole numbers",
               ray);
}

BOOST_AUTO_TEST_CASE(a_tiny_direction_taken_for_unit_is_no_underflow) {
  BOOST_TEST(
      cause_of(subject_of<UnitDirection, float>(), "sphere 0 0 0 1 ray 0 0 2 0 0 -0x1p-31") !=
      "assumption of numbers of moderate size");
}

BOOST_AUTO_TEST_CASE(what_is_lost_from_far_away_shows_by_a_nearer_start) {
  const Subject subject = made_of(sphere, [](const Case& question) {
    const Vec3<double>& o = question.ray.origin;
    return dot(o, o) > 1e6 ? Answer::miss() : by_textbook(question);
  });
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0.5 0.25 -4096.5 0 0 1") ==
             "assumption of where on its line the ray begins");
}

BOOST_AUTO_TEST_CASE(what_cancels_from_far_away_and_not_from_near_is_rounding) {
  BOOST_TEST(cause_of(subject_of<Textbook, float>(), "sphere 0 0 0 1 ray 3.9375 0 -16384 0 0 1") ==
             "rounding");
}

BOOST_AUTO_TEST_CASE(what_is_lost_close_by_shows_by_a_start_further_back) {
  const Subject subject = made_of(sphere, [](const Case& question) {
    const Answer said = by_textbook(question);
    // Less than a thousandth of the shape away, whatever the units.
    const double radius = std::get<Sphere<double>>(question.shape).radius;
    const double length = std::sqrt(dot(question.ray.direction, question.ray.direction));
    return said.form == Answer::Form::hit && said.t.high * length < 0.001 * radius ? Answer::miss()
                                                                                   : said;
  });
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0 0 -1.000244140625 0 0 1") ==
             "assumption of where on its line the ray begins");
}

BOOST_AUTO_TEST_CASE(what_is_lost_on_a_long_shape_shows_by_a_shorter_one) {
  const Subject subject = made_of(cylinder, [](const Case& question) {
    const auto& tube = std::get<Cylinder<double>>(question.shape);
    const Vec3<double> w = tube.top - tube.base;
    return dot(w, w) > 1e6 * tube.radius * tube.radius ? Answer::miss() : by_textbook(question);
  });
  BOOST_TEST(cause_of(subject, "cylinder 0 0 0 0 8192 0 1 ray 9 4099 0.25 -1 0 0") ==
             "assumption of the length of the shape");
}

BOOST_AUTO_TEST_CASE(a_product_that_underflows_shows_elsewhere_in_the_range_of_the_format) {
  BOOST_TEST(
      cause_of(subject_of<Textbook, float>(), "sphere 0 0 0 1 ray 0.5 0.25 -8 0 0 0x1p-80") ==
      "assumption of numbers of moderate size");
}

BOOST_AUTO_TEST_CASE(one_axis_that_is_not_as_the_others_shows) {
  const Subject subject = made_of(sphere, [](const Case& question) {
    return question.ray.direction.z != 0 ? Answer::miss() : by_textbook(question);
  });
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0 0.5 -8 0 0 1") ==
             "assumption of which axis is which");
}

BOOST_AUTO_TEST_CASE(near_another_truth_what_a_turned_world_mends_is_rounding) {
  const Subject subject = made_of(sphere, [](const Case& question) {
    return question.ray.direction.z != 0 ? Answer::miss() : by_textbook(question);
  });
  // It passes the top of the sphere at 2^-50 below.
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0 0x0.ffffffffffffcp0 -8 0 0 1") == "rounding");
}

BOOST_AUTO_TEST_CASE(what_nothing_mends_in_small_whole_numbers_is_the_formula) {
  const Subject subject = subject_of<planted::WrongFactor, double>();
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0.5 0.5 -8 0 0 2") ==
             "formula: in small whole numbers");
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0.5 0.3 -8 0 0 2") == "unknown");
}

BOOST_AUTO_TEST_CASE(all_changed_cases_are_asked_at_once) {
  int askings = 0;
  const Subject subject = made_of(sphere, [](const Case&) { return Answer::miss(); });
  Subject counted = subject;
  counted.answer[sphere] = [&](std::span<const Case> cases, std::span<Answer> answers) {
    ++askings;
    subject.answer[sphere](cases, answers);
  };
  BOOST_TEST(cause_of(counted, "sphere 0 0 0 1 ray 0.5 0.5 -8 0 0 2") ==
             "formula: in small whole numbers");
  BOOST_TEST(askings == 2);  // the case itself, and the rest
}

BOOST_AUTO_TEST_CASE(a_direction_declared_to_be_unit_is_not_asked_in_another_length) {
  Subject subject = subject_of<UnitDirection, double>();
  subject.convention.unit_direction = true;
  int askings = 0;
  const auto answer = subject.answer[sphere];
  subject.answer[sphere] = [&](std::span<const Case> cases, std::span<Answer> answers) {
    for (const Case& each : cases) {
      ++askings;
      BOOST_TEST(dot(each.ray.direction, each.ray.direction) == 4);
    }
    answer(cases, answers);
  };
  BOOST_TEST(cause_of(subject, "sphere 0 0 0 1 ray 0.5 0.25 -8 0 0 2") == "unknown");
  BOOST_TEST(askings > 2);
}
