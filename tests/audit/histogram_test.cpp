#include "audit/histogram.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

using rayaudit::Histogram;

BOOST_AUTO_TEST_CASE(an_octave_holds_what_lies_from_one_power_of_two_to_the_next) {
  Histogram errors;
  for (const double error : {0.5, 0.99, 1.0, 1.999, 2.0, 3.0, 3.999}) errors.add(error);
  BOOST_TEST(errors.octave(-2) == 0);
  BOOST_TEST(errors.octave(-1) == 2);
  BOOST_TEST(errors.octave(0) == 2);
  BOOST_TEST(errors.octave(1) == 3);
  BOOST_TEST(errors.octave(2) == 0);
}

BOOST_AUTO_TEST_CASE(the_octaves_at_the_ends_hold_all_the_rest_and_none_is_lost) {
  Histogram errors;
  for (const double error : {0.0, 1e-300, 0.00097, 1e300, std::numeric_limits<double>::infinity()})
    errors.add(error);
  BOOST_TEST(errors.octave(Histogram::least_octave) == 3);
  BOOST_TEST(errors.octave(Histogram::most_octave) == 2);
  std::uint64_t all = 0;
  for (int i = Histogram::least_octave; i <= Histogram::most_octave; ++i) all += errors.octave(i);
  BOOST_TEST(all == errors.count());
}
