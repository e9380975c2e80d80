#include "reports/breach.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

FailOn on(Verdict verdict) {
  FailOn made;
  made.verdicts[static_cast<std::size_t>(verdict)] = true;
  return made;
}

/// `TYPE: WORDS at X` of the case that shows it, or `holds`.
std::string told(const FailOn& fail_on, const Tally& tally) {
  const auto found = breach(fail_on, tally);
  if (!found) return "holds";
  const std::string place =
      found->worst == nullptr
          ? ""
          : " at " + std::to_string(static_cast<int>(found->worst->question.ray.origin.x));
  return std::string(found->type) + ": " + found->words + place;
}

BOOST_AUTO_TEST_CASE(a_verdict_that_is_to_fail_does_so_where_it_occurs_and_no_other) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  turn(tally, Verdict::false_miss, Claim::none, 37, 7);
  turn(tally, Verdict::wrong_t, Claim::none, 2, 8);
  BOOST_TEST(told(on(Verdict::false_miss), tally) == "false_miss: 37 of 100 cases false_miss at 7");
  BOOST_TEST(told(on(Verdict::wrong_t), tally) == "wrong_t: 2 of 100 cases wrong_t at 8");
  BOOST_TEST(told(on(Verdict::crashed), tally) == "holds");
  BOOST_TEST(told({}, tally) == "holds");
}

BOOST_AUTO_TEST_CASE(who_crashed_or_hung_fails_as_who_is_wrong) {
  for (const Verdict verdict : {Verdict::crashed, Verdict::timed_out}) {
    HandMade made;
    Tally& tally = made.add("mine/float", 1, "far");
    turn(tally, verdict, Claim::none, 3, 5);
    const std::string is(name(verdict));
    BOOST_TEST(told(on(verdict), tally) == is + ": 3 of 100 cases " + is + " at 5");
  }
}

BOOST_AUTO_TEST_CASE(an_error_fails_beyond_its_limit) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  tally.ulps.add(5);
  tally.worst_ulps = Worst{5, 0, known_case(9), Answer::hit(real(4.5)), {}, {}};
  BOOST_TEST(told({.most_ulps = 5}, tally) == "holds");
  BOOST_TEST(told({.most_ulps = 4}, tally) == "max_ulp: a t is off by 5 ulps, more than 4 at 9");
}

BOOST_AUTO_TEST_CASE(what_was_not_asked_holds_nothing_that_is_asked_for) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  tally.unasked = 1234;
  BOOST_TEST(told({}, tally) == "holds");
  BOOST_TEST(told(on(Verdict::wrong_t), tally) == "unasked: 1,234 cases were not asked after 100");
  BOOST_TEST(told({.most_ulps = 4}, tally) == "unasked: 1,234 cases were not asked after 100");
  turn(tally, Verdict::invalid_mishandled, Claim::ended, 3, 5);
  BOOST_TEST(told(on(Verdict::wrong_t), tally).ends_with(" after 100 at 5"));
  turn(tally, Verdict::crashed, Claim::none, 3, 6);
  BOOST_TEST(told(on(Verdict::wrong_t), tally).ends_with(" after 100 at 6"));
}

}  // namespace
}  // namespace rayaudit
