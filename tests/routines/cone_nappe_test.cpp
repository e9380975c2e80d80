#include "routines/cone_nappe.hpp"

#include <boost/test/unit_test.hpp>

using namespace rayaudit;

namespace {

constexpr double steep = -1, shallow = 1;

std::optional<double> first(double a, const Roots<double>& roots, const Depth<double>& depth) {
  return first_on_nappe(a, roots, depth, [](double t) { return t > 0; });
}

}  // namespace

BOOST_AUTO_TEST_CASE(of_a_steep_line_the_root_on_the_side_of_the_base_counts) {
  BOOST_TEST((first(steep, {2, 4}, {-3, 1, 8}) == 4));
  BOOST_TEST((first(steep, {4, 2}, {-3, 1, 8}) == 4));
  BOOST_TEST((first(steep, {2, 4}, {3, -1, 8}) == 2));
  BOOST_TEST((first(steep, {4, 2}, {3, -1, 8}) == 2));
}

BOOST_AUTO_TEST_CASE(of_a_steep_line_a_depth_just_above_the_apex_is_rounding) {
  BOOST_TEST((first(steep, {2, 2}, {-2 - 0x1p-50, 1, 8}) == 2));
}

BOOST_AUTO_TEST_CASE(of_a_shallow_line_both_roots_lie_on_one_nappe) {
  BOOST_TEST((first(shallow, {2, 4}, {1, 1, 8}) == 2));
  BOOST_TEST(!first(shallow, {2, 4}, {-5, 1, 8}).has_value());
}

BOOST_AUTO_TEST_CASE(below_the_base_nothing_counts) {
  BOOST_TEST(!first(steep, {2, 4}, {-3, 4, 8}).has_value());
  BOOST_TEST(!first(shallow, {2, 4}, {7, 1, 8}).has_value());
  BOOST_TEST((first(shallow, {2, 4}, {11, -1, 8}) == 4));
}

BOOST_AUTO_TEST_CASE(the_condition_is_asked_of_either_root) {
  BOOST_TEST((first(shallow, {-1, 4}, {4, 1, 8}) == 4));
  BOOST_TEST(!first(steep, {-2, 4}, {1, -1, 8}).has_value());
}
