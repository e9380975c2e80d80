#include "geometry/case.hpp"

#include <boost/test/unit_test.hpp>
#include <vector>

#include "geometry/format.hpp"

namespace rayaudit {
namespace {

BOOST_AUTO_TEST_CASE(every_number_is_visited_origin_direction_then_the_shape) {
  Case question = {{{1, 2, 3}, {4, 5, 6}, 20, 30}, Cone<double>{{7, 8, 9}, {10, 11, 12}, 13}};
  std::vector<double> numbers;
  each_number(question, [&](double number) { numbers.push_back(number); });
  BOOST_TEST((numbers == std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13}));
}

BOOST_AUTO_TEST_CASE(a_visit_may_change_the_case) {
  Case question = {{{1, 2, 3}, {4, 5, 6}}, Sphere<double>{{7, 8, 9}, 10}};
  each_number(question, [](double& number) { number *= 2; });
  BOOST_TEST((question == Case{{{2, 4, 6}, {8, 10, 12}}, Sphere<double>{{14, 16, 18}, 20}}));
}

BOOST_AUTO_TEST_CASE(each_shape_names_the_numbers_it_has) {
  const Shape shapes[] = {Disk<double>{}, Sphere<double>{}, Cylinder<double>{}, Cone<double>{}};
  for (const Shape& shape : shapes)
    std::visit(
        [](const auto& s) {
          const std::size_t parts = std::tuple_size_v<decltype(s.parts())>;
          BOOST_TEST(s.kinds.size() == parts, s.name);
          BOOST_TEST(s.labels.size() == parts, s.name);
        },
        shape);
}

BOOST_AUTO_TEST_CASE(a_shape_in_float_has_the_floats_of_its_doubles) {
  const Cylinder<double> shape = {{0.1, 2, 3}, {4, 5, 6}, 0.3};
  BOOST_TEST((in<float>(shape) == Cylinder<float>{{0.1f, 2, 3}, {4, 5, 6}, 0.3f}));
}

BOOST_AUTO_TEST_CASE(formats_know_their_ends) {
  BOOST_TEST(float_format.tiny_exponent() == -149);
  BOOST_TEST(double_format.tiny_exponent() == -1074);
  BOOST_TEST(double_format.max_exponent == 1023);
  BOOST_TEST(long_double_format.precision == 64);
}

}  // namespace
}  // namespace rayaudit
