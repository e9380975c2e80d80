#include "audit/along.hpp"

#include <boost/test/unit_test.hpp>

#include "geometry/case_line.hpp"

namespace {

std::string told(const char* line) {
  std::string text;
  for (const auto& [t, t_last, kind] : rayaudit::along(rayaudit::read_case_line(line).question)) {
    (text += kind) += ' ';
    rayaudit::write(text, t);
    if (t_last != t) rayaudit::write(text += ' ', t_last);
    text += "; ";
  }
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(crossings_come_first_then_the_other_roots) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1") == "proper 0x1p+1; later 0x1p+2; ");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 3 0 0 1") == "behind -0x1p+2; behind -0x1p+1; ");
  BOOST_TEST(told("disk 0 0 0 0 0 1 1 ray 0 3 -2 0 0 1") == "clipped 0x1p+1; ");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 1 -3 0 0 1") == "tangent 0x1.8p+1; ");
}

BOOST_AUTO_TEST_CASE(a_stretch_has_both_its_ends_and_an_invalid_case_nothing) {
  BOOST_TEST(told("disk 0 0 0 0 0 1 1 ray -2 0 0 1 0 0") == "within 0x1p+0 0x1.8p+1; ");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 0") == "");
}
