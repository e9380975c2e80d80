#include "reports/difference.hpp"

#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "geometry/error.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// One audit of 100 cases, wrong in so many of them.
HandMade made(std::uint64_t wrong, Claim claim = Claim::none, double x = 0.3) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  if (wrong > 0) turn(tally, Verdict::false_hit, claim, wrong, x);
  return made;
}

HandMade with_error(double own) {
  HandMade all = made(0);
  Tally& tally = all.audits[0].tally;
  tally.own.add(own);
  tally.worst_own = Worst{own, 0, known_case(own), Answer::hit(real(4.5)), {}, {}};
  return all;
}

Record record(const HandMade& of, const std::string& name) { return record_of(of.run(), name); }

Difference held(const HandMade& before, const HandMade& after) {
  return difference(record(before, "old.json"), record(after, "new.json"));
}

/// The sentence that refuses something.
template <class Act>
std::string refusal(const Act& act) {
  try {
    act();
  } catch (const Error& refused) {
    return refused.what();
  }
  return "not refused";
}

BOOST_AUTO_TEST_CASE(nothing_broke_where_nothing_changed) {
  for (const std::uint64_t wrong : {0, 5}) {
    const Difference same = held(made(wrong), made(wrong));
    BOOST_TEST(same.broke.empty());
    BOOST_TEST(same.fixed.empty());
    BOOST_TEST(same.compared == 1u);
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_more_often_broke_with_the_case_of_the_new_run) {
  for (const std::uint64_t before : {0, 2}) {
    const Difference worse = held(made(before, Claim::none, 0.1), made(5, Claim::none, 0.7));
    BOOST_TEST(worse.fixed.empty());
    BOOST_REQUIRE(worse.broke.size() == 1u);
    const Change& change = worse.broke[0];
    BOOST_TEST(change.what == "false_hit");
    BOOST_TEST(change.before == static_cast<double>(before));
    BOOST_TEST(change.after == 5);
    BOOST_TEST(change.cases == 100u);
    BOOST_TEST(contains(change.line, "0x1.6666666666666p-1 "), change.line);
    BOOST_TEST(change.explain == "rayaudit explain --subject mine/float '" + change.line + "'");
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_less_often_is_fixed_with_the_case_of_the_old_run) {
  for (const std::uint64_t after : {0, 2}) {
    const Difference better = held(made(5, Claim::none, 0.7), made(after, Claim::none, 0.1));
    BOOST_TEST(better.broke.empty());
    BOOST_REQUIRE(better.fixed.size() == 1u);
    BOOST_TEST(contains(better.fixed[0].line, "0x1.6666666666666p-1 "), better.fixed[0].line);
  }
}

BOOST_AUTO_TEST_CASE(a_claim_that_gives_way_to_another_is_fixed_and_broke) {
  const Difference other = held(made(5, Claim::nan), made(5, Claim::behind));
  BOOST_REQUIRE(other.broke.size() == 1u);
  BOOST_REQUIRE(other.fixed.size() == 1u);
  BOOST_TEST(other.broke[0].claim == "behind");
  BOOST_TEST(other.fixed[0].claim == "nan");
}

BOOST_AUTO_TEST_CASE(as_many_but_other_cases_are_told_for_one_of_them_broke) {
  const Difference other = held(made(5, Claim::none, 0.1), made(5, Claim::none, 0.7));
  BOOST_REQUIRE(other.broke.size() == 1u);
  BOOST_REQUIRE(other.fixed.size() == 1u);
  BOOST_TEST(contains(told(other.broke[0]), "in 5 of 100 cases as before, but not the same"));
  HandMade thorough = made(5, Claim::none, 0.7);
  thorough.plan.thorough = true;
  BOOST_TEST(held(made(5, Claim::none, 0.1), thorough).broke.empty());
}

BOOST_AUTO_TEST_CASE(an_error_broke_where_it_is_more_than_twice_what_it_was_and_above_one) {
  const auto broke = [](double before, double after) {
    return held(with_error(before), with_error(after)).broke.size();
  };
  BOOST_TEST(broke(3, 6) == 0u);
  BOOST_TEST(broke(3, 6.5) == 1u);
  BOOST_TEST(broke(0.1, 0.9) == 0u);
  BOOST_TEST(broke(0.1, 1.5) == 1u);
  BOOST_TEST(broke(3, std::numeric_limits<double>::infinity()) == 1u);
  BOOST_TEST(broke(std::numeric_limits<double>::infinity(), 3) == 0u);
  const Difference better = held(with_error(6.5), with_error(3));
  BOOST_TEST(better.broke.empty());
  BOOST_REQUIRE(better.fixed.size() == 1u);
  BOOST_TEST(better.fixed[0].what == "max_own_ulp");
  BOOST_TEST(held(with_error(6), with_error(3)).fixed.empty());
  BOOST_TEST(held(made(0), with_error(7)).broke.empty());
}

/// So many crashes and wrong answers, and so large an error, of so many cases that were asked.
HandMade crashed(std::uint64_t crashes, std::uint64_t wrong, double own, std::uint64_t cases) {
  HandMade all = with_error(own);
  Tally& tally = all.audits[0].tally;
  turn(tally, Verdict::crashed, Claim::none, crashes);
  if (wrong > 0) turn(tally, Verdict::false_hit, Claim::nan, wrong);
  tally.unasked = 100 - cases;
  tally.cases = cases;
  return all;
}

BOOST_AUTO_TEST_CASE(where_not_all_cases_were_asked_crashes_alone_are_compared) {
  const Difference more = held(crashed(3, 0, 1, 100), crashed(16, 9, 50, 40));
  BOOST_TEST(more.partly == 1u);
  BOOST_REQUIRE(more.broke.size() == 1u);
  BOOST_TEST(more.broke[0].what == "crashed");
  BOOST_TEST(more.fixed.empty());
  BOOST_TEST(summary(more) ==
             "1 broke, 0 fixed in 1 audit (1 of them by crashes and time-outs alone: not all cases "
             "were asked)");
  const Difference whole = held(crashed(3, 0, 1, 100), crashed(16, 9, 50, 100));
  BOOST_TEST(whole.partly == 0u);
  BOOST_TEST(whole.broke.size() == 3u);  // the false hits and the error too
  // As many crashes, the worst of them another: of other cases that tells nothing.
  HandMade other = crashed(3, 0, 1, 40);
  other.audits[0].tally.outcome(Verdict::crashed, Claim::none).worst->question = known_case(7);
  BOOST_TEST(held(crashed(3, 0, 1, 100), other).broke.empty());
}

BOOST_AUTO_TEST_CASE(what_is_gone_or_new_is_told_and_is_no_failure) {
  HandMade before = made(0), after = made(0);
  before.add(1, "rim");
  before.add("old/float", 0, "far");
  turn(after.add("new/float", 0, "far"), Verdict::wrong_t, Claim::none, 9);
  const Difference other = held(before, after);
  BOOST_TEST(other.broke.empty());
  BOOST_TEST(other.gone.size() == 2u);
  BOOST_TEST(other.added.size() == 1u);
  const std::string text = write_difference_table(other, {});
  BOOST_TEST(contains(text, "Gone: 2 audits: mine/float (1), old/float (1)\n"), text);
  BOOST_TEST(contains(text,
                      "New: 1 audit, 9 wrong answers in them, held against nothing: new/float "
                      "(1)\n"),
             text);
  BOOST_TEST(contains(text, "\n0 broke, 0 fixed in 1 audit, 2 gone, 1 new\n"), text);
}

BOOST_AUTO_TEST_CASE(a_subject_that_was_renamed_is_held_against_itself) {
  HandMade after = made(5);
  after.subjects[0].name = "yours/float";
  Record before = record(made(2), "old.json");
  rename_subject(before, "mine/float=yours/float");
  const Difference worse = difference(before, record(after, "new.json"));
  BOOST_TEST(worse.broke.size() == 1u);
  BOOST_TEST(worse.gone.empty());
  BOOST_TEST(refusal([&] { rename_subject(before, "min/float=a"); }) ==
             "--map: subject of `old.json` `min/float` is not known; known are `yours/float`");
  BOOST_TEST(refusal([&] { rename_subject(before, "yours/float"); }) ==
             "--map: expected OLD=NEW, got `yours/float`");
  HandMade two = made(2);
  two.add("yours/float", 1, "far");
  Record doubled = record(two, "two.json");
  BOOST_TEST(refusal([&] { rename_subject(doubled, "mine/float=yours/float"); }) ==
             "`two.json` tells of yours/float on sphere, family far twice");
}

BOOST_AUTO_TEST_CASE(runs_of_other_cases_are_refused_with_what_differs) {
  const auto told = [](const auto& change) {
    HandMade other = made(0);
    change(other.plan);
    return refusal([&] { held(made(0), other); });
  };
  const std::string head = "`old.json` and `new.json` cannot be compared: ";
  BOOST_TEST(told([](Plan& plan) { plan.seed = 2; }) ==
             head + "seed 18364758544493064720 there, 2 here");
  BOOST_TEST(told([](Plan& plan) { plan.cases = 99; }) == head + "cases 100 there, 99 here");
  BOOST_TEST(told([](Plan& plan) { plan.difficulty = 7; }) ==
             head + "difficulty null there, 7 here");
  for (const auto change : {+[](Plan& plan) { plan.convention.line = true; },
                            +[](Plan& plan) { plan.convention.t_max = 5; },
                            +[](Plan& plan) { plan.convention.unit_direction = true; },
                            +[](Plan& plan) { plan.convention.inside = Convention::Inside::miss; }})
    BOOST_TEST(told(change).starts_with(head + "convention {"), told(change));
  HandMade declared = made(0);
  declared.subjects[0].convention.line = true;
  BOOST_TEST(refusal([&] { held(made(0), declared); }) ==
             head + "mine/float on sphere, family far declares another convention");
}

BOOST_AUTO_TEST_CASE(cases_that_are_drawn_otherwise_are_told) {
  const Subject* textbook = &built_in_subjects().front();
  const auto of = [&](std::uint64_t seed) {
    HandMade made;
    for (const Family& family : families())
      if (family.id == "far") made.audits.push_back({textbook, &family, 1, {}, {}});
    made.audits[0].tally.cases = 100;
    made.plan.seed = seed;
    Record record = record_of(made.run(), "a.json");
    record.seed = 1;
    return record;
  };
  BOOST_TEST(!of(1).audits[0].drawn.empty());
  BOOST_TEST(refusal([&] { difference(of(1), of(1)); }) == "not refused");
  BOOST_TEST(contains(refusal([&] { difference(of(1), of(2)); }), " was asked other cases"));
}

BOOST_AUTO_TEST_CASE(what_is_no_report_of_an_audit_is_refused) {
  const auto told = [](const std::string& text) {
    return refusal([&] { read_record(text, "a.json"); });
  };
  const std::string whole = write_json(made(3).run(), {});
  BOOST_TEST(told(whole) == "not refused");
  BOOST_TEST(told("") == "`a.json` breaks off after 0 bytes: it is not whole");
  BOOST_TEST(told("hello") == "`a.json` is no JSON at byte 1");
  BOOST_TEST(told(whole.substr(0, 1000)) ==
             "`a.json` breaks off after 1000 bytes: it is not whole");
  BOOST_TEST(told("[1, 2]") == "`a.json` is no report of rayaudit");
  BOOST_TEST(told("{}") == "`a.json` is no report of rayaudit");
  BOOST_TEST(told(R"({"schema": 2, "tool": {}})") ==
             "`a.json` has schema `2`; this program reads schema 1");
  BOOST_TEST(told(R"({"schema": 1, "report": "cost", "tool": {}})") ==
             "`a.json` is a report of `cost`, not of an audit");
  for (const std::string key : {"seed", "audits", "outcomes", "own", "count", "version", "case"}) {
    std::string without = whole;
    without.replace(without.find('"' + key + '"'), key.size() + 2, "\"other\"");
    BOOST_TEST(
        told(without).starts_with("`a.json` is no report of an audit that can be compared ("),
        key << ": " << told(without));
  }
  BOOST_TEST(told(std::string(100'000, '[')).ends_with("it is not whole"));
}

BOOST_AUTO_TEST_CASE(the_table_says_what_broke_with_its_command) {
  const Difference worse = held(made(2, Claim::nan), made(5, Claim::nan, 0.7));
  const std::string text = write_difference_table(worse, {});
  BOOST_TEST(
      text.starts_with("rayaudit 1.2.3: `new.json` held against `old.json`: 100 cases for "
                       "each subject, shape and family; seed 18364758544493064720\n"));
  BOOST_TEST(
      contains(text,
               "\nBroke\n  mine/float on sphere, family far: false_hit (nan) was in 2, is in "
               "5 of 100 cases; cause: unknown\n    rayaudit explain --subject mine/float '"),
      text);
  BOOST_TEST(contains(text, "\n1 broke, 0 fixed in 1 audit\n"), text);
  BOOST_TEST(!contains(text, "Fixed"));
}

BOOST_AUTO_TEST_CASE(the_same_is_told_in_json_and_markdown) {
  const Difference worse = held(made(2, Claim::nan), made(5, Claim::nan, 0.7));
  const auto json = nlohmann::json::parse(write_difference_json(worse, {}));
  BOOST_TEST(json.at("report") == "diff");
  BOOST_TEST(json.at("broke").at(0).at("after") == 5);
  BOOST_TEST(json.at("broke").at(0).at("claim") == "nan");
  BOOST_TEST(json.at("fixed").empty());
  BOOST_TEST(json.at("compared") == 1);
  const std::string markdown = write_difference_markdown(worse, {});
  BOOST_TEST(markdown.starts_with("**rayaudit: 1 broke, 0 fixed in 1 audit**\n\n### Broke\n"),
             markdown);
  BOOST_TEST(contains(markdown, "\nexplain  rayaudit explain --subject mine/float '"), markdown);
  HandMade before, after;
  for (int i = 0; i < 500; ++i) {
    const std::string subject = "subject_" + std::to_string(i) + "/float";
    before.add(subject, 1, "far");
    turn(after.add(subject, 1, "far"), Verdict::false_hit, Claim::nan, 3);
  }
  BOOST_TEST(write_difference_markdown(held(before, after), {.everything = true}).size() <=
             65'535u);
}

}  // namespace
}  // namespace rayaudit
