#include "scenes/scene_transform.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace rayaudit;

namespace {

Vec3<double> moved(const Transform& transform, const Vec3<double>& point) {
  return nearest_doubles(transform.to.point(in<Wide>(point)));
}

void require_equal(const Vec3<double>& a, const Vec3<double>& b) {
  BOOST_TEST(a.x == b.x);
  BOOST_TEST(a.y == b.y);
  BOOST_TEST(a.z == b.z);
}

bool tells(const Error& fault, std::string_view words) {
  BOOST_TEST_MESSAGE(fault.what());
  return std::string_view(fault.what()).find(words) != std::string_view::npos;
}

const Shape unit_sphere = Sphere<double>{{0, 0, 0}, 1};
const Shape unit_disk = Disk<double>{{0, 0, 1}, {0, 0, 1}, 2};
const Shape unit_cylinder = Cylinder<double>{{0, 0, 0}, {0, 0, 1}, 1};
const Shape unit_cone = Cone<double>{{0, 0, 0}, {0, 0, 1}, 1};

template <class Make>
void require_refused(const Make& make, std::string_view words) {
  BOOST_CHECK_EXCEPTION(make(), Error, [&](const Error& fault) { return tells(fault, words); });
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_inner_transform_comes_first) {
  const Transform outer = translate({1, 2, 3}), inner = scale({2, 3, 4});
  require_equal(moved(outer.after(inner), {1, 1, 1}), {3, 5, 7});
  require_equal(moved(inner.after(outer), {1, 1, 1}), {4, 9, 16});
}

BOOST_AUTO_TEST_CASE(quarter_turns_are_exact) {
  // As in pbrt: x goes to y, y to z, z to x.
  require_equal(moved(rotate(90, {0, 0, 1}), {1, 2, 3}), {-2, 1, 3});
  require_equal(moved(rotate(90, {5, 0, 0}), {1, 2, 3}), {1, -3, 2});
  require_equal(moved(rotate(90, {0, 1, 0}), {1, 2, 3}), {3, 2, -1});
  require_equal(moved(rotate(180, {0, 0, 1}), {1, 2, 3}), {-1, -2, 3});
  require_equal(moved(rotate(-90, {0, 0, 1}), {1, 2, 3}), {2, -1, 3});
  require_equal(moved(rotate(720, {0, 0, 1}), {1, 2, 3}), {1, 2, 3});
  require_equal(moved(rotate(450, {0, 0, 1}), {1, 2, 3}), {-2, 1, 3});
}

BOOST_AUTO_TEST_CASE(a_third_of_a_turn_about_the_diagonal_swaps_the_axes) {
  const Vec3<double> p = moved(rotate(120, {1, 1, 1}), {1, 2, 3});
  BOOST_TEST(std::abs(p.x - 3) < 1e-15);
  BOOST_TEST(std::abs(p.y - 1) < 1e-15);
  BOOST_TEST(std::abs(p.z - 2) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_matrix_stands_column_after_column) {
  const double columns[] = {0, 1, 0, 0, -2, 0, 0, 0, 0, 0, 3, 0, 5, 6, 7, 1};
  const Transform turned = matrix(columns);
  require_equal(moved(turned, {1, 1, 1}), {3, 7, 10});
  require_equal(nearest_doubles(turned.from.point({3, 7, 10})), {1, 1, 1});
}

BOOST_AUTO_TEST_CASE(every_inverse_takes_back) {
  const double columns[] = {1, 2, 3, 0, 0, 1, 4, 0, 5, 6, 1, 0, -7, 8, 9, 1};
  const Transform transforms[] = {translate({1, 2, 3}), scale({2, -3, .5}), rotate(37, {1, 2, 3}),
                                  look_at({1, 2, 3}, {4, 4, 4}, {0, 0, 1}), matrix(columns)};
  Transform all;
  for (const Transform& transform : transforms) all = all.after(transform);
  const Vec3<Wide> back = all.from.point(all.to.point({1, 2, 3}));
  BOOST_TEST(std::abs(static_cast<double>(back.x - 1)) < 1e-15);
  BOOST_TEST(std::abs(static_cast<double>(back.y - 2)) < 1e-15);
  BOOST_TEST(std::abs(static_cast<double>(back.z - 3)) < 1e-15);
}

BOOST_AUTO_TEST_CASE(a_camera_looks_along_z_with_x_to_the_right) {
  // From (7, 0, 0) back to the origin with z up: -y is at the right, for pbrt is left-handed (who
  // looks along z with y up has x at the right there, and turning keeps the order of the three).
  const Transform view = look_at({7, 0, 0}, {0, 0, 0}, {0, 0, 5});
  require_equal(nearest_doubles(view.from.z), {-1, 0, 0});
  require_equal(nearest_doubles(view.from.y), {0, 0, 1});
  require_equal(nearest_doubles(view.from.x), {0, -1, 0});
  require_equal(moved(view, {4, 1, 2}), {-1, 2, 3});
}

BOOST_AUTO_TEST_CASE(transforms_without_an_inverse_are_refused) {
  require_refused([&] { scale({1, 0, 1}); }, "singular");
  require_refused([&] { rotate(3, {0, 0, 0}); }, "length 0");
  require_refused([&] { look_at({1, 1, 1}, {1, 1, 1}, {0, 0, 1}); }, "the same point");
  require_refused([&] { look_at({0, 0, 0}, {0, 0, 2}, {0, 0, -1}); }, "along the direction");
  require_refused([&] { look_at({0, 0, 0}, {0, 0, 2}, {0, 0, 0}); }, "length 0");
  const double flat[] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 0, 0, 0, 1};
  require_refused([&] { matrix(flat); }, "singular");
  const double empty[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1};
  require_refused([&] { matrix(empty); }, "singular");
  const double projective[] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0};
  require_refused([&] { matrix(projective); }, "last row");
  require_refused([&] { scale({1e300, 1, 1}).after(scale({1e300, 1, 1})); }, "overflows");
  require_refused([&] { scale({1e-300, 1, 1}).after(scale({1e-300, 1, 1})); }, "overflows");
}

BOOST_AUTO_TEST_CASE(similar_spheres_are_spheres) {
  const Transform similar =
      translate({1, 2, 3}).after(rotate(30, {1, 2, 3})).after(scale({2, -2, 2}));
  const auto sphere = std::get<Sphere<double>>(image(unit_sphere, similar.to));
  require_equal(sphere.centre, {1, 2, 3});
  BOOST_TEST(sphere.radius == 2);
}

BOOST_AUTO_TEST_CASE(stretched_and_sheared_spheres_are_refused) {
  require_refused([&] { image(unit_sphere, scale({1, 1, 2}).to); }, "stretched");
  require_refused([&] { image(unit_sphere, scale({1, 2, 1}).to); }, "ellipses");
  const double sheared[] = {1, 0, 0, 0, 0, 1, 0, 0, .6, 0, .8, 0, 0, 0, 0, 1};
  require_refused([&] { image(unit_sphere, matrix(sheared).to); }, "shears");
}

BOOST_AUTO_TEST_CASE(six_typed_digits_make_a_similarity_and_a_ten_thousandth_more_does_not) {
  const double typed[] = {.36, .48, -.8, 0, -.8, .6, 0, 0, .479999, .640001, .6, 0, 0, 0, 0, 1};
  BOOST_CHECK_NO_THROW(image(unit_sphere, matrix(typed).to));
  require_refused([&] { image(unit_sphere, scale({1, 1, 1.0001}).to); }, "stretched");
}

BOOST_AUTO_TEST_CASE(disks_may_be_squeezed_along_their_axis) {
  const auto disk =
      std::get<Disk<double>>(image(unit_disk, rotate(90, {1, 0, 0}).after(scale({3, 3, 5})).to));
  require_equal(disk.centre, {0, -5, 0});
  require_equal(disk.normal, {0, -1, 0});
  BOOST_TEST(disk.radius == 6);
  require_refused([&] { image(unit_disk, scale({1, 2, 1}).to); }, "ellipses");
}

BOOST_AUTO_TEST_CASE(the_normal_of_a_mirrored_disk_goes_where_z_goes) {
  const auto disk = std::get<Disk<double>>(image(unit_disk, scale({1, 1, -1}).to));
  require_equal(disk.centre, {0, 0, -1});
  require_equal(disk.normal, {0, 0, -1});
}

BOOST_AUTO_TEST_CASE(a_sheared_disk_keeps_its_plane) {
  const double sheared[] = {1, 0, 0, 0, 0, 1, 0, 0, 4, 0, 2, 0, 0, 0, 0, 1};
  const auto disk = std::get<Disk<double>>(image(unit_disk, matrix(sheared).to));
  require_equal(disk.centre, {4, 0, 2});
  require_equal(disk.normal, {0, 0, 1});
  require_refused([&] { image(unit_cylinder, matrix(sheared).to); }, "leans");
  require_refused([&] { image(unit_cone, matrix(sheared).to); }, "leans");
}

BOOST_AUTO_TEST_CASE(cylinders_and_cones_may_be_stretched_along_their_axes) {
  const Affine stretched =
      translate({1, 2, 3}).after(rotate(90, {0, 1, 0})).after(scale({2, 2, 7})).to;
  const auto cylinder = std::get<Cylinder<double>>(image(unit_cylinder, stretched));
  require_equal(cylinder.base, {1, 2, 3});
  require_equal(cylinder.top, {8, 2, 3});
  BOOST_TEST(cylinder.radius == 2);
  const auto cone = std::get<Cone<double>>(image(unit_cone, stretched));
  require_equal(cone.base, {1, 2, 3});
  require_equal(cone.apex, {8, 2, 3});
  BOOST_TEST(cone.radius == 2);
}

BOOST_AUTO_TEST_CASE(images_without_finite_doubles_are_refused) {
  require_refused(
      [&] {
        image(Sphere<double>{{0, 0, 0}, 1e300}, scale({1e300, 1e300, 1e300}).to);
      },
      "overflows");
  require_refused(
      [&] {
        image(Sphere<double>{{0, 0, 0}, 1e-300}, scale({1e-300, 1e-300, 1e-300}).to);
      },
      "is 0");
  require_refused([&] { image(unit_cylinder, translate({0, 0, 1e300}).to); }, "one point");
}
