#include "audit/library_finding.hpp"

#include <boost/test/unit_test.hpp>

#include "tests/reports/hand_made.hpp"

using namespace rayaudit;

namespace {

/// Turns answers wrong, so many of them beyond rounding, for a cause.
void turn_beyond(Tally& tally, Verdict verdict, std::uint64_t count, std::uint64_t beyond,
                 double x = 0, const Diagnosis& cause = {Cause::formula}) {
  turn(tally, verdict, Claim::none, count, x);
  Outcome& outcome = tally.outcome(verdict, Claim::none);
  outcome.beyond_rounding += beyond;
  outcome.worst->beyond_rounding = beyond > 0;
  outcome.worst->diagnosis = cause;
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_within_rounding_is_no_finding) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "far"), Verdict::false_miss, 40, 0);
  BOOST_TEST(library_findings(made.audits).empty());
}

BOOST_AUTO_TEST_CASE(what_has_rounding_for_a_cause_is_no_finding) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "far"), Verdict::false_miss, 40, 9, 0, {Cause::rounding});
  BOOST_TEST(library_findings(made.audits).empty());
  turn_beyond(made.add(1, "scale"), Verdict::false_miss, 3, 2);
  const auto found = library_findings(made.audits);
  BOOST_TEST_REQUIRE(found.size() == 1U);
  BOOST_TEST(found[0].wrong == 2);
}

BOOST_AUTO_TEST_CASE(one_defect_over_families_is_one_finding_with_the_most_afflicted_first) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "anywhere"), Verdict::false_miss, 3, 2, 1);
  turn_beyond(made.add(1, "far"), Verdict::false_miss, 50, 40, 2);
  made.add(1, "unit");
  const auto found = library_findings(made.audits);
  BOOST_TEST_REQUIRE(found.size() == 1U);
  const LibraryFinding& one = found.front();
  BOOST_TEST((one.subject->name == "ode/double" && one.shape == 1));
  BOOST_TEST(one.wrong == 42);
  BOOST_TEST(one.cases == 200);
  BOOST_TEST_REQUIRE(one.families.size() == 2U);
  BOOST_TEST(one.families[0].family == "far");
  BOOST_TEST(one.families[0].wrong == 40);
  BOOST_TEST((one.audit == &made.audits[1]));
  BOOST_TEST((one.example.question == known_case(2)));
}

BOOST_AUTO_TEST_CASE(another_shape_or_verdict_is_another_finding_and_another_cause_is_told) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "anywhere"), Verdict::false_miss, 3, 3);
  turn_beyond(made.audits.back().tally, Verdict::wrong_t, 5, 5);
  turn_beyond(made.add(1, "far"), Verdict::false_miss, 4, 4, 0,
              {Cause::assumption, "the length of the direction"});
  turn_beyond(made.add(4, "far"), Verdict::false_miss, 2, 2);
  const auto found = library_findings(made.audits);
  BOOST_TEST_REQUIRE(found.size() == 3U);
  BOOST_TEST((found[0].verdict == Verdict::false_miss && found[0].wrong == 7));
  BOOST_TEST_REQUIRE(found[0].causes.size() == 2U);
  BOOST_TEST(found[0].causes[0].of == "assumption of the length of the direction");
  BOOST_TEST(found[0].causes[1].count == 3);
  BOOST_TEST((found[1].verdict == Verdict::wrong_t && found[1].shape == 1));
  BOOST_TEST(found[2].shape == 4);
}

BOOST_AUTO_TEST_CASE(hits_behind_the_start_are_a_finding_of_their_own) {
  HandMade made;
  Tally& tally = made.add("ode/double", 1, "anywhere");
  for (const Claim claim : {Claim::behind, Claim::later, Claim::clipped}) {
    turn(tally, Verdict::wrong_root, claim, 2);
    Outcome& outcome = tally.outcome(Verdict::wrong_root, claim);
    outcome.beyond_rounding = 2, outcome.worst->beyond_rounding = true;
  }
  const auto found = library_findings(made.audits);
  BOOST_TEST_REQUIRE(found.size() == 2U);
  BOOST_TEST(found[0].wrong == 4);
  BOOST_TEST(found[0].families[0].wrong == 4);
  BOOST_TEST(found[0].claims.size() == 2U);
  BOOST_TEST((!found[0].is_behind() && found[1].is_behind()));
}

BOOST_AUTO_TEST_CASE(an_example_of_moderate_numbers_is_told_first) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "scale"), Verdict::false_miss, 90, 90, 0x1p300);
  turn_beyond(made.add(1, "anywhere"), Verdict::false_miss, 1, 1, 5);
  const auto found = library_findings(made.audits);
  BOOST_TEST_REQUIRE(found.size() == 1U);
  BOOST_TEST((found[0].example.question == known_case(5)));
  BOOST_TEST(found[0].families[0].family == "scale");
}

BOOST_AUTO_TEST_CASE(an_example_far_from_any_other_truth_is_told_before_one_that_is_frequent) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "grazing"), Verdict::false_miss, 90, 90, 7);
  turn_beyond(made.add(1, "anywhere"), Verdict::false_miss, 1, 1, 5);
  turn_beyond(made.add(1, "lattice"), Verdict::false_miss, 1, 1, 0.0625 + 0x1p-9);
  for (std::size_t i = 1; i < 3; ++i)
    made.audits[i].tally.outcome(Verdict::false_miss, Claim::none).worst->severity = 0x1p13;
  BOOST_TEST((library_findings(made.audits)[0].example.question == known_case(5)));
  made.subjects[0].format = double_format;
  BOOST_TEST((library_findings(made.audits)[0].example.question == known_case(7)));
}

BOOST_AUTO_TEST_CASE(what_does_not_show_again_is_none) {
  HandMade made;
  turn_beyond(made.add("ode/double", 1, "far"), Verdict::false_miss, 4, 4);
  made.audits.back().tally.outcome(Verdict::false_miss, Claim::none).worst->repeats = false;
  BOOST_TEST(library_findings(made.audits).empty());
}
