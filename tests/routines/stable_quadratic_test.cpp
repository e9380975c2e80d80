#include "routines/stable_quadratic.hpp"

#include <boost/test/unit_test.hpp>

#include "known.hpp"

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_hits_from_outside) { known::answers<StableQuadratic>(known::from_outside); }
BOOST_AUTO_TEST_CASE(it_misses_what_it_passes_by) {
  known::answers<StableQuadratic>(known::passing_by);
}
BOOST_AUTO_TEST_CASE(it_hits_from_inside) { known::answers<StableQuadratic>(known::from_inside); }
BOOST_AUTO_TEST_CASE(what_lies_behind_is_a_miss) { known::answers<StableQuadratic>(known::behind); }
BOOST_AUTO_TEST_CASE(a_clipped_crossing_is_passed_over) {
  known::answers<StableQuadratic>(known::clipped);
}
BOOST_AUTO_TEST_CASE(parallel_rays_are_told_apart) {
  known::answers<StableQuadratic>(known::parallel);
}
BOOST_AUTO_TEST_CASE(the_mirrored_nappe_does_not_count) {
  known::answers<StableQuadratic>(known::one_nappe);
}
BOOST_AUTO_TEST_CASE(a_ray_through_the_apex_from_inside_hits) {
  known::answers<StableQuadratic>(known::through_the_apex);
}
BOOST_AUTO_TEST_CASE(the_range_is_open_at_both_ends) {
  known::answers<StableQuadratic>(known::in_a_range);
}
BOOST_AUTO_TEST_CASE(an_edge_lets_no_ray_through) { known::answers<StableQuadratic>(known::edges); }
BOOST_AUTO_TEST_CASE(it_answers_in_general_position) {
  known::answers_in_general_position<StableQuadratic>();
}

BOOST_AUTO_TEST_CASE(a_small_root_keeps_its_digits) {
  const Ray<float> ray = {{-1 - 0x1p-20f, 0.5f, 0}, {1, 0, 0}};
  const float close = 0x1p-20f;
  for (const std::optional<float> t :
       {StableQuadratic()(Ray<float>{{-1 - close, 0, 0}, {1, 0, 0}}, Sphere<float>{{0, 0, 0}, 1}),
        StableQuadratic()(ray, Cylinder<float>{{0, 0, 0}, {0, 1, 0}, 1}),
        StableQuadratic()(ray, Cone<float>{{0, 0, 0}, {0, 1, 0}, 2})}) {
    BOOST_TEST_REQUIRE(t.has_value());
    BOOST_TEST(std::abs(*t - close) < 0x1p-10f * close, "t " << *t);
  }
}

BOOST_AUTO_TEST_CASE(a_long_thin_cylinder_keeps_its_digits) {
  const Cylinder<float> thin = {{0, 0, 0}, {2e6f, 1e6f, -2e6f}, 3};
  const Ray<float> ray = {{1997, 994, -2006}, {1, 2, 2}};
  const std::optional<float> t = StableQuadratic()(ray, thin);
  BOOST_TEST_REQUIRE(t.has_value());
  BOOST_TEST(std::abs(*t - 2) < 0x1p-10f, "t " << *t);
}
