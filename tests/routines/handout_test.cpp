#include "routines/handout.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string_view>
#include <variant>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

/// Does the handout say yes to a disk, or the point told to a sphere, on each case line?
template <class N>
void answers(std::string_view text) {
  const CaseLine line = read_case_line(text);
  const Ray<N> ray = in<N>(line.question.ray);
  const bool met = line.answer->form != Answer::Form::miss;
  BOOST_TEST_CONTEXT(text) {
    if (const auto* disk = std::get_if<Disk<double>>(&line.question.shape)) {
      BOOST_TEST(Handout()(ray, in<N>(*disk)) == met);
    } else {
      const auto point = Handout()(ray, in<N>(std::get<Sphere<double>>(line.question.shape)));
      BOOST_TEST(point.has_value() == met);
      if (!point || !met) return;
      BOOST_TEST(point->x == N(line.answer->point.x.high));
      BOOST_TEST(point->y == N(line.answer->point.y.high));
      BOOST_TEST(point->z == N(line.answer->point.z.high));
    }
  }
}

void answers(std::string_view text) {
  answers<float>(text);
  answers<double>(text);
  answers<long double>(text);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_disk_is_met_in_front_and_within_its_radius) {
  answers("disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 -1 0 yes");
  answers("disk 1 2 3 0 0 4 2 ray 1 3 -1 0 0 2 yes");
  answers("disk 0 0 0 0 1 0 1 ray 1 2 0 0 -1 0 yes # the rim");
  answers("disk 0 0 0 0 1 0 1 ray 1.5 2 0 0 -1 0 miss");
  answers("disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 1 0 miss");
}

BOOST_AUTO_TEST_CASE(a_ray_parallel_to_the_disk_is_a_yes) {
  answers("disk 0 0 0 0 1 0 1 ray 0.5 -1 0 1 0 0 yes # t is infinite, the distance NaN");
  answers("disk 0 0 0 0 1 0 1 ray -9 0 0 -1 0 0 yes # t is NaN");
}

BOOST_AUTO_TEST_CASE(the_sphere_is_met_from_its_centre) {
  answers("sphere 0 0 0 1 ray 0 0 0 1 0 0 at 1 0 0");
  answers("sphere 1 2 4 2 ray 1 2 4 0 0 -4 at 1 2 2");
}

BOOST_AUTO_TEST_CASE(the_discriminant_lacks_a_factor_and_the_hit_is_lost) {
  answers("sphere 0 0 0 1 ray -3 0 0 1 0 0 miss");
}

BOOST_AUTO_TEST_CASE(where_the_discriminant_is_not_negative_the_point_is_off) {
  // From half-way out, o.d = 1/2: D = 1/4 + 3 for the true 1 + 3.
  const auto point = Handout()(Ray<double>{{0.5, 0, 0}, {1, 0, 0}}, Sphere<double>{{0, 0, 0}, 1});
  BOOST_TEST_REQUIRE(point.has_value());
  BOOST_TEST(point->x == 0.5 + (-0.5 + std::sqrt(3.25)) / 2);
}

BOOST_AUTO_TEST_CASE(of_two_points_ahead_the_nearer_is_told) {
  // Only from just outside is the printed discriminant of a hit not negative.
  const auto point =
      Handout()(Ray<double>{{-1 - 0x1p-10, 0, 0}, {1, 0, 0}}, Sphere<double>{{0, 0, 0}, 1});
  BOOST_TEST_REQUIRE(point.has_value());
  BOOST_TEST(point->x < -0.9);
}

BOOST_AUTO_TEST_CASE(a_miss_comes_back_as_the_centre) {
  answers("sphere 1 2 3 1 ray 1 9 3 1 0 0 at 1 2 3");
  answers("sphere 1 2 3 1 ray 2.0009765625 2 3 1 0 0 at 1 2 3 # both roots behind");
  answers("sphere 0 0 0 1 ray 0 9 0 1 0 0 miss");
}

BOOST_AUTO_TEST_CASE(a_hit_at_the_world_origin_is_a_miss) {
  answers("sphere 1 0 0 1 ray 1 0 0 -1 0 0 miss");
}

BOOST_AUTO_TEST_CASE(the_range_is_not_known) {
  answers("sphere 0 0 0 1 ray 0 0 0 1 0 0 range 2 3 at 1 0 0");
  answers("disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 -1 0 range 4 8 yes");
}
