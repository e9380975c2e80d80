#include "scenes/offset.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "geometry/error.hpp"

using namespace rayaudit;

namespace {

const Vec3<double> up = {0, 1, 0};

Ray<double> left_by(std::string_view offset, const Departure& departure,
                    const Vec3<double>& direction, const Format& format = float_format) {
  return departing(departure, direction, read_offset(offset), format);
}

std::string sentence(std::string_view text) {
  try {
    read_offset(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "read";
}

bool is(const Vec3<double>& a, const Vec3<double>& b) { return a == b; }

}  // namespace

BOOST_AUTO_TEST_CASE(offsets_are_read_as_they_are_asked_for) {
  BOOST_TEST((read_offset("none").kind == Offset::Kind::none));
  BOOST_TEST((read_offset("proved").kind == Offset::Kind::proved));
  const Offset t_min = read_offset("t_min=1e-3");
  BOOST_TEST((t_min.kind == Offset::Kind::t_min));
  BOOST_TEST(t_min.amount == 1e-3);
  BOOST_TEST(t_min.name == "t_min=1e-3");
  BOOST_TEST(read_offset("normal").amount == 16);
  BOOST_TEST(read_offset("normal=8").amount == 8);
  BOOST_TEST((read_offset("normal=8").kind == Offset::Kind::normal));
}

BOOST_AUTO_TEST_CASE(each_usual_offset_is_read_by_its_name) {
  BOOST_TEST(usual_offsets().size() == 5U);
  for (const Offset& offset : usual_offsets()) {
    const Offset read = read_offset(offset.name);
    BOOST_TEST((read.kind == offset.kind));
    BOOST_TEST(read.amount == offset.amount);
    BOOST_TEST(read.name == offset.name);
  }
}

BOOST_AUTO_TEST_CASE(what_is_no_offset_is_told_in_a_sentence) {
  BOOST_TEST(sentence("nothing") ==
             "the offset `nothing` is not known; there are `none`, `t_min=1e-3`, `normal=16` and "
             "`proved`");
  for (const std::string_view text :
       {"t_min=", "t_min=0", "t_min=-1", "t_min=1e-3x", "t_min=inf", "t_min=nan", "t_min=1e999"})
    BOOST_TEST(sentence(text) ==
               "the offset `" + std::string(text) + "` must have a number above 0 after its `=`");
  for (const std::string_view text : {"", "t_min", "None", "normal=", "normal=x"})
    BOOST_TEST(sentence(text) != "read");
}

BOOST_AUTO_TEST_CASE(no_offset_leaves_the_point_as_it_is) {
  const Ray<double> ray = left_by("none", {{1, 2, 3}, up, 0.5}, up);
  BOOST_TEST(is(ray.origin, {1, 2, 3}));
  BOOST_TEST(is(ray.direction, up));
  BOOST_TEST(ray.t_min == 0);
  BOOST_TEST(std::isinf(ray.t_max));
}

BOOST_AUTO_TEST_CASE(a_t_min_is_a_number_of_the_format) {
  const Departure departure = {{1, 2, 3}, up, 0.5};
  const Ray<double> in_float = left_by("t_min=1e-3", departure, up);
  BOOST_TEST(in_float.t_min == double{1e-3F});
  BOOST_TEST(is(in_float.origin, {1, 2, 3}));
  BOOST_TEST(left_by("t_min=1e-3", departure, up, double_format).t_min == 1e-3);
}

BOOST_AUTO_TEST_CASE(ulps_are_those_of_the_largest_coordinate) {
  // The spacing from 4 to 8 is 2^-21 in float, 2^-50 in double.
  const Departure departure = {{-5, 1, 0}, up, 0};
  BOOST_TEST(is(left_by("normal=16", departure, up).origin, {-5, 1 + 0x1p-17, 0}));
  BOOST_TEST(is(left_by("normal=16", departure, up, double_format).origin, {-5, 1 + 0x1p-46, 0}));
}

BOOST_AUTO_TEST_CASE(the_ray_begins_on_the_side_that_it_goes_to) {
  const Departure departure = {{-5, 1, 0}, up, 0x1p-20};
  BOOST_TEST(left_by("normal=16", departure, {1, -0.25, 0}).origin.y == 1 - 0x1p-17);
  BOOST_TEST(left_by("normal=16", {{-5, 1, 0}, -up, 0}, {1, -0.25, 0}).origin.y == 1 - 0x1p-17);
  BOOST_TEST(left_by("proved", departure, {1, -0.25, 0}).origin.y < 1 - 0x1p-20);
  BOOST_TEST(left_by("proved", departure, {1, 0.25, 0}).origin.y > 1 + 0x1p-20);
}

BOOST_AUTO_TEST_CASE(a_proved_offset_goes_at_least_so_far_and_hardly_further) {
  for (const double proved : {1e-30, 1e-9, 1e-7, 1.1e-5, 1e-3, 0.3})
    for (const double y : {0.0, 1.0, 1e6}) {
      const Departure departure = {{3, y, 0}, up, proved};
      const double in_float = left_by("proved", departure, up).origin.y - y;
      const double in_double = left_by("proved", departure, up, double_format).origin.y - y;
      BOOST_TEST(in_float >= proved);
      BOOST_TEST(in_float <= proved * (1 + 0x1p-18) + 2 * 0x1p-23 * y + 0x1p-148);
      BOOST_TEST(in_double >= proved);
      BOOST_TEST(in_double <= proved * (1 + 0x1p-46) + 2 * 0x1p-52 * y + 0x1p-1073);
    }
}

BOOST_AUTO_TEST_CASE(a_proved_offset_of_an_unproved_point_is_none) {
  const Departure departure = {{1, 2, 3}, up, std::nan("")};
  BOOST_TEST(is(left_by("proved", departure, up).origin, {1, 2, 3}));
}

BOOST_AUTO_TEST_CASE(every_ray_has_numbers_of_the_format) {
  const Departure departure = {
      {double{1.1F}, double{2.3F}, double{0.7F}}, {double{0.6F}, double{0.8F}, 0}, 1e-7};
  const Vec3<double> direction = {double{0.8F}, double{0.6F}, 0};
  for (const Offset& offset : usual_offsets()) {
    const Ray<double> ray = departing(departure, direction, offset, float_format);
    BOOST_TEST((in<double>(in<float>(ray)) == ray), offset.name);
  }
}
