#include "audit/finding.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "geometry/case_line.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

using Names = std::vector<std::string>;
constexpr std::size_t disk = 0, sphere = 1;

void check(const Names& got, const Names& wanted) {
  BOOST_TEST(got == wanted, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(nothing_wrong_is_no_finding) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "anywhere");
  turn(tally, Verdict::touch, Claim::none, 30);
  turn(tally, Verdict::invalid_handled, Claim::none, 20);
  BOOST_TEST(findings(made.audits).empty());
}

BOOST_AUTO_TEST_CASE(what_has_routine_shape_verdict_and_claim_in_common_is_one_finding) {
  HandMade made;
  turn(made.add("handout/float", disk, "within"), Verdict::false_hit, Claim::no_root, 20, 1);
  turn(made.add(disk, "parallel"), Verdict::false_hit, Claim::no_root, 50, 2);
  turn(made.add("handout/double", disk, "within"), Verdict::false_hit, Claim::no_root, 30, 3);
  turn(made.add("textbook/long_double", disk, "far"), Verdict::false_miss, Claim::none, 1);
  const auto found = findings(made.audits);
  BOOST_REQUIRE(found.size() == 2);
  const Finding& worst = found[0];
  BOOST_TEST(worst.routine == "handout");
  BOOST_TEST(worst.shape == disk);
  BOOST_TEST((worst.verdict == Verdict::false_hit));
  BOOST_TEST((worst.claim == Claim::no_root));
  check(worst.numbers, {"float", "double"});
  BOOST_REQUIRE(worst.families.size() == 2);
  BOOST_TEST((worst.families[0].family == "parallel" && worst.families[0].share() == 0.5));
  BOOST_TEST((worst.families[1].family == "within" && worst.families[1].share() == 0.3));
  BOOST_TEST(worst.wrong == 100);
  BOOST_TEST(worst.cases == 300);
  BOOST_TEST(worst.share == 0.5);
  BOOST_TEST(worst.audit->subject->name == "handout/float");
  BOOST_TEST((worst.example.question == known_case(2)), case_line(worst.example.question));
}

BOOST_AUTO_TEST_CASE(shapes_verdicts_and_claims_are_told_apart) {
  HandMade made;
  turn(made.add("handout/float", disk, "a"), Verdict::false_hit, Claim::no_root, 1);
  turn(made.add(sphere, "a"), Verdict::false_hit, Claim::no_root, 1);
  turn(made.add(disk, "b"), Verdict::false_hit, Claim::behind, 1);
  turn(made.add(disk, "c"), Verdict::wrong_root, Claim::behind, 1);
  turn(made.add("other/float", disk, "a"), Verdict::false_hit, Claim::no_root, 1);
  BOOST_TEST(findings(made.audits).size() == 5);
}

BOOST_AUTO_TEST_CASE(one_audit_can_hold_several_findings) {
  HandMade made;
  Tally& tally = made.add("handout/float", disk, "a");
  turn(tally, Verdict::false_hit, Claim::no_root, 1);
  turn(tally, Verdict::false_miss, Claim::none, 2);
  BOOST_TEST(findings(made.audits).size() == 2);
}

BOOST_AUTO_TEST_CASE(the_worst_share_comes_first_then_verdicts_then_names) {
  HandMade made;
  turn(made.add("b/float", disk, "x"), Verdict::false_miss, Claim::none, 10);
  turn(made.add("c/float", disk, "x"), Verdict::false_hit, Claim::no_root, 10);
  turn(made.add("a/float", disk, "x"), Verdict::false_miss, Claim::none, 10);
  turn(made.add("d/float", disk, "x"), Verdict::wrong_t, Claim::none, 11);
  turn(made.add("e/float", disk, "x"), Verdict::wrong_t, Claim::none, 1);
  turn(made.add("e/double", disk, "x"), Verdict::wrong_t, Claim::none, 12);
  Names order;
  for (const Finding& finding : findings(made.audits)) order.push_back(finding.routine);
  check(order, {"e", "d", "c", "a", "b"});
}

BOOST_AUTO_TEST_CASE(the_largest_margin_leads_by_its_power_of_two) {
  HandMade made;
  turn(made.add("a/float", disk, "spawned"), Verdict::wrong_t, Claim::none, 90, 1, 3);
  turn(made.add(disk, "far"), Verdict::wrong_t, Claim::none, 2, 2, 70);
  turn(made.add("b/float", disk, "spawned"), Verdict::wrong_t, Claim::none, 80, 3, 5);
  turn(made.add("c/float", disk, "far"), Verdict::wrong_t, Claim::none, 6, 4, 65);
  turn(made.add("d/float", disk, "far"), Verdict::wrong_t, Claim::none, 1, 5, 1e6);
  const auto found = findings(made.audits);
  Names order;
  for (const Finding& finding : found) order.push_back(finding.routine);
  check(order, {"d", "a", "c", "b"});
  BOOST_TEST(found[1].margin == 70);
  BOOST_TEST(found[1].audit->family->id == "far");
  BOOST_TEST((found[1].example.question == known_case(2)), case_line(found[1].example.question));
}

BOOST_AUTO_TEST_CASE(the_causes_of_a_finding_are_those_of_its_audits) {
  HandMade made;
  Tally& here = made.add("a/float", disk, "far");
  turn(here, Verdict::wrong_t, Claim::none, 3);
  here.outcome(Verdict::wrong_t, Claim::none).causes.add({Cause::rounding, {}, {}});
  Tally& there = made.add("a/double", disk, "far");
  turn(there, Verdict::wrong_t, Claim::none, 3);
  there.outcome(Verdict::wrong_t, Claim::none).causes.add({Cause::formula, {}, {}});
  const auto found = findings(made.audits);
  BOOST_REQUIRE(found.size() == 1);
  BOOST_TEST(found[0].causes.replayed() == 2U);
  BOOST_TEST(found[0].causes.of(Cause::formula) == 1U);
}

BOOST_AUTO_TEST_CASE(invalid_cases_come_last) {
  HandMade made;
  turn(made.add("a/float", disk, "invalid"), Verdict::invalid_mishandled, Claim::none, 100);
  turn(made.add("b/float", disk, "far"), Verdict::wrong_t, Claim::none, 1);
  BOOST_TEST((findings(made.audits).back().verdict == Verdict::invalid_mishandled));
}

BOOST_AUTO_TEST_CASE(a_subject_without_a_number_in_its_name_is_told_by_its_format) {
  HandMade made;
  turn(made.add("mine", disk, "far"), Verdict::wrong_t, Claim::none, 1);
  const auto found = findings(made.audits);
  BOOST_TEST(found[0].routine == "mine");
  check(found[0].numbers, {"float"});
}

}  // namespace
}  // namespace rayaudit
