#include "tests/oracle/second_derivation/by_sturm.hpp"
#include "tests/oracle/second_derivation/held.hpp"
#include "tests/oracle/second_derivation/proved.hpp"

namespace rayaudit::second {
namespace {

using enum oracle::Kind;

constexpr std::size_t cylinder = 2, cone = 3;

BOOST_AUTO_TEST_CASE(proved_cases_are_derived_right) {
  hold_proved(cylinder, by_sturm);
  hold_proved(cone, by_sturm);
  hold_proved(capped_cylinder, by_sturm);
  hold_proved(capped_cone, by_sturm);
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_cylinders) {
  hold(cylinder, 20'000, by_sturm, {proper, tangent, rim, start, end, within});
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_cones) {
  hold(cone, 20'000, by_sturm, {proper, tangent, rim, apex, start, end, within});
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_closed_cylinders) {
  hold(capped_cylinder, 8'000, by_sturm, {proper, tangent, rim, start, end, within});
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_closed_cones) {
  hold(capped_cone, 8'000, by_sturm, {proper, tangent, rim, apex, start, end, within});
}

}  // namespace
}  // namespace rayaudit::second
