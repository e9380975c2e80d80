#include "audit/accuracy.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>

#include "tests/reports/hand_made.hpp"

using namespace rayaudit;

namespace {

Accuracy accuracy(std::uint64_t cases, std::uint64_t wrong, double error) {
  Accuracy made;
  made.cases = cases;
  made.wrong = wrong;
  made.error = error;
  return made;
}

Accuracy of(const Tally& tally, const Format& format) {
  Accuracy made;
  made.add(tally, format);
  return made;
}

/// Is the one before the other, and the other after the one?
bool is_before(const Accuracy& a, const Accuracy& b) { return a < b && b > a; }
bool is_as_good(const Accuracy& a, const Accuracy& b) { return (a <=> b) == 0 && (b <=> a) == 0; }

}  // namespace

BOOST_AUTO_TEST_CASE(who_is_wrong_less_often_is_more_accurate_whatever_the_errors) {
  BOOST_TEST(is_before(accuracy(100, 0, 1e6), accuracy(100, 1, 0.5)));
  BOOST_TEST(is_before(accuracy(1000, 5, 1e6), accuracy(100, 1, 0.5)));
  BOOST_TEST(is_as_good(accuracy(1000, 10, 2), accuracy(100, 1, 2)));
}

BOOST_AUTO_TEST_CASE(who_is_wrong_as_often_is_told_by_the_power_of_two_of_the_worst_error) {
  BOOST_TEST(is_before(accuracy(100, 0, 1), accuracy(100, 0, 2)));
  BOOST_TEST(is_before(accuracy(100, 0, 1.4), accuracy(100, 0, 1.5)));
  BOOST_TEST(is_as_good(accuracy(100, 0, 0.8), accuracy(100, 0, 1.3)));
  BOOST_TEST(is_before(accuracy(100, 0, 0), accuracy(100, 0, 1e-30)));
}

BOOST_AUTO_TEST_CASE(who_says_yes_and_not_where_comes_last_among_those_as_often_wrong) {
  Accuracy bare = accuracy(100, 0, 0.5);
  bare.bare = 1;
  BOOST_TEST(is_before(accuracy(100, 0, 1e30), bare));
  BOOST_TEST(is_before(bare, accuracy(100, 1, 0)));
  Accuracy silent = bare;
  silent.error = Accuracy::unmeasured;
  BOOST_TEST(is_as_good(bare, silent));
}

BOOST_AUTO_TEST_CASE(who_had_no_proper_hit_to_tell_comes_first_among_those_as_often_wrong) {
  const double none = Accuracy::unmeasured;
  BOOST_TEST(is_before(accuracy(100, 0, none), accuracy(100, 0, 1e-30)));
  BOOST_TEST(is_as_good(accuracy(100, 0, none), accuracy(100, 0, none)));
}

BOOST_AUTO_TEST_CASE(errors_of_all_formats_are_compared_in_units_of_float) {
  Tally tally;
  tally.cases = 1;
  tally.ulps.add(4);
  tally.proper_own = 4;
  BOOST_TEST(of(tally, float_format).error == 4);
  BOOST_TEST(of(tally, double_format).error == 4 * 0x1p-29);
  BOOST_TEST(of(tally, double_format).ulps == 4);
  // A double off by much is no better than a float off by little.
  Tally off = tally;
  off.proper_own = 0x1p32;
  BOOST_TEST(is_before(of(tally, float_format), of(off, double_format)));
  BOOST_TEST(is_before(of(tally, double_format), of(tally, float_format)));
}

BOOST_AUTO_TEST_CASE(a_tally_gives_its_counts_its_margin_and_its_largest_errors) {
  HandMade made;
  Tally& tally = made.add("textbook/float", 1, "grazing");
  turn(tally, Verdict::false_miss, Claim::none, 3, 0, 17);
  turn(tally, Verdict::false_hit, Claim::no_root, 2, 0, 5);
  turn(tally, Verdict::invalid_mishandled, Claim::none, 1, 0, 1e9);
  for (const double ulps : {0.5, 3.0, 1.0}) tally.ulps.add(ulps), tally.forced.add(10 * ulps);
  // The largest is of a touch.
  tally.proper_own = 1;
  tally.bare = 7;
  const Accuracy told = of(tally, float_format);
  BOOST_TEST(told.cases == 100u);
  BOOST_TEST(told.wrong == 6u);
  BOOST_TEST(told.verdicts == tally.verdicts, boost::test_tools::per_element());
  BOOST_TEST(told.wrong_margin == 17);
  BOOST_TEST(told.ulps == 3);
  BOOST_TEST(told.error == 1);
  BOOST_TEST(told.bare == 7u);
  BOOST_TEST(told.forced == 30);
  BOOST_TEST(told.share() == 0.06);
  BOOST_TEST(told.per_million(Verdict::false_miss) == 30'000);
  BOOST_TEST(told.per_million(Verdict::wrong_t) == 0);
}

BOOST_AUTO_TEST_CASE(what_was_not_seen_stays_unmeasured) {
  HandMade made;
  const Accuracy told = of(made.add("textbook/float", 1, "grazing"), float_format);
  for (const double x : {told.wrong_margin, told.ulps, told.forced, told.error})
    BOOST_TEST(std::isnan(x));
}

BOOST_AUTO_TEST_CASE(merging_adds_counts_and_keeps_the_larger_number_and_never_a_nan) {
  HandMade made;
  const Tally quiet = made.add("textbook/float", 1, "anywhere");
  Tally loud = quiet, other = quiet;
  turn(loud, Verdict::wrong_t, Claim::none, 4, 0, 8);
  loud.ulps.add(6), loud.forced.add(2);
  loud.proper_own = 6, loud.bare = 1;
  turn(other, Verdict::wrong_t, Claim::none, 1, 0, 9);
  other.ulps.add(5), other.forced.add(3);
  other.proper_own = 5, other.bare = 2;
  const Accuracy parts[] = {of(quiet, float_format), of(loud, float_format),
                            of(other, float_format)};
  for (const std::array<int, 3> order : {std::array{0, 1, 2}, {2, 0, 1}, {1, 2, 0}}) {
    Accuracy sum;
    for (const int part : order) sum.add(parts[part]);
    BOOST_TEST(sum.cases == 300u);
    BOOST_TEST(sum.wrong == 5u);
    BOOST_TEST(sum.bare == 3u);
    BOOST_TEST(sum.verdicts[static_cast<std::size_t>(Verdict::wrong_t)] == 5u);
    BOOST_TEST(sum.wrong_margin == 9);
    BOOST_TEST(sum.ulps == 6);
    BOOST_TEST(sum.error == 6);
    BOOST_TEST(sum.forced == 3);
  }
}

BOOST_AUTO_TEST_CASE(who_is_never_wrong_is_clearly_more_accurate_than_who_is) {
  BOOST_TEST(is_clearly_more_accurate(accuracy(100, 0, 1e6), accuracy(100'000, 1, 0.5)));
  BOOST_TEST(!is_clearly_more_accurate(accuracy(100'000, 1, 0.5), accuracy(100, 0, 0.5)));
}

BOOST_AUTO_TEST_CASE(a_count_is_clearly_less_where_chance_does_not_explain_it) {
  // Counts of 100 and 400 deviate by 10 and 20: together, and twice that, by 44.7.
  BOOST_TEST(is_clearly_more_accurate(accuracy(100'000, 100, 1), accuracy(100'000, 400, 1)));
  BOOST_TEST(is_clearly_more_accurate(accuracy(100'000, 355, 1), accuracy(100'000, 420, 1)));
  BOOST_TEST(!is_clearly_more_accurate(accuracy(100'000, 380, 1), accuracy(100'000, 420, 1)));
  BOOST_TEST(!is_clearly_more_accurate(accuracy(100'000, 400, 0.1), accuracy(100'000, 100, 1)));
}

BOOST_AUTO_TEST_CASE(among_counts_that_chance_explains_half_of_the_error_is_clearly_less) {
  const auto more_accurate = [](double a, double b) {
    return is_clearly_more_accurate(accuracy(100'000, 401, a), accuracy(100'000, 400, b));
  };
  BOOST_TEST(more_accurate(1, 2));
  BOOST_TEST(!more_accurate(1.1, 2));
  BOOST_TEST(!more_accurate(2, 1));
  const double none = Accuracy::unmeasured;
  BOOST_TEST(more_accurate(none, 1e-30));
  BOOST_TEST(!more_accurate(none, none));
  Accuracy bare = accuracy(100'000, 400, none);
  bare.bare = 1;
  BOOST_TEST(is_clearly_more_accurate(accuracy(100'000, 400, 1e30), bare));
  BOOST_TEST(!is_clearly_more_accurate(bare, accuracy(100'000, 400, 1e30)));
}
