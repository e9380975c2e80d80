#include "families/random.hpp"

#include <boost/test/unit_test.hpp>
#include <set>

using namespace rayaudit;

namespace {

Random some() { return {1, "anywhere", "disk", float_format, {}, 0}; }

}  // namespace

BOOST_AUTO_TEST_CASE(everything_a_chunk_depends_on_changes_the_numbers) {
  std::set<std::uint64_t> firsts = {
      some().bits(),
      Random(2, "anywhere", "disk", float_format, {}, 0).bits(),
      Random(1, "behind", "disk", float_format, {}, 0).bits(),
      Random(1, "anywhere", "cone", float_format, {}, 0).bits(),
      Random(1, "anywhere", "disk", double_format, {}, 0).bits(),
      Random(1, "anywhere", "disk", float_format, 0, 0).bits(),
      Random(1, "anywhere", "disk", float_format, 1, 0).bits(),
      Random(1, "anywhere", "disk", float_format, {}, 1).bits(),
  };
  BOOST_TEST(firsts.size() == 8u);
}

BOOST_AUTO_TEST_CASE(the_numbers_do_not_repeat_across_refills) {
  Random random = some();
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(random.bits());
  BOOST_TEST(seen.size() == 1000u);
}

BOOST_AUTO_TEST_CASE(whole_numbers_reach_both_ends_and_stay_between) {
  Random random = some();
  std::set<std::int64_t> seen;
  for (int i = 0; i < 1000; ++i) seen.insert(random.whole(-3, 4));
  BOOST_TEST(seen.size() == 8u);
  BOOST_TEST(*seen.begin() == -3);
  BOOST_TEST(*seen.rbegin() == 4);
}

BOOST_AUTO_TEST_CASE(symmetric_numbers_are_never_zero_and_lie_on_both_sides_evenly) {
  Random random = some();
  double sum = 0, squares = 0;
  for (int i = 0; i < 100'000; ++i) {
    const double x = random.symmetric();
    BOOST_REQUIRE(x != 0 && std::abs(x) < 1);
    sum += x, squares += x * x;
  }
  BOOST_TEST(std::abs(sum / 100'000) < 0.01);
  BOOST_TEST(std::abs(squares / 100'000 - 1.0 / 3) < 0.01);
}

BOOST_AUTO_TEST_CASE(vectors_have_the_length_asked_for) {
  Random random = some();
  for (int i = 0; i < 1000; ++i) {
    const auto v = random.vector(2, 3);
    const double length = std::sqrt(dot(v, v));
    BOOST_REQUIRE(length > 2 - 1e-12);
    BOOST_REQUIRE(length < 3 + 1e-12);
  }
}
