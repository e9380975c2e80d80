#include "audit/spread.hpp"

#include <boost/test/unit_test.hpp>

using namespace rayaudit;

namespace {

void check(const Spread& got, double low, double median, double high) {
  BOOST_TEST(got.low == low);
  BOOST_TEST(got.median == median);
  BOOST_TEST(got.high == high);
}

}  // namespace

BOOST_AUTO_TEST_CASE(median_and_quartiles_are_those_of_the_sorted_rounds) {
  check(spread({50, 10, 40, 20, 30}), 20, 30, 40);
  check(spread({7}), 7, 7, 7);
}

BOOST_AUTO_TEST_CASE(between_two_rounds_they_are_interpolated) {
  check(spread({4, 1, 3, 2}), 1.75, 2.5, 3.25);
  check(spread({8, 0}), 2, 4, 6);
}

BOOST_AUTO_TEST_CASE(one_slow_round_moves_no_median) {
  check(spread({10, 10, 1e9, 10, 10}), 10, 10, 10);
}

BOOST_AUTO_TEST_CASE(where_quartiles_overlap_neither_is_less) {
  const Spread fast = {8, 10, 20}, slow = {20, 30, 40};
  BOOST_TEST(!is_clearly_less(fast, slow));
  BOOST_TEST(is_clearly_less({8, 10, 19}, slow));
}

BOOST_AUTO_TEST_CASE(medians_less_than_ten_per_cent_apart_are_not_told_apart) {
  BOOST_TEST(!is_clearly_less({100, 100, 100}, {109, 109, 109}));
  BOOST_TEST(is_clearly_less({100, 100, 100}, {111, 111, 111}));
}

BOOST_AUTO_TEST_CASE(what_is_more_is_not_less) {
  BOOST_TEST(!is_clearly_less({20, 20, 20}, {10, 10, 10}));
  BOOST_TEST(!is_clearly_less({10, 10, 10}, {10, 10, 10}));
}
