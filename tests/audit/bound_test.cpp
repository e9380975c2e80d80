#include "audit/bound.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <random>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

constexpr std::size_t disk = 0, sphere = 1, cone = 3;

std::vector<Bound> read(const std::string& text) { return read_bounds(text, "mine.txt"); }

std::string fault_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

/// The broken limits of one audit, as `LIMIT SEEN` and the x of the case that shows it.
std::vector<std::string> broken_by(const std::string& row, const HandMade& made) {
  const std::vector<Bound> bounds = read(row);
  std::vector<std::string> all;
  for (const Broken& each : broken(bounds, made.audits)) {
    BOOST_TEST((each.bound == &bounds[0]));
    BOOST_TEST(each.seen > each.limit.most);
    BOOST_REQUIRE(each.worst != nullptr);
    all.push_back(std::string(each.limit.quantity->name) + " " +
                  std::to_string(static_cast<int>(each.seen)) + " at " +
                  std::to_string(static_cast<int>(each.worst->question.ray.origin.x)));
  }
  return all;
}

using Words = std::vector<std::string>;
void check(const Words& got, const Words& wanted) {
  BOOST_TEST(got == wanted, boost::test_tools::per_element());
}

Worst worst_at(double x, double severity) {
  return {severity, 0, known_case(x), Answer::hit(real(4.5)), {}, {}};
}

/// Limits as `LIMIT VALUE`, in words.
Words limits_of(const Bound& bound) {
  Words words;
  for (const auto& [quantity, most] : bound.limits) {
    std::ostringstream text;
    text << quantity->name << ' ' << most;
    words.push_back(text.str());
  }
  return words;
}

BOOST_AUTO_TEST_CASE(rows_are_read_and_comments_and_blank_lines_pass) {
  const auto bounds = read(
      "# what they promise\n"
      "\n"
      "  textbook/float sphere anywhere wrong 0 max_ulp 2.5 observed # why\r\n"
      "\t*/double\t*  far-*  max_ulp 1e3  proved");
  BOOST_REQUIRE(bounds.size() == 2);
  BOOST_TEST(bounds[0].subject == "textbook/float");
  BOOST_TEST(bounds[0].shape == "sphere");
  BOOST_TEST(bounds[0].family == "anywhere");
  BOOST_TEST(!bounds[0].proved);
  BOOST_TEST(bounds[0].place == "mine.txt:3");
  check(limits_of(bounds[0]), {"wrong 0", "max_ulp 2.5"});
  BOOST_TEST(bounds[1].subject == "*/double");
  BOOST_TEST(bounds[1].proved);
  BOOST_TEST(bounds[1].place == "mine.txt:4");
  check(limits_of(bounds[1]), {"max_ulp 1000"});
}

BOOST_AUTO_TEST_CASE(a_text_without_rows_has_no_bounds) {
  BOOST_TEST(read("").empty());
  BOOST_TEST(read("# none\n\n  \n").empty());
}

BOOST_AUTO_TEST_CASE(every_limit_can_be_read) {
  for (const Quantity& quantity : quantities()) {
    const auto bounds = read("* * * " + std::string(quantity.name) + " 3 observed");
    BOOST_TEST((bounds[0].limits[0] == Limit{&quantity, 3}), quantity.name);
  }
}

BOOST_AUTO_TEST_CASE(a_name_that_is_not_known_is_told_with_the_nearest) {
  BOOST_TEST(fault_of("\ntextbok/float sphere far wrong 0 observed") ==
             "mine.txt:2: subject `textbok/float` is not known; did you mean `textbook/float`?");
  BOOST_TEST(fault_of("textbook/float shpere far wrong 0 observed") ==
             "mine.txt:1: shape `shpere` is not known; did you mean `sphere`?");
  BOOST_TEST(fault_of("textbook/float sphere farr wrong 0 observed") ==
             "mine.txt:1: family `farr` is not known; did you mean `far`?");
  BOOST_TEST(fault_of("textbook/float sphere far max_ulps 1 observed") ==
             "mine.txt:1: limit `max_ulps` is not known; did you mean `max_ulp`?");
}

BOOST_AUTO_TEST_CASE(a_row_that_is_no_promise_is_told_with_the_mend) {
  const std::string names = "textbook/float sphere far ";
  const std::string parts =
      "mine.txt:1: expected SUBJECT SHAPE FAMILY, then limits with their values, then `proved` or "
      "`observed`";
  BOOST_TEST(fault_of("textbook/float") == parts);
  BOOST_TEST(fault_of(names) == parts);
  BOOST_TEST(fault_of(names + "wrong 0") ==
             "mine.txt:1: expected `proved` or `observed` at the end, got `0`");
  BOOST_TEST(fault_of(names + "wrong 0 prooved") ==
             "mine.txt:1: expected `proved` or `observed` at the end, got `prooved`");
  BOOST_TEST(fault_of(names + "proved") ==
             "mine.txt:1: expected a limit after the family, as in `max_ulp 4`");
  BOOST_TEST(fault_of(names + "wrong 0 max_ulp proved") ==
             "mine.txt:1: limit `max_ulp` needs its value, as in `max_ulp 4`");
  BOOST_TEST(fault_of(names + "false_hit proved") ==
             "mine.txt:1: limit `false_hit` needs its value, as in `false_hit 0`");
  BOOST_TEST(fault_of(names + "wrong 0 wrong 1 proved") ==
             "mine.txt:1: limit `wrong` is there twice");
}

BOOST_AUTO_TEST_CASE(a_value_that_is_none_is_told) {
  for (const std::string bad : {"few", "-1", "nan", "inf", "1e999", "1x", "0x10", "false_hit"})
    BOOST_TEST(fault_of("* * * max_ulp " + bad + " observed") ==
               "mine.txt:1: max_ulp must be a number, 0 or more, got `" + bad + "`");
  BOOST_TEST(fault_of("* * * false_hit 0.5 observed") ==
             "mine.txt:1: false_hit must be a whole number, 0 or more, got `0.5`");
}

BOOST_AUTO_TEST_CASE(each_wrong_verdict_breaks_its_limit_and_that_of_all) {
  for (const Verdict verdict :
       {Verdict::false_hit, Verdict::false_miss, Verdict::wrong_root, Verdict::wrong_t,
        Verdict::not_finite, Verdict::invalid_mishandled}) {
    HandMade made;
    turn(made.add("textbook/float", sphere, "far"), verdict, Claim::none, 3, 7, 0);
    const std::string limit(name(verdict));
    check(broken_by("textbook/float sphere far " + limit + " 2 observed", made),
          {limit + " 3 at 7"});
    check(broken_by("textbook/float sphere far " + limit + " 3 observed", made), {});
    check(broken_by("textbook/float sphere far wrong 2 observed", made), {"wrong 3 at 7"});
    check(broken_by("textbook/float sphere far wrong 3 observed", made), {});
    for (const Quantity& other : quantities())
      if (other.name != limit && other.name != "wrong")
        check(broken_by("* * * " + std::string(other.name) + " 0 observed", made), {});
  }
}

BOOST_AUTO_TEST_CASE(what_crashed_or_hung_breaks_its_limit_and_that_of_all) {
  for (const Verdict verdict : {Verdict::crashed, Verdict::timed_out}) {
    HandMade made;
    turn(made.add("mine/float", sphere, "far"), verdict, Claim::none, 3, 7, 0);
    const std::string limit(name(verdict));
    check(broken_by("* * * " + limit + " 2 observed", made), {limit + " 3 at 7"});
    check(broken_by("* * * " + limit + " 3 observed", made), {});
    check(broken_by("* * * wrong 2 observed", made), {"wrong 3 at 7"});
    check(broken_by("* * * false_hit 0 invalid_mishandled 0 observed", made), {});
  }
}

BOOST_AUTO_TEST_CASE(cases_that_were_not_asked_break_every_row_that_does_not_grant_them) {
  HandMade made;
  Tally& tally = made.add("mine/float", sphere, "far");
  turn(tally, Verdict::crashed, Claim::none, 3, 7, 0);
  tally.unasked = 20;
  check(broken_by("* * * crashed 3 observed", made), {"unasked 20 at 7"});
  check(broken_by("* * * max_ulp 1e9 proved", made), {"unasked 20 at 7"});
  check(broken_by("* * * crashed 3 unasked 19 observed", made), {"unasked 20 at 7"});
  check(broken_by("* * * crashed 3 unasked 20 observed", made), {});
  check(broken_by("* * rim crashed 3 observed", made), {});
  HandMade silent;
  silent.add("mine/float", sphere, "far").unasked = 20;
  const std::vector<Broken> all = broken(read("* * * wrong 0 observed"), silent.audits);
  BOOST_REQUIRE(all.size() == 1);
  BOOST_TEST(all[0].limit.quantity->name == "unasked");
  BOOST_TEST((all[0].worst == nullptr));
}

BOOST_AUTO_TEST_CASE(what_is_right_or_a_touch_breaks_no_count) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  turn(tally, Verdict::touch, Claim::none, 30);
  turn(tally, Verdict::invalid_handled, Claim::none, 20);
  for (const Quantity& quantity : quantities())
    check(broken_by("* * * " + std::string(quantity.name) + " 0 observed", made), {});
}

BOOST_AUTO_TEST_CASE(an_error_beyond_its_limit_breaks_it) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  tally.worst_ulps = worst_at(1, 8);
  tally.worst_forced = worst_at(2, 4);
  check(broken_by("* * * max_ulp 8 max_forced 4 observed", made), {});
  check(broken_by("* * * max_ulp 7.9 max_forced 4 observed", made), {"max_ulp 8 at 1"});
  check(broken_by("* * * max_ulp 8 max_forced 3.9 observed", made), {"max_forced 4 at 2"});
}

BOOST_AUTO_TEST_CASE(a_wrong_case_beyond_the_margin_breaks_it) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  turn(tally, Verdict::false_miss, Claim::none, 1, 1, 3);
  turn(tally, Verdict::wrong_t, Claim::none, 1, 2, 5);
  turn(tally, Verdict::invalid_mishandled, Claim::none, 1, 3, 9);
  check(broken_by("* * * wrong_margin 5 observed", made), {});
  check(broken_by("* * * wrong_margin 4 observed", made), {"wrong_margin 5 at 2"});
  check(broken_by("* * * wrong 0 observed", made), {"wrong 3 at 2"});
  check(broken_by("* * * wrong_margin 1e300 observed", made), {});
  tally.outcome(Verdict::wrong_t, Claim::none).worst->severity =
      std::numeric_limits<double>::infinity();
  BOOST_TEST(broken(read("* * * wrong_margin 1e300 observed"), made.audits).size() == 1);
}

BOOST_AUTO_TEST_CASE(a_row_speaks_of_the_audits_that_it_names_and_no_others) {
  HandMade made;
  for (const char* subject : {"textbook/float", "textbook/double"})
    for (const std::size_t shape : {disk, sphere})
      for (const char* family : {"far", "rim", "rim-near"})
        turn(made.add(subject, shape, family), Verdict::false_hit, Claim::none, 1);
  const auto count = [&](const std::string& names) {
    return broken(read(names + " false_hit 0 observed"), made.audits).size();
  };
  BOOST_TEST(count("textbook/float disk rim") == 1u);
  BOOST_TEST(count("textbook/* disk rim") == 2u);
  BOOST_TEST(count("textbook/float * rim") == 2u);
  BOOST_TEST(count("textbook/float disk rim*") == 2u);
  BOOST_TEST(count("* * *") == 12u);
  BOOST_TEST(count("handout/float * *") == 0u);
}

BOOST_AUTO_TEST_CASE(broken_limits_come_in_the_order_of_the_file) {
  HandMade made;
  turn(made.add("textbook/float", disk, "far"), Verdict::false_hit, Claim::none, 1);
  turn(made.add("handout/float", disk, "far"), Verdict::false_miss, Claim::none, 1);
  const auto bounds = read(
      "handout/float * * wrong 0 false_miss 0 observed\n"
      "* * * wrong 0 proved\n");
  Words got;
  for (const Broken& each : broken(bounds, made.audits))
    got.push_back(each.bound->place + " " + each.audit->subject->name + " " +
                  std::string(each.limit.quantity->name));
  check(got, {"mine.txt:1 handout/float wrong", "mine.txt:1 handout/float false_miss",
              "mine.txt:2 textbook/float wrong", "mine.txt:2 handout/float wrong"});
}

BOOST_AUTO_TEST_CASE(what_is_observed_of_a_subject_that_holds) {
  HandMade made;
  Tally& tally = made.add("textbook/float", cone, "rim-near");
  tally.worst_ulps = worst_at(1, 1.234);
  tally.worst_forced = worst_at(1, 0.5);
  const auto bounds = observed(made.audits);
  BOOST_REQUIRE(bounds.size() == 1);
  BOOST_TEST(bounds[0].subject == "textbook/float");
  BOOST_TEST(bounds[0].shape == "cone");
  BOOST_TEST(bounds[0].family == "rim-near");
  BOOST_TEST(!bounds[0].proved);
  check(limits_of(bounds[0]), {"wrong 0", "max_ulp 1.3", "max_forced 0.5"});
}

BOOST_AUTO_TEST_CASE(crashes_and_cases_not_asked_are_observed_of_subjects_elsewhere_only) {
  HandMade made;
  Tally& tally = made.add("mine/float", sphere, "far");
  turn(tally, Verdict::crashed, Claim::none, 16, 1, 3);
  turn(tally, Verdict::false_miss, Claim::none, 4, 1, 3);
  tally.unasked = 84;
  made.subjects[0].is_elsewhere = true;
  check(limits_of(observed(made.audits)[0]),
        {"false_hit 0", "wrong_root 0", "wrong_t 0", "not_finite 0", "timed_out 0",
         "wrong_margin 3", "unasked 84"});
  BOOST_TEST(broken(observed(made.audits), made.audits).empty());
  HandMade whole;
  turn(whole.add("mine/float", sphere, "far"), Verdict::false_miss, Claim::none, 4, 1, 3);
  whole.subjects[0].is_elsewhere = true;
  check(limits_of(observed(whole.audits)[0]),
        {"false_hit 0", "wrong_root 0", "wrong_t 0", "not_finite 0", "crashed 0", "timed_out 0",
         "unasked 0", "wrong_margin 3"});
  whole.subjects[0].is_elsewhere = false;
  check(limits_of(observed(whole.audits)[0]),
        {"false_hit 0", "wrong_root 0", "wrong_t 0", "not_finite 0", "wrong_margin 3"});
}

/// What is observed with room of 2 where so many ulps were measured near 1, and one was the
/// largest.
Words with_room(double largest, int others) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  for (int i = 0; i < others; ++i) tally.ulps.add(1);
  tally.ulps.add(largest);
  tally.worst_ulps = worst_at(1, largest);
  return limits_of(observed(made.audits, 2)[0]);
}

BOOST_AUTO_TEST_CASE(an_error_is_granted_room_where_many_come_near_it) {
  check(with_room(1.9, 100), {"wrong 0", "max_ulp 3.8"});
  check(with_room(1.9, 16), {"wrong 0", "max_ulp 3.8"});
  check(with_room(1.9, 14), {"wrong 0"});
  check(with_room(2.6, 100), {"wrong 0"});
}

BOOST_AUTO_TEST_CASE(with_room_each_error_is_held_against_its_own_kind) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  for (int i = 0; i < 100; ++i) {
    tally.ulps.add(1);
    tally.forced.add(1);
  }
  tally.ulps.add(50);
  tally.worst_ulps = worst_at(1, 50);
  tally.worst_forced = worst_at(1, 1);
  check(limits_of(observed(made.audits, 2)[0]), {"wrong 0", "max_forced 2"});
}

BOOST_AUTO_TEST_CASE(with_room_no_limit_is_told_that_every_t_keeps_that_is_not_wrong) {
  const auto told = [](double ulps) {
    HandMade made;
    Tally& tally = made.add("textbook/float", sphere, "far");
    for (int i = 0; i < 100; ++i) tally.ulps.add(ulps);
    tally.worst_ulps = worst_at(1, ulps);
    return limits_of(observed(made.audits, 2)[0]);
  };
  check(told(60'000), {"wrong 0", "max_ulp 120000"});
  check(told(66'000), {"wrong 0"});  // 2^(24 - 7) are 131,072
}

BOOST_AUTO_TEST_CASE(with_room_no_count_is_told_beside_few_wrong_answers) {
  const auto told = [](std::uint64_t wrong) {
    HandMade made;
    turn(made.add("textbook/float", sphere, "far"), Verdict::false_miss, Claim::none, wrong, 1, 1);
    return limits_of(observed(made.audits, 2)[0]);
  };
  check(told(15), {"wrong_margin 2"});
  check(told(16), {"false_hit 0", "wrong_root 0", "wrong_t 0", "not_finite 0", "wrong_margin 2"});
}

BOOST_AUTO_TEST_CASE(of_what_was_wrong_only_the_margin_is_observed) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  turn(tally, Verdict::false_miss, Claim::none, 4, 1, 3.01);
  check(limits_of(observed(made.audits)[0]),
        {"false_hit 0", "wrong_root 0", "wrong_t 0", "not_finite 0", "wrong_margin 3.1"});
  BOOST_TEST(broken(observed(made.audits), made.audits).empty());
}

BOOST_AUTO_TEST_CASE(invalid_cases_are_observed_for_themselves) {
  HandMade made;
  turn(made.add("textbook/float", sphere, "invalid"), Verdict::invalid_mishandled, Claim::none,
       100);
  BOOST_TEST(observed(made.audits).empty());
  HandMade mixed;
  Tally& tally = mixed.add("textbook/float", sphere, "invalid");
  turn(tally, Verdict::invalid_handled, Claim::none, 50);
  turn(tally, Verdict::false_hit, Claim::none, 1, 1, 0);
  check(limits_of(observed(mixed.audits)[0]),
        {"false_miss 0", "wrong_root 0", "wrong_t 0", "not_finite 0", "invalid_mishandled 0",
         "wrong_margin 0"});
}

BOOST_AUTO_TEST_CASE(what_has_no_end_is_no_promise) {
  HandMade made;
  Tally& tally = made.add("textbook/float", sphere, "far");
  tally.worst_ulps = worst_at(1, std::numeric_limits<double>::infinity());
  check(limits_of(observed(made.audits)[0]), {"wrong 0"});
}

BOOST_AUTO_TEST_CASE(numbers_are_rounded_up_to_two_digits) {
  const auto is = [](double x, double wanted) { BOOST_TEST(rounded_up(x) == wanted, x); };
  is(0, 0);
  is(0.3, 0.3);
  is(0.07, 0.07);
  is(0.5, 0.5);
  is(0.5000001, 0.51);
  is(0.994, 1);
  is(1, 1);
  is(1.01, 1.1);
  is(9.91, 10);
  is(99.1, 100);
  is(1234, 1300);
  is(1e22, 1e22);
  is(0x1p-1074, 5e-324);
  is(1.61e308, 1.7e308);
  std::mt19937_64 random(1);
  for (int i = 0; i < 20'000; ++i) {
    const double x = std::ldexp(1 + std::generate_canonical<double, 53>(random),
                                static_cast<int>(random() % 2000) - 1000);
    BOOST_TEST_REQUIRE(rounded_up(x) >= x, x);
    BOOST_TEST_REQUIRE(rounded_up(x) <= x * (1.1 + 1e-12), x);
    BOOST_TEST_REQUIRE(rounded_up(rounded_up(x)) == rounded_up(x), x);
  }
}

/// Every subject, shape and family, held to the bounds.
Plan held_to(const std::string& rows) {
  Plan plan;
  plan.shapes = {0, 1, 2, 3};
  plan.cases = 1;
  for (const Subject& subject : built_in_subjects()) plan.subjects.push_back(&subject);
  for (const Family& family : families()) plan.families.push_back(&family);
  plan.bounds = read(rows);
  return plan;
}

BOOST_AUTO_TEST_CASE(only_what_the_bounds_name_is_planned) {
  const auto audits =
      planned(held_to("textbook/float sphere far wrong 0 observed\n"
                      "textbook/* disk rim wrong 0 observed\n"
                      "textbook/double disk rim wrong_t 0 observed\n"));
  Words got;
  for (const Audit& audit : audits)
    got.push_back(audit.subject->name + " " + std::string(shape_names[audit.shape]) + " " +
                  std::string(audit.family->id));
  check(got, {"textbook/float disk rim", "textbook/float sphere far", "textbook/double disk rim",
              "textbook/long_double disk rim"});
  BOOST_TEST(planned(held_to("")).size() > 1000);
}

BOOST_AUTO_TEST_CASE(an_audit_knows_the_strictest_limit_of_its_ulps) {
  const auto audits =
      planned(held_to("textbook/float sphere far wrong 0 max_ulp 9 observed\n"
                      "textbook/* sphere far max_ulp 7 proved\n"
                      "textbook/* sphere far max_ulp 8 observed\n"
                      "textbook/* disk far wrong 0 max_forced 3 observed\n"));
  BOOST_REQUIRE(audits.size() == 6);
  for (const Audit& audit : audits) {
    BOOST_TEST(audit.most_ulps.has_value() == (audit.shape == sphere));
    if (audit.shape == sphere) BOOST_TEST(*audit.most_ulps == 7);
  }
}

}  // namespace
}  // namespace rayaudit
