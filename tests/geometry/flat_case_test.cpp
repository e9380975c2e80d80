#include "geometry/flat_case.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

rayaudit_answer of_form(int form) {
  rayaudit_answer answer = {};
  answer.form = form;
  return answer;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_case_of_each_shape_comes_back_as_it_was) {
  for (const std::string line :
       {"disk 1 2 3 4 5 6 7 ray 8 9 10 11 12 13", "sphere 1 2 3 4 ray 8 9 10 11 12 13",
        "cylinder 1 2 3 4 5 6 7 ray 8 9 10 11 12 13 range -2 7",
        "cone 1 2 3 4 5 6 7 ray 8 9 10 11 12 13 range -inf inf",
        "cone 1 2 3 4 5 6 7 both_nappes ray 8 9 10 11 12 13",
        "disk 1 2 3 4 5 6 7 unbounded ray 8 9 10 11 12 13",
        "capped_cylinder 1 2 3 4 5 6 7 ray 8 9 10 11 12 13",
        "capped_cone 1 2 3 4 5 6 7 ray 8 9 10 11 12 13"}) {
    const Case question = read_case_line(line).question;
    BOOST_TEST((from_flat(flat(question)) == question), line);
  }
}

BOOST_AUTO_TEST_CASE(a_flat_case_has_its_numbers_in_their_places) {
  const Case question =
      read_case_line("cone 1 2 3 4 5 6 7 ray 8 9 10 11 12 13 range 14 15").question;
  const rayaudit_case made = flat(question);
  BOOST_TEST(made.shape == RAYAUDIT_CONE);
  BOOST_TEST(made.is.cone.base.y == 2);
  BOOST_TEST(made.is.cone.apex.z == 6);
  BOOST_TEST(made.is.cone.radius == 7);
  BOOST_TEST(made.ray.origin.x == 8);
  BOOST_TEST(made.ray.direction.z == 13);
  BOOST_TEST(made.ray.t_min == 14);
  BOOST_TEST(made.ray.t_max == 15);
  BOOST_TEST(
      flat(read_case_line("disk 1 2 3 4 5 6 7 ray 8 9 10 11 12 13").question).is.disk.normal.x ==
      4);
}

BOOST_AUTO_TEST_CASE(what_is_answered_is_taken_as_it_is_told) {
  BOOST_TEST((from_flat(rayaudit_miss()) == Answer::miss()));
  BOOST_TEST((from_flat(rayaudit_yes()) == Answer::yes()));
  BOOST_TEST((from_flat(rayaudit_hit(2.5)) == Answer::hit(real(2.5))));
  BOOST_TEST((from_flat(rayaudit_at(1, 2, 3)) == Answer::at({real(1.0), real(2.0), real(3.0)})));
}

BOOST_AUTO_TEST_CASE(a_low_part_counts_to_the_last_bit) {
  const long double third = 1.0L / 3;
  BOOST_TEST((from_flat(rayaudit_hit_long(third)) == Answer::hit(real(third))));
  rayaudit_answer answer = rayaudit_at(1, 0, 0);
  answer.point_low.y = 0x1p-900;
  BOOST_TEST(compare(from_flat(answer).point.y, real(0x1p-900)) == 0);
}

BOOST_AUTO_TEST_CASE(what_is_not_finite_stays_so_whatever_its_low_part) {
  rayaudit_answer answer = rayaudit_hit(infinity);
  answer.t_low = -1;
  BOOST_TEST(is_infinite(from_flat(answer).t));
  answer.t = 1, answer.t_low = std::nan("");
  BOOST_TEST(is_nan(from_flat(answer).t));
  BOOST_TEST(is_infinite(from_flat(rayaudit_hit_long(HUGE_VALL)).t));
}

BOOST_AUTO_TEST_CASE(what_no_double_holds_is_told_to_the_last_bit_all_the_same) {
  using Long = std::numeric_limits<long double>;
  for (const long double x : {Long::max(), -Long::max(), Long::min(), Long::denorm_min(),
                              0x1.23456789abcdef01p+1024L, -0x1.23456789abcdef01p-1073L}) {
    BOOST_TEST(compare(from_flat(rayaudit_hit_long(x)).t, real(x)) == 0, x);
    const Answer point = from_flat(rayaudit_at_long(1, x, x / 3));
    const Answer alone = from_flat(rayaudit_at_long(x / 3, 0, x));
    BOOST_TEST(compare(alone.point.x, real(x / 3)) == 0, x);
    BOOST_TEST(compare(alone.point.z, real(x)) == 0, x);
    BOOST_TEST(compare(std::fabs(x) > 1 ? point.point.y : point.point.x,
                       std::fabs(x) > 1 ? real(x) : real(1.0)) == 0,
               x);
  }
}

BOOST_AUTO_TEST_CASE(an_answer_of_no_known_form_is_garbage) {
  for (const int form : {-1, 4, 77, 1 << 30})
    BOOST_TEST((from_flat(of_form(form)).form == Answer::Form::garbage), form);
}

BOOST_AUTO_TEST_CASE(an_answer_comes_back_as_it_was) {
  for (const Answer& answer :
       {Answer::miss(), Answer::yes(), Answer::hit(real(0.1)), Answer::hit(real(-infinity)),
        Answer::hit(real(1.0L / 3)), Answer::at({real(1.0), real(1.0L / 3), real(3.0)})})
    BOOST_TEST((from_flat(flat(answer)) == answer));
  BOOST_TEST((from_flat(flat(Answer::timed_out())) == Answer::garbage()));
}

BOOST_AUTO_TEST_CASE(an_infinite_t_stays_so_where_its_low_part_is_none) {
  // As rayaudit_hit_long makes it in a program whose compiler takes every number for finite.
  rayaudit_answer answer = rayaudit_hit(infinity);
  answer.t_low = std::nan("");
  BOOST_TEST(is_infinite(from_flat(answer).t));
}
