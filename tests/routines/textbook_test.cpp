#include "routines/textbook.hpp"

#include <boost/test/unit_test.hpp>

#include "known.hpp"

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_hits_from_outside) { known::answers<Textbook>(known::from_outside); }
BOOST_AUTO_TEST_CASE(it_misses_what_it_passes_by) { known::answers<Textbook>(known::passing_by); }
BOOST_AUTO_TEST_CASE(it_hits_from_inside) { known::answers<Textbook>(known::from_inside); }
BOOST_AUTO_TEST_CASE(what_lies_behind_is_a_miss) { known::answers<Textbook>(known::behind); }
BOOST_AUTO_TEST_CASE(a_clipped_crossing_is_passed_over) {
  known::answers<Textbook>(known::clipped);
}
BOOST_AUTO_TEST_CASE(parallel_rays_are_told_apart) { known::answers<Textbook>(known::parallel); }
BOOST_AUTO_TEST_CASE(the_mirrored_nappe_does_not_count) {
  known::answers<Textbook>(known::one_nappe);
}
BOOST_AUTO_TEST_CASE(a_ray_through_the_apex_from_inside_hits) {
  known::answers<Textbook>(known::through_the_apex);
}
BOOST_AUTO_TEST_CASE(the_range_is_open_at_both_ends) {
  known::answers<Textbook>(known::in_a_range);
}
BOOST_AUTO_TEST_CASE(an_edge_lets_no_ray_through) { known::answers<Textbook>(known::edges); }
BOOST_AUTO_TEST_CASE(it_answers_in_general_position) {
  known::answers_in_general_position<Textbook>();
}

BOOST_AUTO_TEST_CASE(in_float_it_loses_the_radius_at_a_distance) {
  const Ray<float> passing = {{-0x1p20f, 1.25f, 0}, {1, 0, 0}};
  BOOST_TEST(Textbook()(passing, Sphere<float>{{0, 0, 0}, 1}).has_value());
}
