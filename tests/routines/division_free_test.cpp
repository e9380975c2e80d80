#include "routines/division_free.hpp"

#include <boost/test/unit_test.hpp>

#include "known.hpp"

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_hits_from_outside) { known::answers<DivisionFree>(known::from_outside); }
BOOST_AUTO_TEST_CASE(it_misses_what_it_passes_by) {
  known::answers<DivisionFree>(known::passing_by);
}
BOOST_AUTO_TEST_CASE(what_lies_behind_is_a_miss) { known::answers<DivisionFree>(known::behind); }
BOOST_AUTO_TEST_CASE(parallel_rays_are_told_apart) {
  known::answers<DivisionFree>(known::parallel);
}
BOOST_AUTO_TEST_CASE(the_range_is_open_at_both_ends) {
  known::answers<DivisionFree>(known::in_a_range);
}
BOOST_AUTO_TEST_CASE(it_answers_in_general_position) {
  known::answers_in_general_position<DivisionFree>();
}

BOOST_AUTO_TEST_CASE(no_size_and_no_direction_is_too_large_or_too_small) {
  known::answers_at_every_scale<DivisionFree>();
}
