#include "routines/power_of_two.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_is_the_largest_power_of_two_that_is_at_most_the_size) {
  BOOST_TEST(power_of_two(1.0) == 1.0);
  BOOST_TEST(power_of_two(1.75) == 1.0);
  BOOST_TEST(power_of_two(2.0) == 2.0);
  BOOST_TEST(power_of_two(0.3) == 0.25);
  BOOST_TEST(power_of_two(0x1.8p300) == 0x1p300);
  BOOST_TEST(power_of_two(0x1.8p-300) == 0x1p-300);
}

BOOST_AUTO_TEST_CASE(it_goes_to_the_ends_of_the_format) {
  BOOST_TEST(power_of_two(std::numeric_limits<float>::max()) == 0x1p127f);
  BOOST_TEST(power_of_two(std::numeric_limits<float>::denorm_min()) == 0x1p-149f);
  BOOST_TEST(power_of_two(std::numeric_limits<double>::max()) == 0x1p1023);
  BOOST_TEST(power_of_two(std::numeric_limits<double>::denorm_min()) == 0x1p-1074);
}

BOOST_AUTO_TEST_CASE(it_ends_for_what_has_no_power_of_two) {
  const double inf = std::numeric_limits<double>::infinity();
  BOOST_TEST(power_of_two(0.0) == 1.0);
  BOOST_TEST(power_of_two(-3.0) == 1.0);
  BOOST_TEST(power_of_two(inf) == inf);
  BOOST_TEST(power_of_two(std::numeric_limits<double>::quiet_NaN()) == 1.0);
}

BOOST_AUTO_TEST_CASE(the_largest_component_is_taken_absolutely) {
  BOOST_TEST(largest_component(Vec3<double>{1, -3, 2}) == 3);
  BOOST_TEST(largest_component(Vec3<double>{-4, 3, 2}) == 4);
  BOOST_TEST(largest_component(Vec3<double>{1, 3, -5}) == 5);
}
