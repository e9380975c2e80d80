#include "routines/unit_space.hpp"

#include <boost/test/unit_test.hpp>

#include "known.hpp"

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_hits_from_outside) { known::answers<UnitSpace>(known::from_outside); }
BOOST_AUTO_TEST_CASE(it_misses_what_it_passes_by) { known::answers<UnitSpace>(known::passing_by); }
BOOST_AUTO_TEST_CASE(it_hits_from_inside) { known::answers<UnitSpace>(known::from_inside); }
BOOST_AUTO_TEST_CASE(what_lies_behind_is_a_miss) { known::answers<UnitSpace>(known::behind); }
BOOST_AUTO_TEST_CASE(a_clipped_crossing_is_passed_over) {
  known::answers<UnitSpace>(known::clipped);
}
BOOST_AUTO_TEST_CASE(parallel_rays_are_told_apart) { known::answers<UnitSpace>(known::parallel); }
BOOST_AUTO_TEST_CASE(the_mirrored_nappe_does_not_count) {
  known::answers<UnitSpace>(known::one_nappe);
}
BOOST_AUTO_TEST_CASE(a_ray_through_the_apex_from_inside_hits) {
  known::answers<UnitSpace>(known::through_the_apex);
}
BOOST_AUTO_TEST_CASE(the_range_is_open_at_both_ends) {
  known::answers<UnitSpace>(known::in_a_range);
}
BOOST_AUTO_TEST_CASE(it_answers_in_general_position) {
  known::answers_in_general_position<UnitSpace>();
}
