#include "audit/beyond_rounding.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

/// Is the answer of a line, which must be wrong, beyond rounding in the format?
bool is_beyond(const std::string& line, const Format& format = float_format,
               const Convention& convention = {}) {
  const CaseLine read = read_case_line(line);
  const oracle::Truth truth = oracle::truth(read.question, oracle::bits_for(format));
  Settled settled(read.question, truth);
  const Judgement judgement = judge(settled, *read.answer, format, convention);
  BOOST_TEST_REQUIRE(is_wrong(judgement.verdict), line);
  const double margin = std::ldexp(settled.reach(), format.precision);
  return is_beyond_rounding(settled, *read.answer, judgement, margin, format, convention);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_plain_case_answered_wrongly_is) {
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 miss"));
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 hit 3.8660254"));
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 hit 2.5"));
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 2 -3 0 0 1 yes"));
  BOOST_TEST(is_beyond("capped_cylinder 0 0 -1 0 0 1 1 ray 0.5 0 -3 0 0 1 miss"));
  BOOST_TEST(is_beyond("cylinder 0 0 -1 0 0 1 1 unbounded ray -3 0 8 1 0 0 miss"));
}

BOOST_AUTO_TEST_CASE(near_another_truth_it_is_not) {
  BOOST_TEST(!is_beyond("sphere 0 0 0 1 ray 0 0x1.fffffep-1 -3 0 0 1 miss"));
  BOOST_TEST(!is_beyond("sphere 0 0 0 1 ray 0 0x1.fffep-1 -3 0 0 1 miss"));
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 0x1.fffep-1 -3 0 0 1 miss", double_format));
}

BOOST_AUTO_TEST_CASE(where_the_textbook_proves_nothing_it_is_not) {
  // From so far away every digit of the discriminant is lost in float.
  const std::string far = "sphere 0 0 0 1 ray 0 0.5 -1048576 0 0 1 miss";
  BOOST_TEST(!is_beyond(far));
  BOOST_TEST(is_beyond(far, double_format));
}

BOOST_AUTO_TEST_CASE(a_wrong_t_is_where_it_is_further_off_than_the_textbook_could_be) {
  const std::string on_surface = "sphere 0 0 4 3 ray 0 0 0x1.fffffep-1 0 0 1 range -100 100 ";
  BOOST_TEST(!is_beyond(on_surface + "hit 0x1p-23"));
  BOOST_TEST(!is_beyond(on_surface + "hit 0x1.8p-12"));
  BOOST_TEST(is_beyond(on_surface + "hit 0x1p-2"));
  BOOST_TEST(is_beyond(on_surface + "hit 0x1p-23", double_format));
}

BOOST_AUTO_TEST_CASE(no_answer_is_where_the_textbook_has_one_and_what_becomes_of_no_case_never) {
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 crashed"));
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 3 -3 0 0 1 timed_out"));
  BOOST_TEST(!is_beyond("sphere 0 0 0 1 ray 0 0.5 -1048576 0 0 1 timed_out"));
  BOOST_TEST(!is_beyond("sphere 0 0 0 1 ray 0 0 -3 0 0 0 hit 3"));
}

BOOST_AUTO_TEST_CASE(a_t_that_is_not_finite_needs_no_margin_but_the_textbook_s_proof) {
  BOOST_TEST(is_beyond("sphere 0 0 0 1 ray 0 0x1.ffep-1 -3 0 0 1 hit nan"));
  BOOST_TEST(!is_beyond("sphere 0 0 0 1 ray 0 0.5 -1048576 0 0 1 hit nan"));
}

BOOST_AUTO_TEST_CASE(where_a_product_of_four_leaves_the_range_it_is_not) {
  BOOST_TEST(is_beyond("sphere 0 0 0 0x1p+30 ray 0 0 0 0 0 1 miss"));
  BOOST_TEST(!is_beyond("sphere 0 0 0 0x1p+33 ray 0 0 0 0 0 1 miss"));
  BOOST_TEST(is_beyond("sphere 0 0 0 0x1p+33 ray 0 0 0 0 0 1 miss", double_format));
  BOOST_TEST(!is_beyond("disk 0 0 0 0 0 0x1p-40 1 ray 0 0 -1 0 0 1 miss"));
}

BOOST_AUTO_TEST_CASE(no_answer_is_up_to_where_squares_leave_it) {
  BOOST_TEST(is_beyond("sphere 0 0 0 0x1p+61 ray 0 0 0 0 0 1 crashed"));
  BOOST_TEST(!is_beyond("sphere 0 0 0 0x1p+64 ray 0 0 0 0 0 1 crashed"));
}

BOOST_AUTO_TEST_CASE(a_point_off_by_no_more_than_its_rounding_is_not) {
  const std::string near = "disk 0 0 0 1 0 0 1 unbounded ray -0x1p-30 0.5 0 4 1 0 ";
  BOOST_TEST(!is_beyond(near + "at 0x1p-28 0.50000006 0"));
  BOOST_TEST(is_beyond(near + "at 0x1p-8 0.501 0"));
  BOOST_TEST(is_beyond("disk 0 0 0 1 0 0 1 unbounded ray -4 0.5 0 4 1 0 hit 1.5"));
}

BOOST_AUTO_TEST_CASE(a_cone_told_by_its_angle_or_cosine_is_held_to_what_that_tells) {
  Convention by_angle, by_cosine;
  by_angle.opening = Convention::Opening::angle, by_cosine.opening = Convention::Opening::cosine;
  const std::string wide = "cone 0 0 -0.5 0 0 0.5 0x1p+10 unbounded ray 0x1p+5 0 -3 0 0 1 miss";
  BOOST_TEST(is_beyond(wide, float_format));
  BOOST_TEST(!is_beyond(wide, float_format, by_angle));
  BOOST_TEST(is_beyond(wide, float_format, by_cosine));
  const std::string slim = "cone 0 0 -0.5 0 0 0.5 0x1p-10 unbounded ray 0 0 -3 0x1p-12 0 1 miss";
  BOOST_TEST(is_beyond(slim, double_format));
  BOOST_TEST(!is_beyond(slim, float_format, by_cosine));
}

BOOST_AUTO_TEST_CASE(an_edge_itself_is_anybody_s) {
  // Through the edge of both surfaces, into the solid.
  BOOST_TEST(!is_beyond("capped_cylinder 0 0 -0.5 0 0 0.5 1 ray 8 0 7.5 -1 0 -1 miss"));
  BOOST_TEST(is_beyond("capped_cylinder 0 0 -0.5 0 0 0.5 1 ray 8 0 7 -1 0 -1 miss"));
}

BOOST_AUTO_TEST_CASE(what_is_declared_to_be_a_miss_and_told_is_though_the_textbook_takes_it) {
  Convention from_outside;
  from_outside.inside = Convention::Inside::miss;
  BOOST_TEST(
      is_beyond("sphere 0 0 0 1 ray 0 0.5 0 0 0 1 hit 0.8660254", float_format, from_outside));
}
