#include "routines/frame.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

using namespace rayaudit;

BOOST_AUTO_TEST_CASE(it_stands_square_on_any_axis_with_lengths_of_1) {
  for (double x = -3; x <= 3; ++x)
    for (double y = -3; y <= 3; ++y)
      for (double z = -3; z <= 3; ++z) {
        const Vec3<double> axis = {x, y, z};
        if (dot(axis, axis) == 0) continue;
        const Frame<double> f = frame_along(axis);
        BOOST_TEST_CONTEXT("axis " << x << ' ' << y << ' ' << z) {
          for (const double length : {dot(f.x, f.x), dot(f.y, f.y), dot(f.z, f.z)})
            BOOST_TEST(std::abs(length - 1) < 1e-14);
          for (const double slant : {dot(f.x, f.y), dot(f.y, f.z), dot(f.z, f.x)})
            BOOST_TEST(std::abs(slant) < 1e-14);
          BOOST_TEST(std::abs(dot(f.y, axis) - std::sqrt(dot(axis, axis))) < 1e-14 * 6);
        }
      }
}
