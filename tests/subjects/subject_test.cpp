#include "subjects/subject.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <string_view>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

const Subject& built_in(std::string_view name) {
  const std::vector<Subject>& subjects = built_in_subjects();
  const auto found = std::find_if(subjects.begin(), subjects.end(),
                                  [&](const Subject& subject) { return subject.name == name; });
  BOOST_TEST_REQUIRE((found != subjects.end()), name);
  return *found;
}

std::vector<Case> cases_of(const std::vector<std::string_view>& lines) {
  std::vector<Case> cases;
  for (const std::string_view line : lines) cases.push_back(read_case_line(line).question);
  return cases;
}

/// The names of the shapes that a subject answers, in their order.
std::string shapes_of(std::string_view name) {
  std::string shapes;
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    if (built_in(name).answers(shape)) shapes += std::string(shape_names[shape]) + ' ';
  return shapes;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_routine_is_there_in_float_double_and_long_double_and_two_are_certified) {
  std::string names;
  for (const Subject& subject : built_in_subjects()) names += subject.name + '\n';
  BOOST_TEST(names ==
             "handout/float\nhandout/double\nhandout/long_double\n"
             "textbook/float\ntextbook/double\ntextbook/long_double\n"
             "unit_direction/float\nunit_direction/double\nunit_direction/long_double\n"
             "unit_space/float\nunit_space/double\nunit_space/long_double\n"
             "stable_quadratic/float\nstable_quadratic/double\nstable_quadratic/long_double\n"
             "closest_approach/float\nclosest_approach/double\nclosest_approach/long_double\n"
             "division_free/float\ndivision_free/double\ndivision_free/long_double\n"
             "certified/float\ncertified/double\n");
}

BOOST_AUTO_TEST_CASE(a_subject_answers_the_shapes_that_its_routine_takes) {
  BOOST_TEST(shapes_of("handout/float") == "disk sphere ");
  BOOST_TEST(shapes_of("textbook/double") ==
             "disk sphere cylinder cone capped_cylinder capped_cone ");
  BOOST_TEST(shapes_of("unit_space/double") == "disk sphere cylinder cone ");
  BOOST_TEST(shapes_of("stable_quadratic/double") ==
             "sphere cylinder cone capped_cylinder capped_cone ");
  BOOST_TEST(shapes_of("closest_approach/long_double") ==
             "sphere cylinder cone capped_cylinder capped_cone ");
  BOOST_TEST(shapes_of("division_free/float") == "disk ");
}

BOOST_AUTO_TEST_CASE(cases_are_drawn_in_float_for_float_and_in_double_for_wider_formats) {
  BOOST_TEST((built_in("textbook/float").drawn_in() == float_format));
  BOOST_TEST((built_in("textbook/double").drawn_in() == double_format));
  BOOST_TEST((built_in("textbook/long_double").drawn_in() == double_format));
  BOOST_TEST((built_in("textbook/long_double").format == long_double_format));
}

BOOST_AUTO_TEST_CASE(the_routine_runs_in_the_number_of_its_name) {
  // t is the root of 1/3 up to what the number holds.
  const Case question = read_case_line("disk 0 1 0 0 3 0 9 ray 0 0 0 0 3 0").question;
  BOOST_TEST((answer_one(built_in("textbook/float"), question).t == real(1.0f / 3.0f)));
  BOOST_TEST((answer_one(built_in("textbook/double"), question).t == real(1.0 / 3.0)));
  BOOST_TEST((answer_one(built_in("textbook/long_double"), question).t == real(1.0L / 3.0L)));
}

BOOST_AUTO_TEST_CASE(wider_numbers_keep_all_their_bits_and_are_asked_for_by_name_only) {
  const Case question = read_case_line("disk 0 1 0 0 3 0 9 ray 0 0 0 0 3 0").question;
  // A third has a 1 in every second place: at 2^-2, 2^-4, up to the last of the number.
  const Real of_106 = {0x1.5555555555555p-2, 0x1.5555555555555p-56, 0, 0};
  const Real of_113 = {0x1.5555555555555p-2, 0x1.5555555555555p-56, 0x1.5p-110, 0};
  std::size_t found = 0;
  for (const Subject& subject : all_subjects()) {
    const bool is_built_in = std::ranges::count(built_in_subjects(), subject.name, &Subject::name);
    BOOST_TEST(subject.by_name_only == !is_built_in, subject.name);
    const bool is_float128 = subject.name == "textbook/float128";
    if (!is_float128 && subject.name != "textbook/double_double") continue;
    ++found;
    const Real& third = is_float128 ? of_113 : of_106;
    BOOST_TEST(compare(answer_one(subject, question).t, third) == 0, subject.name);
    BOOST_TEST((subject.drawn_in() == double_format));
  }
#ifdef __clang__
  BOOST_TEST(found == 1u);
  BOOST_TEST(absent_subjects().front().subjects == "*/float128");
#else
  BOOST_TEST(found == 2u);
#endif
}

BOOST_AUTO_TEST_CASE(the_form_of_an_answer_is_what_the_routine_returns) {
  const auto cases = cases_of({"disk 0 0 0 0 1 0 1 ray 0 2 0 0 -1 0",
                               "sphere 0 0 0 1 ray 0 0 0 1 0 0", "sphere 0 0 0 1 ray 0 9 0 1 0 0"});
  const Subject& handout = built_in("handout/double");
  BOOST_TEST((answer_one(handout, cases[0]) == Answer::yes()));
  BOOST_TEST((answer_one(handout, cases[1]) == Answer::at({real(1.0), real(0.0), real(0.0)})));
  BOOST_TEST((answer_one(handout, cases[2]) == Answer::miss()));
  const Subject& textbook = built_in("textbook/double");
  BOOST_TEST((answer_one(textbook, cases[0]) == Answer::hit(real(2.0))));
  BOOST_TEST((answer_one(textbook, cases[2]) == Answer::miss()));
}

BOOST_AUTO_TEST_CASE(a_batch_is_answered_case_by_case_in_its_order) {
  const auto cases = cases_of({"sphere 0 0 0 1 ray -3 0 0 1 0 0", "sphere 0 0 0 1 ray -3 9 0 1 0 0",
                               "sphere 0 0 0 1 ray -5 0 0 1 0 0"});
  std::vector<Answer> answers(cases.size(), Answer::yes());
  built_in("textbook/double").answer[cases[0].shape.index()](cases, answers);
  BOOST_TEST((answers[0] == Answer::hit(real(2.0))));
  BOOST_TEST((answers[1] == Answer::miss()));
  BOOST_TEST((answers[2] == Answer::hit(real(4.0))));
}

BOOST_AUTO_TEST_CASE(a_mix_of_shapes_is_answered_in_its_order) {
  const auto cases =
      cases_of({"sphere 0 0 0 1 ray -3 0 0 1 0 0", "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0",
                "cone 0 0 0 0 1 0 1 ray -4 0.5 0 1 0 0", "disk 0 0 0 0 1 0 1 ray 0 2 0 0 -1 0",
                "sphere 0 0 0 1 ray -6 0 0 1 0 0"});
  std::vector<Answer> answers(cases.size());
  answer_mixed(built_in("textbook/double"), cases, answers);
  const std::vector<double> t = {2, 2.5, 3.5, 2, 5};
  for (std::size_t i = 0; i < cases.size(); ++i)
    BOOST_TEST((answers[i] == Answer::hit(real(t[i]))), case_line(cases[i]));
}
