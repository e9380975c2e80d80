#include "scenes/bounding_tree.hpp"

#include <boost/test/unit_test.hpp>
#include <random>
#include <set>

#include "geometry/case_line.hpp"
#include "oracle/truth.hpp"

using namespace rayaudit;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// What is drawn depends on the seed alone, and in the same way with every library.
class Drawn {
 public:
  explicit Drawn(unsigned seed) : bits_(seed) {}
  double between(double least, double most) {
    return least + (most - least) * (static_cast<double>(bits_() >> 11) * 0x1p-53);
  }
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(bits_() % end); }
  Vec3<double> vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }
  /// Now and then along an axis or in a plane of two.
  Vec3<double> direction() {
    Vec3<double> d = vector(1);
    if (below(3) == 0) d.x = below(2) == 0 ? 0.0 : -0.0;
    if (below(3) == 0) d.y = 0;
    if (below(3) == 0 && (d.x != 0 || d.y != 0)) d.z = 0;
    return d;
  }

 private:
  std::mt19937_64 bits_;
};

Shape shape(Drawn& drawn, double size) {
  const Vec3<double> place = drawn.vector(10), way = size * drawn.direction();
  const double radius = size * drawn.between(0.1, 1);
  switch (drawn.below(4)) {
    case 0:
      return Disk<double>{place, way, radius};
    case 1:
      return Sphere<double>{place, radius};
    case 2:
      return Cylinder<double>{place, place + way, radius};
    default:
      return Cone<double>{place, place + way, radius};
  }
}

void scale(Case& question, double factor) {
  each_number(question, [&](double& number) { number *= factor; });
}

std::vector<std::uint32_t> candidates(const BoundingTree& tree, const Ray<double>& ray) {
  std::vector<std::uint32_t> found;
  tree.each_candidate(ray, [&](std::uint32_t i) { found.push_back(i); });
  return found;
}

/// Is the shape a candidate, or does the exact ray not even touch it?
void check(const Ray<double>& ray, const Shape& shape) {
  const Case question = {ray, shape};
  if (candidates(BoundingTree({shape}), ray).empty())
    BOOST_TEST(oracle::truth(question).count == 0, case_line(question));
}

/// A point of the shape's rim or side as doubles are: where boxes are tight.
Vec3<double> on(Drawn& drawn, const Shape& any) {
  const Box box = box_of(any);
  const auto pick = [&](double low, double high) {
    switch (drawn.below(4)) {
      case 0:
        return std::nextafter(low, high);
      case 1:
        return std::nextafter(high, low);
      case 2:
        return low;
      default:
        return drawn.between(low, high);
    }
  };
  const double x = pick(box.least.x, box.most.x), y = pick(box.least.y, box.most.y);
  return {x, y, pick(box.least.z, box.most.z)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(nothing_is_a_candidate_among_no_shapes) {
  BOOST_TEST(candidates(BoundingTree({}), {{0, 0, 0}, {1, 0, 0}}).empty());
}

BOOST_AUTO_TEST_CASE(a_box_is_that_of_the_shape_but_for_a_last_place) {
  const auto is_near = [](const Box& box, const Vec3<double>& least, const Vec3<double>& most) {
    const Vec3<double> below = least - box.least, above = box.most - most;
    for (const double over : {below.x, below.y, below.z, above.x, above.y, above.z})
      if (!(over > 0 && over < 1e-13)) return false;
    return true;
  };
  BOOST_TEST(is_near(box_of(Sphere<double>{{1, 2, 3}, 2}), {-1, 0, 1}, {3, 4, 5}));
  BOOST_TEST(is_near(box_of(Disk<double>{{1, 2, 3}, {0, 5, 0}, 2}), {-1, 2, 1}, {3, 2, 5}));
  BOOST_TEST(
      is_near(box_of(Disk<double>{{0, 0, 0}, {3e200, 0, -4e200}, 5}), {-4, -5, -3}, {4, 5, 3}));
  BOOST_TEST(is_near(box_of(Cylinder<double>{{0, 0, 0}, {4, 3, 0}, 5}), {-3, -4, -5}, {7, 7, 5}));
  BOOST_TEST(is_near(box_of(Cone<double>{{0, 0, 0}, {4, 3, 0}, 5}), {-3, -4, -5}, {4, 4, 5}));
}

BOOST_AUTO_TEST_CASE(a_box_is_infinite_where_numbers_are) {
  const Box box = box_of(Sphere<double>{{std::nan(""), 0, 1e307}, 1});
  BOOST_TEST(box.least.x == -infinity);
  BOOST_TEST(box.most.x == infinity);
  BOOST_TEST(box.most.y < 2);
  BOOST_TEST(box.most.z == infinity);
  const Box endless = box_of(Disk<double>{{0, 0, 0}, {1, 1, infinity}, infinity});
  BOOST_TEST(endless.least.x == -infinity);
  BOOST_TEST(endless.most.z == infinity);
}

BOOST_AUTO_TEST_CASE(no_shape_that_a_drawn_ray_meets_is_culled_and_most_others_are) {
  Drawn drawn(1);
  std::vector<Shape> shapes;
  for (int i = 0; i < 200; ++i) shapes.push_back(shape(drawn, 3));
  const BoundingTree tree(shapes);
  std::size_t asked = 0, met = 0;
  for (int i = 0; i < 600; ++i) {
    const Ray<double> ray = {drawn.vector(12), drawn.direction(), 0,
                             drawn.below(2) == 0 ? infinity : drawn.between(0, 20)};
    const std::vector<std::uint32_t> found = candidates(tree, ray);
    const std::set<std::uint32_t> kept(found.begin(), found.end());
    BOOST_TEST(kept.size() == found.size(), "each once");
    asked += kept.size();
    for (std::uint32_t j = 0; j < shapes.size(); ++j) {
      const Case question = {ray, shapes[j]};
      const bool meets = oracle::truth(question).count > 0;
      met += meets;
      if (!kept.count(j)) BOOST_TEST(!meets, case_line(question));
    }
  }
  BOOST_TEST(met > 300U);
  BOOST_TEST(asked < 5 * met);
}

BOOST_AUTO_TEST_CASE(a_ray_aimed_at_the_very_edge_of_a_box_is_kept_where_it_meets) {
  Drawn drawn(2);
  for (int i = 0; i < 20'000; ++i) {
    Case question = {{drawn.vector(20), {0, 0, 0}}, shape(drawn, 1)};
    question.ray.direction = on(drawn, question.shape) - question.ray.origin;
    if (drawn.below(3) == 0) question.ray.direction.x = 0;
    if (drawn.below(3) == 0) question.ray.t_max = 1;
    check(question.ray, question.shape);
  }
}

BOOST_AUTO_TEST_CASE(no_size_and_no_speed_has_what_it_meets_culled) {
  Drawn drawn(3);
  for (const double size :
       {0x1p-1060, 0x1p-530, 0x1p-300, 0x1p-60, 0x1p60, 0x1p300, 0x1p700, 0x1p1018})
    for (const double speed : {0x1p-1060, 0x1p-600, 1.0, 0x1p600, 0x1p1018})
      for (int i = 0; i < 200; ++i) {
        Case question = {{drawn.vector(12), {0, 0, 0}}, shape(drawn, 1)};
        Vec3<double> d = on(drawn, question.shape) - question.ray.origin;
        scale(question, size);
        question.ray.direction = speed / 32 * d;
        check(question.ray, question.shape);
      }
}

BOOST_AUTO_TEST_CASE(far_from_the_origin_nothing_met_is_culled) {
  Drawn drawn(4);
  for (const double far : {1e3, 1e8, 1e15, 1e16, 1e17})
    for (int i = 0; i < 1000; ++i) {
      const Vec3<double> there = {far, -far / 3, far / 7};
      Case question = {{drawn.vector(20), {0, 0, 0}}, shape(drawn, 1)};
      std::visit(
          [&](auto& any) {
            if constexpr (requires { any.centre; }) any.centre = any.centre + there;
            if constexpr (requires { any.base; }) any.base = any.base + there;
            if constexpr (requires { any.top; }) any.top = any.top + there;
            if constexpr (requires { any.apex; }) any.apex = any.apex + there;
          },
          question.shape);
      if (drawn.below(2) == 0) question.ray.origin = question.ray.origin + there;
      question.ray.direction = on(drawn, question.shape) - question.ray.origin;
      check(question.ray, question.shape);
    }
}

BOOST_AUTO_TEST_CASE(rays_in_the_faces_of_boxes_are_kept) {
  const Sphere<double> ball = {{0, 0, 0}, 1};
  const Disk<double> floor_disk = {{0, 0, 0}, {0, 1, 0}, 1};
  for (const auto& [origin, direction] :
       std::vector<std::pair<Vec3<double>, Vec3<double>>>{{{-3, 1, 0}, {1, 0, 0}},
                                                          {{-3, 1, 0}, {1, -0.0, 0}},
                                                          {{1, -1, 0}, {0, 1, 0}},
                                                          {{-2, 0, 0}, {1, 0, 0}},
                                                          {{0, 0, -5}, {0, 0, 0x1p-1074}}}) {
    BOOST_TEST(candidates(BoundingTree({ball}), {origin, direction}).size() == 1U);
    if (origin.y == 0)
      BOOST_TEST(candidates(BoundingTree({floor_disk}), {origin, direction}).size() == 1U);
  }
}

BOOST_AUTO_TEST_CASE(a_range_that_ends_on_a_box_keeps_it_and_one_before_does_not) {
  const BoundingTree tree({Sphere<double>{{0, 0, 0}, 1}});
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, 0, 0}, 0, 2}).size() == 1U);
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, 0, 0}, 4, 9}).size() == 1U);
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, 0, 0}, 0, 1.999}).empty());
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, 0, 0}, 4.001, 9}).empty());
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {-1, 0, 0}}).empty());
  BOOST_TEST(candidates(tree, {{-3, 2, 0}, {1, 0, 0}}).empty());
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_keep_what_they_may_meet) {
  const BoundingTree tree({Sphere<double>{{0, 0, 0}, 1}});
  const double nan = std::nan("");
  for (const double odd : {nan, infinity, -infinity, 1.7e308}) {
    BOOST_TEST(candidates(tree, {{odd, 0, 0}, {-1, 0, 0}}).size() == 1U);
    BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, odd, 0}}).size() == 1U);
  }
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, 0, 0}, nan, nan}).size() == 1U);
  BOOST_TEST(candidates(tree, {{-3, 0, 0}, {1, 0, 0}, -infinity, infinity}).size() == 1U);
  const BoundingTree endless({Sphere<double>{{nan, 0, 0}, 1}, Sphere<double>{{0, 0, 0}, infinity}});
  BOOST_TEST(candidates(endless, {{-3, 0, 0}, {1, 0, 0}}).size() == 2U);
}

BOOST_AUTO_TEST_CASE(many_shapes_in_one_place_are_all_found) {
  const std::vector<Shape> same(1000, Sphere<double>{{0, 0, 0}, 1});
  const std::vector<std::uint32_t> found = candidates(BoundingTree(same), {{-3, 0, 0}, {1, 0, 0}});
  BOOST_TEST((std::set<std::uint32_t>(found.begin(), found.end()).size() == 1000U));
}
