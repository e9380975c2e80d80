#include "routines/stable_roots.hpp"

#include <boost/test/unit_test.hpp>

using namespace rayaudit;

namespace {

/// Are these the roots of a t^2 + b t + c?
void has_roots(double a, double b, double c, double smaller, double larger) {
  const std::optional<Roots<double>> roots = stable_roots(a, b, c, b * b - 4 * a * c);
  BOOST_TEST_CONTEXT(a << " t^2 + " << b << " t + " << c) {
    BOOST_TEST_REQUIRE(roots.has_value());
    BOOST_TEST((roots->one < roots->other ? roots->one : roots->other) == smaller);
    BOOST_TEST((roots->one < roots->other ? roots->other : roots->one) == larger);
  }
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_roots_are_told_whatever_the_signs) {
  has_roots(1, -3, 2, 1, 2);
  has_roots(1, 3, 2, -2, -1);
  has_roots(2, -2, -4, -1, 2);
  has_roots(-1, 1, 2, -1, 2);
}

BOOST_AUTO_TEST_CASE(b_may_be_0) { has_roots(1, 0, -4, -2, 2); }
BOOST_AUTO_TEST_CASE(a_double_root_is_told_twice) { has_roots(1, -4, 4, 2, 2); }
BOOST_AUTO_TEST_CASE(a_double_root_at_0_divides_by_no_0) { has_roots(1, 0, 0, 0, 0); }
BOOST_AUTO_TEST_CASE(a_may_be_0) {
  has_roots(0, 2, -8, 4, 4);
  has_roots(0, -2, -8, -4, -4);
}

BOOST_AUTO_TEST_CASE(where_there_is_no_root_none_is_told) {
  BOOST_TEST(!stable_roots(1.0, 0.0, 1.0, -4.0).has_value());
  BOOST_TEST(!stable_roots(0.0, 0.0, 1.0, 0.0).has_value());
  BOOST_TEST(!stable_roots(0.0, 0.0, 1.0, -1.0).has_value());
}

BOOST_AUTO_TEST_CASE(of_a_steep_line_a_discriminant_below_0_is_taken_for_0) {
  const std::optional<Roots<double>> roots = stable_roots(-1.0, 4.0, -4.0, -0x1p-50);
  BOOST_TEST_REQUIRE(roots.has_value());
  BOOST_TEST(roots->one == 2);
  BOOST_TEST(roots->other == 2);
}
