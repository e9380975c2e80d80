#include "tests/oracle/second_derivation/by_algebraic.hpp"
#include "tests/oracle/second_derivation/held.hpp"
#include "tests/oracle/second_derivation/proved.hpp"

namespace rayaudit::second {
namespace {

using enum oracle::Kind;

constexpr std::size_t cylinder = 2, cone = 3;

BOOST_AUTO_TEST_CASE(proved_cases_are_derived_right) {
  hold_proved(cylinder, by_algebraic);
  hold_proved(cone, by_algebraic);
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_cylinders) {
  hold(cylinder, 20'000, by_algebraic, {proper, tangent, rim, start, end, within});
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_cones) {
  hold(cone, 20'000, by_algebraic, {proper, tangent, rim, apex, start, end, within});
}

/// |v x w| = r |w| on the cylinder, |v x w| |w| = r |h| on the cone and its mirrored nappe, with
/// roots and all.
bool fulfils_definition(const Placed& shape, const Algebraic& t) {
  const Vec3<Algebraic> across = cross(shape.line.v(t), shape.line.w);
  const Algebraic reach = sqrt(dot(across, across));
  const Algebraic length = sqrt(dot(shape.line.w, shape.line.w));
  if (!shape.cone) return reach == shape.r * length;
  return reach * length == shape.r * abs(shape.h(t));
}

BOOST_AUTO_TEST_CASE(the_roots_fulfil_the_definition_unsquared) {
  for (const std::size_t shape : {cylinder, cone})
    for (const std::string_view id : {"anywhere", "tangent", "rim", "lattice"})
      for (const Case& question : drawn(family_of(id), shape, float_format, {}, 0, 10))
        for (const Algebraic& t : real_roots(placed(question).squared()))
          BOOST_TEST(fulfils_definition(placed(question), t), case_line(question));
}

}  // namespace
}  // namespace rayaudit::second
