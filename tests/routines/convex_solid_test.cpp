#include "routines/convex_solid.hpp"

#include <boost/test/unit_test.hpp>

#include "routines/closest_approach.hpp"
#include "routines/stable_quadratic.hpp"
#include "routines/textbook.hpp"
#include "tests/families/drawn.hpp"

using namespace rayaudit;

namespace {

using Cut = std::optional<Span<double>>;

void is_span(const Cut& span, double enter, double leave) {
  BOOST_TEST_REQUIRE(span.has_value());
  BOOST_TEST(span->enter == enter);
  BOOST_TEST(span->leave == leave);
}

Vec3<double> end_of(const CappedCylinder<double>& shape) { return shape.top; }
Vec3<double> end_of(const CappedCone<double>& shape) { return shape.apex; }

template <class S>
bool is_inside(const S& shape, const Vec3<double>& point) {
  const Vec3<double> v = point - shape.base, w = end_of(shape) - shape.base;
  const double height = dot(v, w) / dot(w, w);
  const bool narrows = std::is_same_v<S, CappedCone<double>>;
  const double radius = narrows ? shape.radius * (1 - height) : shape.radius;
  const Vec3<double> across = v - height * w;
  return 0 < height && height < 1 && dot(across, across) < radius * radius;
}

/// Of the rays that begin inside and leave exactly through an edge: how many are there, and how
/// many does the routine lose in float?
struct Leaving {
  int all = 0, lost = 0;
};

template <class Routine, class S>
Leaving through_edges(std::size_t shape) {
  Leaving counted;
  for (std::uint64_t chunk = 0; chunk < 8; ++chunk)
    for (const Case& question : drawn(family_of("rim"), shape, float_format, {}, chunk)) {
      const S& solid = std::get<S>(question.shape);
      if (!is_inside(solid, question.ray.origin)) continue;
      ++counted.all;
      counted.lost += !Routine()(in<float>(question.ray), in<float>(solid)).has_value();
    }
  BOOST_TEST(counted.all > 1500);
  return counted;
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_half_space_cuts_where_the_line_enters_or_leaves_it) {
  is_span(cut<double>({0, 8}, {4, -1}), 4, 8);
  is_span(cut<double>({0, 8}, {-6, 1}), 0, 6);
  is_span(cut<double>({0, 8}, {-4, -1}), 0, 8);
  is_span(cut<double>({0, 8}, {-16, 1}), 0, 8);
  BOOST_TEST(!cut<double>({0, 8}, {9, -1}).has_value());
  BOOST_TEST(!cut<double>({0, 8}, {1, 1}).has_value());
}

BOOST_AUTO_TEST_CASE(a_line_along_its_border_is_in_it_or_not) {
  is_span(cut<double>({0, 8}, {-1, 0}), 0, 8);
  is_span(cut<double>({0, 8}, {0, 0}), 0, 8);
  BOOST_TEST(!cut<double>({0, 8}, {1, 0}).has_value());
}

BOOST_AUTO_TEST_CASE(a_single_point_is_a_span) { is_span(cut<double>({0, 8}, {8, -1}), 8, 8); }

BOOST_AUTO_TEST_CASE(from_inside_it_is_where_the_line_leaves) {
  const Ray<double> ray = {{0, 0, 0}, {1, 0, 0}};
  BOOST_TEST((first_root(ray, Cut({-1, 2})) == 2));
  BOOST_TEST((first_root(ray, Cut({1, 2})) == 1));
  BOOST_TEST(!first_root(ray, Cut({-2, -1})).has_value());
  BOOST_TEST(!first_root(ray, Cut()).has_value());
}

BOOST_AUTO_TEST_CASE(a_point_test_at_each_rim_leaves_a_crack_and_the_ends_of_a_span_do_not) {
  using Cylinder = CappedCylinder<double>;
  using Cone = CappedCone<double>;
  BOOST_TEST((through_edges<ClosestApproach, Cylinder>(4).lost) == 0);
  BOOST_TEST((through_edges<ClosestApproach, Cone>(5).lost) == 0);
  BOOST_TEST((through_edges<StableQuadratic, Cylinder>(4).lost) == 0);
  BOOST_TEST((through_edges<Textbook, Cylinder>(4).lost) > 20);
  BOOST_TEST((through_edges<Textbook, Cone>(5).lost) > 20);
}
