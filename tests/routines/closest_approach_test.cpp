#include "routines/closest_approach.hpp"

#include <array>
#include <boost/test/unit_test.hpp>

#include "known.hpp"

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_hits_from_outside) { known::answers<ClosestApproach>(known::from_outside); }
BOOST_AUTO_TEST_CASE(it_misses_what_it_passes_by) {
  known::answers<ClosestApproach>(known::passing_by);
}
BOOST_AUTO_TEST_CASE(it_hits_from_inside) { known::answers<ClosestApproach>(known::from_inside); }
BOOST_AUTO_TEST_CASE(what_lies_behind_is_a_miss) { known::answers<ClosestApproach>(known::behind); }
BOOST_AUTO_TEST_CASE(a_clipped_crossing_is_passed_over) {
  known::answers<ClosestApproach>(known::clipped);
}
BOOST_AUTO_TEST_CASE(parallel_rays_are_told_apart) {
  known::answers<ClosestApproach>(known::parallel);
}
BOOST_AUTO_TEST_CASE(the_mirrored_nappe_does_not_count) {
  known::answers<ClosestApproach>(known::one_nappe);
}
BOOST_AUTO_TEST_CASE(a_ray_through_the_apex_from_inside_hits) {
  known::answers<ClosestApproach>(known::through_the_apex);
}
BOOST_AUTO_TEST_CASE(the_range_is_open_at_both_ends) {
  known::answers<ClosestApproach>(known::in_a_range);
}
BOOST_AUTO_TEST_CASE(an_edge_lets_no_ray_through) { known::answers<ClosestApproach>(known::edges); }
BOOST_AUTO_TEST_CASE(it_answers_in_general_position) {
  known::answers_in_general_position<ClosestApproach>();
}

namespace {

/// The three shapes at a distance of 2^20 from a ray along x that is off their axis by z.
std::array<std::optional<float>, 3> from_afar(float z) {
  const Ray<float> ray = {{-0x1p20f, 1, z}, {0.5f, 0, 0}};
  return {ClosestApproach()(ray, Sphere<float>{{0, 1, 0}, 1}),
          ClosestApproach()(ray, Cylinder<float>{{0, 0, 0}, {0, 2, 0}, 1}),
          ClosestApproach()(ray, Cone<float>{{0, 0, 0}, {0, 2, 0}, 2})};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_radius_is_not_lost_at_a_distance) {
  for (const std::optional<float> t : from_afar(1 - 0x1p-10f)) {
    BOOST_TEST_REQUIRE(t.has_value());
    BOOST_TEST(std::abs(*t - 0x1p21f) < 0.5f, "t " << *t);
  }
  for (const std::optional<float> t : from_afar(1 + 0x1p-10f)) BOOST_TEST(!t.has_value());
}

BOOST_AUTO_TEST_CASE(a_cone_far_off_is_met_within_a_few_ulps) {
  // Coordinates in the frame (1,2,2), (2,1,-2), (2,-2,1), where the cone is 3 times the unit one.
  const auto turned = [](float x, float y, float z) {
    return Vec3<float>{x + 2 * y + 2 * z, 2 * x + y - 2 * z, 2 * x - 2 * y + z};
  };
  const Cone<float> cone = {{0, 0, 0}, turned(0, 1, 0), 3};
  const float far = 65537;
  for (int x = 1; x <= 4; ++x)
    for (int y = -x; y < x; ++y)
      for (int z = -1; z <= 1; ++z) {
        const Vec3<float> d = turned(float(x), float(y), float(z));
        const Ray<float> ray = {turned(-0.5f, 0.5f, 0) - far * d, d};
        const std::optional<float> t = ClosestApproach()(ray, cone);
        BOOST_TEST_CONTEXT("d " << d.x << ' ' << d.y << ' ' << d.z) {
          BOOST_TEST_REQUIRE(t.has_value());
          BOOST_TEST(std::abs(*t - far) <= 4 * 0x1p-7f, "t " << *t);
        }
      }
}

BOOST_AUTO_TEST_CASE(no_size_and_no_direction_is_too_large_or_too_small) {
  known::answers_at_every_scale<ClosestApproach>();
}

BOOST_AUTO_TEST_CASE(no_shape_is_too_long_or_too_flat) {
  known::answers<ClosestApproach>({
      "cylinder 0 0 0 0 0x1p80 0 1 ray -3 0.5 0 1 0 0 hit 2",
      "cylinder 0 0 0 0 0x1p-80 0 1 ray -3 0x1p-81 0 1 0 0 hit 2",
      "cone 0 0 0 0 0x1p50 0 1 ray -3 0x1p49 0 1 0 0 hit 2.5",
      "cone 0 0 0 0 0x1p-50 0 1 ray -3 0x1p-51 0 1 0 0 hit 2.5",
  });
}

BOOST_AUTO_TEST_CASE(a_ray_through_the_apex_keeps_all_its_digits) {
  // 3, 6, 6 is 9 long, the half-angle atan(5/9): every d runs inside the cone from the apex on.
  const Vec3<float> apex = {3.140625f, 6.28125f, 5.703125f};
  const Cone<float> cone = {apex - Vec3<float>{3, 6, 6}, apex, 5};
  for (float x = 36; x <= 48; x += 3)
    for (float y = 73; y <= 83; y += 5)
      for (float z = 71; z <= 81; z += 5)
        for (const float t : {1.0f, 3.0f, 1000.0f}) {
          const Vec3<float> d = Vec3<float>{-x, -y, -z} / 64.0f;
          const std::optional<float> said = ClosestApproach()(Ray<float>{apex - t * d, d}, cone);
          BOOST_TEST_CONTEXT("d " << -x << ' ' << -y << ' ' << -z << " / 64, t " << t) {
            BOOST_TEST_REQUIRE(said.has_value());
            BOOST_TEST(std::abs(*said - t) <= 0x1p-20f * t, "said " << *said);
          }
        }
}

BOOST_AUTO_TEST_CASE(invalid_cases_end) {
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float bad : {0.0f, -1.0f, inf, nan}) {
    const Ray<float> ray = {{-3, 0.5f, 0}, {bad, 0, 0}};
    ClosestApproach()(ray, Sphere<float>{{0, 0, 0}, bad});
    ClosestApproach()(ray, Cylinder<float>{{0, 0, 0}, {0, bad, 0}, bad});
    ClosestApproach()(ray, Cone<float>{{0, 0, 0}, {0, bad, 0}, bad});
  }
}
