#include "audit/tally.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

/// A tally of the answers on case lines, counted from a place on.
Tally tallied(const std::vector<std::string>& lines, std::uint64_t place) {
  Tally tally;
  for (const std::string& line : lines) {
    const CaseLine read = read_case_line(line);
    const oracle::Truth truth = oracle::truth(read.question);
    Settled settled(read.question, truth);
    const Judgement judgement = judge(settled, *read.answer, double_format);
    const double margin = std::ldexp(settled.reach(), double_format.precision);
    tally.add(settled, *read.answer, judgement, place++, margin);
    tally.curve.add(margin, is_wrong(judgement.verdict));
  }
  return tally;
}

const std::string through = "sphere 0 0 0 1 ray 0 0 -3 0 0 1 ";

}  // namespace

BOOST_AUTO_TEST_CASE(a_quantile_is_a_sharp_upper_limit) {
  Histogram histogram;
  for (int i = 1; i <= 1000; ++i) histogram.add(i);
  const double median = histogram.quantile(0.5), p99 = histogram.quantile(0.99);
  BOOST_TEST((median >= 500 && median <= 500 * 1.125));
  BOOST_TEST((p99 >= 990 && p99 <= 1000));
  BOOST_TEST(histogram.quantile(1) == 1000);
  BOOST_TEST(histogram.largest() == 1000);
}

BOOST_AUTO_TEST_CASE(quantiles_reach_as_far_as_long_double_errors) {
  Histogram histogram;
  for (int i = 0; i < 100; ++i) histogram.add(i < 99 ? 0x1p+62 : 0x1p+100);
  BOOST_TEST((histogram.quantile(0.5) >= 0x1p+62 && histogram.quantile(0.5) <= 0x1.2p+62));
}

BOOST_AUTO_TEST_CASE(zero_tiny_and_infinite_values_have_their_quantiles) {
  Histogram histogram;
  BOOST_TEST(histogram.quantile(0.5) == 0);
  for (int i = 0; i < 9; ++i) histogram.add(0);
  BOOST_TEST(histogram.quantile(0.99) == 0);
  histogram.add(std::numeric_limits<double>::infinity());
  BOOST_TEST(histogram.quantile(0.5) <= 0x1p-10);
  BOOST_TEST(std::isinf(histogram.quantile(0.99)));
  histogram.add(std::numeric_limits<double>::quiet_NaN());
  BOOST_TEST(histogram.count() == 10U);
}

BOOST_AUTO_TEST_CASE(verdicts_claims_touches_and_sides_are_counted) {
  const Tally tally =
      tallied({through + "hit 2", through + "hit 4", through + "miss",
               "sphere 0 0 0 1 ray 0 1 -3 0 0 1 hit 3", "sphere 0 0 0 1 ray 0 1 -3 0 0 1 miss"},
              0);
  BOOST_TEST(tally.cases == 5U);
  BOOST_TEST(tally.of(Verdict::right) == 1U);
  BOOST_TEST(tally.of(Verdict::wrong_root) == 1U);
  BOOST_TEST(tally.of(Verdict::false_miss) == 1U);
  BOOST_TEST(tally.of(Verdict::touch) == 2U);
  BOOST_TEST(tally.wrong() == 2U);
  const TouchCount& tangent = tally.touches[static_cast<std::size_t>(oracle::Kind::tangent)];
  BOOST_TEST((tangent.taken == 1 && tangent.passed == 1));
  BOOST_TEST(tally.of(Claim::later) == 1U);
  BOOST_TEST(tally.sides[static_cast<std::size_t>(Side::on)] == 2U);
  BOOST_TEST(tally.of(oracle::Stage::lanes) == 3U);
  BOOST_TEST(tally.of(oracle::Stage::integers) == 2U);
}

BOOST_AUTO_TEST_CASE(the_worst_case_of_each_verdict_is_kept_whole) {
  const Tally tally = tallied({through + "hit 2", through + "hit 0x1.0000000000005p+1",
                               through + "hit 0x1.0000000000003p+1"},
                              7);
  const Worst& worst = *tally.worst(Verdict::right);
  BOOST_TEST(worst.place == 8U);
  BOOST_TEST(worst.judgement.ulps == 5);
  BOOST_TEST((worst.question == read_case_line(through).question));
}

BOOST_AUTO_TEST_CASE(the_worst_wrong_case_is_the_one_with_the_largest_margin) {
  const Tally tally = tallied({"sphere 0 0 0 1 ray 0 0x1.ffffp-1 -3 0 0 1 miss", through + "miss",
                               "sphere 0 0 0 1 ray 0 0.9 -3 0 0 1 miss"},
                              0);
  BOOST_TEST(tally.worst(Verdict::false_miss)->place == 1U);
  BOOST_TEST(tally.widest()->place == 1U);
  // r / (|y| + r) for a line at the height y = 0: half of the radius and of the origin.
  BOOST_TEST(tally.widest()->severity > 0x1p49);
}

BOOST_AUTO_TEST_CASE(the_curve_counts_cases_and_wrong_ones_by_their_margin_and_no_touch) {
  const Tally tally = tallied({through + "hit 2", through + "miss", through + "hit 2",
                               "sphere 0 0 0 1 ray 0 0x1.fffffffffffffp-1 -3 0 0 1 miss",
                               "sphere 0 0 0 1 ray 0 1 -3 0 0 1 miss"},
                              0);
  MarginCurve::Step all;
  for (int exponent = MarginCurve::least; exponent <= MarginCurve::most; ++exponent) {
    const auto& [cases, wrong] = tally.curve.at(exponent);
    all.cases += cases, all.wrong += wrong;
    if (exponent < 3) BOOST_TEST(wrong == cases);
  }
  BOOST_TEST(all.cases == 4U);
  BOOST_TEST(all.wrong == 2U);
  BOOST_TEST(tally.curve.at(MarginCurve::most).cases == 3U);
}

BOOST_AUTO_TEST_CASE(margins_beyond_the_curve_count_at_its_ends) {
  MarginCurve curve;
  curve.add(0x1p-40, true);
  curve.add(std::numeric_limits<double>::infinity(), false);
  curve.add(0x1p300, true);
  curve.add(3, true);
  BOOST_TEST(curve.at(MarginCurve::least).wrong == 1U);
  BOOST_TEST(curve.at(MarginCurve::most).cases == 2U);
  BOOST_TEST(curve.at(1).cases == 1U);
}

BOOST_AUTO_TEST_CASE(wrong_answers_have_the_causes_of_those_replayed_and_invalid_cases_none) {
  Tally tally;
  Outcome& missed = tally.outcome(Verdict::false_miss, Claim::none);
  missed.count = 90;
  for (const Cause cause : {Cause::flip, Cause::flip, Cause::rounding})
    missed.causes.add({cause, {}, {}});
  Outcome& invalid = tally.outcome(Verdict::invalid_mishandled, Claim::none);
  invalid.count = 500;
  invalid.causes.add({Cause::formula, {}, {}});
  const CauseShare share = tally.wrong_by_cause();
  BOOST_TEST(share[static_cast<std::size_t>(Cause::flip)] == 60);
  BOOST_TEST(share[static_cast<std::size_t>(Cause::rounding)] == 30);
  BOOST_TEST(share[static_cast<std::size_t>(Cause::formula)] == 0);
}

BOOST_AUTO_TEST_CASE(causes_are_counted_by_place_and_merge) {
  replay::Step here, there;
  here.file = "routines/a.hpp", here.line = 7;
  there.file = "routines/a.hpp", there.line = 3;
  CauseCount a, b;
  a.add({Cause::flip, {}, here});
  a.add({Cause::formula, "a division by 0", {}});
  b.add({Cause::flip, {}, there});
  b.add({Cause::flip, {}, here});
  b.add({Cause::rounding, {}, {}});
  a.merge(b);
  BOOST_TEST(a.replayed() == 5U);
  BOOST_TEST(a.of(Cause::flip) == 3U);
  BOOST_REQUIRE(a.turned.size() == 2);
  BOOST_TEST((a.turned[0].line == 3 && a.turned[0].count == 1));
  BOOST_TEST((a.turned[1].line == 7 && a.turned[1].count == 2));
  BOOST_REQUIRE(a.about.size() == 1);
  BOOST_TEST(a.about[0].about == "a division by 0");
}

BOOST_AUTO_TEST_CASE(claims_of_one_verdict_are_kept_apart) {
  const Tally tally =
      tallied({"sphere 0 0 0 1 ray 0 2 -3 0 0 1 hit 3", through + "hit 4",
               "sphere 0 0 0 1 ray 0 0 3 0 0 1 hit -2", "sphere 0 0 0 1 ray 0 0 3 0 0 1 hit -4"},
              0);
  BOOST_REQUIRE(tally.outcomes.size() == 3);
  BOOST_TEST((tally.outcomes[0].claim == Claim::no_root && tally.outcomes[0].count == 1));
  BOOST_TEST((tally.outcomes[1].claim == Claim::behind && tally.outcomes[1].count == 2));
  BOOST_TEST((tally.outcomes[2].verdict == Verdict::wrong_root));
  BOOST_TEST(tally.outcomes[1].worst->place == 2U);
}

BOOST_AUTO_TEST_CASE(tallies_merge_alike_in_any_order) {
  const Tally a = tallied({through + "hit 2", through + "hit 0x1.0000000000005p+1"}, 0);
  const Tally b = tallied({through + "hit 0x1.0000000000005p+1", through + "miss"}, 2);
  const Tally c = tallied({through + "hit 4"}, 4);
  Tally abc = a, cba = c;
  abc.merge(b), abc.merge(c);
  cba.merge(b), cba.merge(a);
  for (const Tally& tally : {abc, cba}) {
    BOOST_TEST(tally.cases == 5U);
    BOOST_TEST(tally.worst(Verdict::right)->place == 1U);
    BOOST_TEST(tally.ulps.quantile(0.99) == 5);
    BOOST_TEST(tally.wrong() == 2U);
  }
}
