#include "geometry/unknown_name.hpp"

#include <array>
#include <boost/test/unit_test.hpp>

namespace rayaudit {
namespace {

constexpr std::array<std::string_view, 3> shapes = {"disk", "sphere", "cone"};

BOOST_AUTO_TEST_CASE(a_slip_of_the_fingers_is_told_the_name_it_meant) {
  BOOST_TEST(unknown_name("shape", "shpere", shapes) ==
             "shape `shpere` is not known; did you mean `sphere`?");
  BOOST_TEST(unknown_name("shape", "dsk", shapes) ==
             "shape `dsk` is not known; did you mean `disk`?");
  BOOST_TEST(unknown_name("shape", "dsik", shapes) ==
             "shape `dsik` is not known; did you mean `disk`?");
  BOOST_TEST(unknown_name("shape", "conee", shapes) ==
             "shape `conee` is not known; did you mean `cone`?");
}

BOOST_AUTO_TEST_CASE(a_name_near_to_none_is_told_them_all) {
  BOOST_TEST(unknown_name("shape", "teapot", shapes) ==
             "shape `teapot` is not known; known are `disk`, `sphere`, `cone`");
}

}  // namespace
}  // namespace rayaudit
