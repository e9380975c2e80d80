#include "scenes/scene.hpp"

#include <boost/test/unit_test.hpp>
#include <chrono>

#include "scenes/read_scene.hpp"

using namespace rayaudit;

namespace {

Primitive of(const Shape& shape) { return {shape, {}, {}, {"by_hand.pbrt", 3, 4}}; }

std::size_t seam_count(const Shape& disk, const Shape& wall) {
  return seams({of(disk), of(wall)}).size();
}

const Shape can = Cylinder<double>{{1, 2, 3}, {1, 2, 7}, .5};
const Shape hat = Cone<double>{{1, 2, 3}, {1, 2, 7}, .5};

}  // namespace

BOOST_AUTO_TEST_CASE(a_disk_on_an_end_of_a_cylinder_is_a_seam) {
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 3}, {0, 0, 1}, .5}, can) == 1);
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 7}, {0, 0, -3}, .5}, can) == 1);
  BOOST_TEST(seam_count(Disk<double>{{1, 2 + 0x1p-18, 7}, {0, 0x1p-18, 1}, .5}, can) == 1);
  const std::vector<Seam> found =
      seams({of(can), of(hat), of(Disk<double>{{1, 2, 7}, {0, 0, 1}, .5})});
  BOOST_TEST_REQUIRE(found.size() == 1);
  BOOST_TEST(found[0].disk == 2);
  BOOST_TEST(found[0].wall == 0);
}

BOOST_AUTO_TEST_CASE(a_disk_elsewhere_is_none) {
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 5}, {0, 0, 1}, .5}, can) == 0);
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 3 + 0x1p-16}, {0, 0, 1}, .5}, can) == 0);
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 3}, {0, 0x1p-15, 1}, .5}, can) == 0);
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 3}, {0, 0, 1}, .5 + 0x1p-16}, can) == 0);
}

BOOST_AUTO_TEST_CASE(a_cone_has_a_seam_at_its_base_and_none_at_its_apex) {
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 3}, {0, 0, 1}, .5}, hat) == 1);
  BOOST_TEST(seam_count(Disk<double>{{1, 2, 7}, {0, 0, 1}, .5}, hat) == 0);
}

BOOST_AUTO_TEST_CASE(seams_are_found_at_and_about_powers_of_two_and_the_edges_of_cells) {
  for (const double r : {1.0, 1 - 0x1p-30, 1 + 0x1p-30, 2.0, 3.0})
    for (const double x : {0.0, 1.0, -1.0, 0x1p-13, 3 * 0x1p-12, 12345.0})
      for (const double off : {0.0, 0x1p-17, -0x1p-17}) {
        const Shape wall = Cylinder<double>{{x, -x, x}, {x, -x, x + 2}, r};
        BOOST_TEST(
            seam_count(Disk<double>{{x + off, -x + off, x - off}, {0, 0, 1}, r + off}, wall) == 1);
      }
}

BOOST_AUTO_TEST_CASE(many_disks_in_one_place_take_no_time) {
  std::vector<Primitive> primitives;
  for (int i = 0; i < 50'000; ++i) {
    primitives.push_back(of(Disk<double>{{1, 2, 3}, {1, 0, 0}, .5}));
    primitives.push_back(of(can));
  }
  const auto begin = std::chrono::steady_clock::now();
  BOOST_TEST(seams(primitives).empty());
  BOOST_TEST((std::chrono::steady_clock::now() - begin < std::chrono::seconds(5)));
}

BOOST_AUTO_TEST_CASE(rounding_to_float_is_told_by_the_number_that_it_moved_most) {
  Scene scene;
  scene.primitives = {of(Sphere<double>{{1, 2, 3}, 4}), of(Sphere<double>{{100, 0.1, 3}, 4}),
                      of(Sphere<double>{{1, 2, 3}, 0.1}), of(Sphere<double>{{1, 2, 0.1}, 3})};
  const Rounded in_float = rounded(scene, float_format);
  const double tenth = static_cast<double>(0.1F);
  BOOST_TEST(std::get<Sphere<double>>(in_float.scene.primitives[2].shape).radius == tenth);
  BOOST_TEST(in_float.primitive == 2);
  BOOST_TEST(in_float.most_moved == (tenth - 0.1) / 0.1);

  const Rounded in_double = rounded(scene, double_format);
  BOOST_TEST(std::get<Sphere<double>>(in_double.scene.primitives[2].shape).radius == 0.1);
  BOOST_TEST(in_double.most_moved == 0);
}

BOOST_AUTO_TEST_CASE(what_rounding_leaves_no_shape_of_is_refused_where_it_stands) {
  const Shape gone[] = {Sphere<double>{{0, 0, 0}, 1e-60}, Sphere<double>{{0, 0, 0}, 1e60},
                        Sphere<double>{{0, 1e60, 0}, 1},
                        Cylinder<double>{{0, 0, 1e9}, {0, 0, 1e9 + 1}, 1}};
  for (const Shape& shape : gone) {
    Scene scene;
    scene.primitives = {of(shape)};
    BOOST_CHECK_NO_THROW(rounded(scene, double_format));
    const auto stands_there = [](const SceneError& fault) {
      BOOST_TEST_MESSAGE(fault.what());
      return fault.place == Place{"by_hand.pbrt", 3, 4};
    };
    BOOST_CHECK_EXCEPTION(rounded(scene, float_format), SceneError, stands_there);
  }
}
