#include "tests/oracle/second_derivation/by_kernel.hpp"
#include "tests/oracle/second_derivation/held.hpp"
#include "tests/oracle/second_derivation/proved.hpp"

namespace rayaudit::second {
namespace {

using enum oracle::Kind;

constexpr std::size_t disk = 0, sphere = 1;

BOOST_AUTO_TEST_CASE(proved_cases_are_derived_right) {
  hold_proved(disk, by_kernel);
  hold_proved(sphere, by_kernel);
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_disks) {
  hold(disk, 20'000, by_kernel, {proper, rim, start, end, within});
}

BOOST_AUTO_TEST_CASE(the_oracle_agrees_on_spheres) {
  hold(sphere, 20'000, by_kernel, {proper, tangent, start, end});
}

struct Rounding {
  std::string line;
  double in_double;
  long double in_long_double;
};

BOOST_AUTO_TEST_CASE(t_is_rounded_right_at_ties_powers_of_two_and_the_ends_of_the_formats) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Rounding roundings[] = {
      // 1 - 2^-70
      {"disk 0x800000001p+0 0 0 0x7ffffffffp+0 0 1 0x1p+71 ray 0 0 0 0 0 0x1p+70", 1, 1},
      // 1 + 2^-53
      {"disk 3002399751580331 0 0 3 0 1 0x1p+60 ray 0 0 0 0 0 0x1p+53", 1, 1 + 0x1p-53L},
      // 1 + 3 2^-53
      {"disk 1801439850948199 0 0 5 0 1 0x1p+60 ray 0 0 0 0 0 0x1p+53", 1 + 0x1p-51, 1 + 0x3p-53L},
      {"disk 0 0 0x1p-1000 0 0 1 1 ray 0 0 0 0 0 0x1p+75", 0, 0x1p-1075L},
      {"disk 0 0 0x3p-1000 0 0 1 1 ray 0 0 0 0 0 0x1p+75", 0x1p-1073, 0x3p-1075L},
      {"disk 0 0 0x1p+1000 0 0 1 1 ray 0 0 0 0 0 0x1p-100", infinity, 0x1p+1100L},
  };
  for (const Rounding& rounding : roundings) {
    const Case question = read_case_line(rounding.line).question;
    const oracle::Truth truth = oracle::truth(question);
    const Crossings derived = by_kernel(question);
    BOOST_TEST_REQUIRE(agree(truth, derived), rounding.line);
    BOOST_TEST(rounded_right(question, truth, derived), rounding.line);
    const oracle::Crossing& crossing = truth.listed[0];
    BOOST_TEST(oracle::rounded<double>(question, crossing) == rounding.in_double, rounding.line);
    BOOST_TEST(oracle::rounded<long double>(question, crossing) == rounding.in_long_double,
               rounding.line);
  }
}

}  // namespace
}  // namespace rayaudit::second
