#include "audit/cost.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <deque>
#include <map>
#include <string>

#include "audit/timing.hpp"
#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "tests/audit/named.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t disk = 0, sphere = 1;

using Words = std::vector<std::string>;

/// Nanoseconds a case at a call, counted from 0 with those that warm up.
using Script = std::function<double(int call)>;
Script always(double nanoseconds) {
  return [=](int) { return nanoseconds; };
}

/// Subjects that are right but take as long as they are told to, whatever a clock says.
class Cast {
 public:
  Subject& add(const std::string& name, const Script& script, const Format& format = float_format) {
    Subject subject = (*subject_of("certified/float"));
    subject.name = name;
    subject.format = format;
    const auto calls = std::make_shared<int>(0);
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      subject.timed[shape] = [=](std::span<const Case> cases, std::span<Answer>) {
        return script((*calls)++) * static_cast<double>(cases.size());
      };
    subjects_.push_back(subject);
    return subjects_.back();
  }

  CostPlan plan(std::vector<const Family*> families, std::vector<std::size_t> shapes,
                std::uint64_t cases = 100) const {
    CostPlan plan = {{}, std::move(families), std::move(shapes), cases, 3, 3, 2};
    for (const Subject& subject : subjects_) plan.subjects.push_back(&subject);
    return plan;
  }

 private:
  std::deque<Subject> subjects_;
};

/// A subject that says miss to everything.
void blind(Subject& subject) {
  for (auto& answer : subject.answer)
    answer = [](std::span<const Case>, std::span<Answer> answers) {
      std::ranges::fill(answers, Answer::miss());
    };
}

std::string title(const Cell& cell) {
  return std::string(shape_names[cell.shape]) + ' ' + std::string(name(cell.scope)) +
         (cell.family != nullptr ? ' ' + std::string(cell.family->id) : "");
}

Words names(const std::vector<const Way*>& ways) {
  Words names;
  for (const Way* way : ways) names.push_back(way->subject->name);
  return names;
}
Words names(const Cell& cell) {
  Words names;
  for (const Way& way : cell.ways) names.push_back(way.subject->name);
  return names;
}

void check(const Words& got, const Words& wanted) {
  BOOST_TEST(got == wanted, boost::test_tools::per_element());
}

const Cell& cell_of(const Cost& cost, const std::string& wanted) {
  const auto found = std::ranges::find(cost.cells, wanted, title);
  BOOST_TEST_REQUIRE((found != cost.cells.end()), wanted);
  return *found;
}
const Way& way_of(const Cell& cell, const std::string& subject) {
  const auto found =
      std::ranges::find_if(cell.ways, [&](const Way& way) { return way.subject->name == subject; });
  BOOST_TEST_REQUIRE((found != cell.ways.end()), subject);
  return *found;
}

/// Ways made by hand: how long they take, how often they are wrong and how far off they are.
class HandMadeWays {
 public:
  void add(const std::string& name, const Spread& nanoseconds, std::uint64_t wrong,
           double error = 1) {
    subjects_.push_back({name, float_format, {}});
    Way way = {&subjects_.back(), {}, nanoseconds, 100, {}};
    way.rounds = {nanoseconds.low, nanoseconds.median, nanoseconds.high};
    way.accuracy.cases = 1000;
    way.accuracy.wrong = wrong;
    way.accuracy.error = error;
    cell_.ways.push_back(way);
  }
  void add(const std::string& name, double nanoseconds, std::uint64_t wrong, double error = 1) {
    add(name, {nanoseconds, nanoseconds, nanoseconds}, wrong, error);
  }
  Cell& marked() {
    mark_front(cell_.ways);
    return cell_;
  }

 private:
  std::deque<Subject> subjects_;
  Cell cell_ = {sphere, Scope::all, nullptr, {}};
};

}  // namespace

BOOST_AUTO_TEST_CASE(what_another_is_faster_and_more_accurate_than_is_not_on_the_front) {
  HandMadeWays ways;
  ways.add("exact", 1000, 0);
  ways.add("poor and dear", 500, 90);
  ways.add("good", 100, 3);
  ways.add("fast", 10, 50);
  check(names(ways.marked().front()), {"fast", "good", "exact"});
}

BOOST_AUTO_TEST_CASE(of_ways_as_accurate_the_faster_one_is_on_the_front) {
  HandMadeWays ways;
  ways.add("slow", 100, 0);
  ways.add("fast", 50, 0);
  ways.add("also slow", 70, 0, 1.2);
  check(names(ways.marked().front()), {"fast"});
}

BOOST_AUTO_TEST_CASE(of_ways_whose_times_overlap_the_more_accurate_one_is_on_the_front) {
  HandMadeWays ways;
  ways.add("wrong", {80, 90, 120}, 5);
  ways.add("right", {100, 110, 130}, 0);
  check(names(ways.marked().front()), {"right"});
}

BOOST_AUTO_TEST_CASE(what_is_faster_by_less_than_ten_per_cent_is_not_faster) {
  HandMadeWays ways;
  ways.add("wrong", 95, 5);
  ways.add("right", 100, 0);
  check(names(ways.marked().front()), {"right"});
}

BOOST_AUTO_TEST_CASE(a_chain_of_small_gains_adds_up) {
  HandMadeWays ways;
  ways.add("first", 93, 20);
  ways.add("second", 100, 10);
  ways.add("third", 107, 0);
  check(names(ways.marked().front()), {"first", "third"});
}

BOOST_AUTO_TEST_CASE(what_a_more_accurate_way_is_faster_than_is_not_on_the_front) {
  HandMadeWays ways;
  ways.add("slow and right", 120, 0);
  // Not clearly faster than that, for its times overlap; yet faster than what is wrong more often.
  ways.add("unsteady", {90, 100, 125}, 10);
  ways.add("wrong", 105, 200);
  check(names(ways.marked().front()), {"slow and right"});
}

BOOST_AUTO_TEST_CASE(what_is_more_accurate_by_chance_alone_is_not_on_the_front) {
  HandMadeWays ways;
  ways.add("right", 1000, 0);
  ways.add("one less wrong", 100, 299);
  ways.add("fast", 10, 300);
  check(names(ways.marked().front()), {"fast", "right"});
  ways.add("half the error", 110, 299, 0.5);
  check(names(ways.marked().front()), {"fast", "half the error", "right"});
}

BOOST_AUTO_TEST_CASE(marks_of_an_earlier_front_are_taken_away) {
  HandMadeWays ways;
  ways.add("slow", 100, 0);
  ways.add("fast", 50, 0);
  ways.marked().ways[0].on_front = true;
  check(names(ways.marked().front()), {"fast"});
}

BOOST_AUTO_TEST_CASE(a_step_leads_to_the_next_on_the_front_and_its_price_is_taken_round_by_round) {
  HandMadeWays ways;
  ways.add("right", {40, 60, 90}, 0);
  ways.add("wrong", {10, 20, 20}, 9);
  ways.add("best of all but slow", {400, 600, 900}, 0, 1e-3);
  const std::vector<Step> steps = ways.marked().steps();
  BOOST_TEST_REQUIRE(steps.size() == 2u);
  check(names({steps[0].from, steps[0].to, steps[1].from, steps[1].to}),
        {"wrong", "right", "right", "best of all but slow"});
  // 40 / 10, 60 / 20, 90 / 20: not 60 / 20 between the medians alone.
  BOOST_TEST(steps[0].times.low == 3.5);
  BOOST_TEST(steps[0].times.median == 4);
  BOOST_TEST(steps[0].times.high == 4.25);
  BOOST_TEST(steps[1].times.median == 10);
}

BOOST_AUTO_TEST_CASE(one_way_alone_is_the_front_and_no_way_is_none) {
  HandMadeWays ways;
  BOOST_TEST(ways.marked().front().empty());
  ways.add("alone", 1, 1000, Accuracy::unmeasured);
  check(names(ways.marked().front()), {"alone"});
  BOOST_TEST(ways.marked().steps().empty());
}

BOOST_AUTO_TEST_CASE(the_round_that_warms_up_does_not_count) {
  Cast cast;
  cast.add("planted", [](int call) { return call == 0 ? 1e6 : 10.0 * call; });
  const Cost cost = measure(cast.plan({family_of("anywhere")}, {sphere}));
  const Way& way = cell_of(cost, "sphere family anywhere").ways.at(0);
  const std::vector<double> wanted = {10, 20, 30};
  BOOST_TEST(way.rounds == wanted, boost::test_tools::per_element());
  BOOST_TEST(way.nanoseconds.low == 15);
  BOOST_TEST(way.nanoseconds.median == 20);
  BOOST_TEST(way.nanoseconds.high == 25);
}

BOOST_AUTO_TEST_CASE(each_round_begins_with_another_subject) {
  Cast cast;
  std::string order;
  for (const char* name : {"a", "b", "c"})
    cast.add(name, [&order, name](int) { return order += name, 1.0; });
  CostPlan plan = cast.plan({family_of("anywhere")}, {sphere});
  plan.rounds = 4;
  measure(plan);
  // What only reads and writes goes round with them, in the last place.
  BOOST_TEST(order == "abcbcacababcabc");
}

BOOST_AUTO_TEST_CASE(a_dear_subject_is_asked_the_next_few_of_the_cases_in_each_round) {
  Subject subject = (*subject_of("textbook/float"));
  std::vector<Case> cases(10);
  draw(*family_of("anywhere"), sphere, float_format, {}, 1, 0, cases);
  std::vector<std::ptrdiff_t> begins;
  subject.timed[sphere] = [&](std::span<const Case> asked, std::span<Answer> answers) {
    BOOST_TEST(asked.size() == 4u);
    BOOST_TEST(answers.size() == 4u);
    begins.push_back(asked.data() - cases.data());
    return 8.0;
  };
  const Course course = {&subject, cases, 4};
  const auto times = timed({&course, 1}, 3, {});
  // The first few twice, for they warm it up; two are left over and never asked.
  const std::vector<std::ptrdiff_t> wanted = {0, 0, 4, 0};
  BOOST_TEST(begins == wanted, boost::test_tools::per_element());
  for (const double round : times[0]) BOOST_TEST(round == 2);
}

BOOST_AUTO_TEST_CASE(a_subject_without_a_clock_of_its_own_is_timed_here) {
  Subject subject = (*subject_of("textbook/float"));
  std::vector<Case> cases(10);
  draw(*family_of("anywhere"), sphere, float_format, {}, 1, 0, cases);
  int batches = 0;
  subject.answer[sphere] = [&](std::span<const Case> asked, std::span<Answer> answers) {
    BOOST_TEST(asked.size() == 10u);
    BOOST_TEST(answers.size() == 10u);
    ++batches;
  };
  const Course course = {&subject, cases, cases.size()};
  const auto times = timed({&course, 1}, 3, {});
  BOOST_TEST(batches == 4);
  BOOST_TEST_REQUIRE(times[0].size() == 3u);
  for (const double round : times[0]) BOOST_TEST(round >= 0);
}

BOOST_AUTO_TEST_CASE(of_each_shape_the_sums_come_first_then_its_families) {
  Cast cast;
  cast.add("planted", always(1));
  const auto plan = cast.plan({family_of("anywhere"), family_of("grazing"), family_of("tangent")},
                              {sphere, disk});
  Words titles;
  for (const Cell& cell : measure(plan).cells) titles.push_back(title(cell));
  check(titles, {"sphere all", "sphere easy", "sphere hard", "sphere family anywhere",
                 "sphere family grazing", "sphere family tangent", "disk all", "disk easy",
                 "disk hard", "disk family anywhere", "disk family grazing"});
  titles.clear();
  for (const Cell& cell : measure(cast.plan({family_of("tangent")}, {sphere, disk})).cells)
    titles.push_back(title(cell));
  check(titles, {"sphere all", "sphere hard", "sphere family tangent"});
}

BOOST_AUTO_TEST_CASE(a_sum_takes_each_family_alike_round_by_round) {
  // Four calls a family: one that warms up, then rounds.
  const auto script = [](int call) {
    const int family = call / 4, round = call % 4;
    return 100.0 * (family + 1) + 10 * round;
  };
  Cast cast;
  cast.add("planted", script);
  const Cost cost = measure(cast.plan(
      {family_of("anywhere"), family_of("grazing"), family_of("tangent")}, {sphere, disk}));
  const auto check_rounds = [&](const std::string& cell, double base, std::size_t families) {
    const Way& way = cell_of(cost, cell).ways.at(0);
    const std::vector<double> wanted = {base + 10, base + 20, base + 30};
    BOOST_TEST_CONTEXT(cell) {
      BOOST_TEST(way.rounds == wanted, boost::test_tools::per_element());
      BOOST_TEST(way.nanoseconds.median == base + 20);
      BOOST_TEST(way.timed == 100 * families);
    }
  };
  check_rounds("sphere family anywhere", 100, 1);
  check_rounds("sphere family grazing", 200, 1);
  check_rounds("sphere family tangent", 300, 1);
  check_rounds("sphere all", 200, 3);
  check_rounds("sphere easy", 100, 1);
  check_rounds("sphere hard", 250, 2);
  check_rounds("disk all", 450, 2);
  check_rounds("disk easy", 400, 1);
  check_rounds("disk hard", 500, 1);
}

BOOST_AUTO_TEST_CASE(verdicts_are_those_of_an_audit_of_cases_drawn_as_floats_and_sums_add_them) {
  Cast cast;
  blind(cast.add("blind/double", always(1), double_format));
  const auto plan = cast.plan({family_of("anywhere"), family_of("grazing")}, {sphere}, 1500);
  const Cost cost = measure(plan);
  std::uint64_t wrong = 0;
  for (const Family* family : plan.families) {
    const Tally tally = run({.subjects = plan.subjects,
                             .families = {family},
                             .shapes = {sphere},
                             .cases = 1500,
                             .seed = plan.seed,
                             .drawn_in = float_format})
                            .at(0)
                            .tally;
    const auto cell = "sphere family " + std::string(family->id);
    const Accuracy& accuracy = cell_of(cost, cell).ways.at(0).accuracy;
    BOOST_TEST(accuracy.cases == 1500u);
    BOOST_TEST(accuracy.verdicts == tally.verdicts, boost::test_tools::per_element());
    BOOST_TEST(accuracy.wrong > 100u);
    BOOST_TEST(accuracy.wrong_margin == tally.widest()->severity);
    wrong += accuracy.wrong;
  }
  const Accuracy& sum = cell_of(cost, "sphere all").ways.at(0).accuracy;
  BOOST_TEST(sum.cases == 3000u);
  BOOST_TEST(sum.wrong == wrong);
  BOOST_TEST(cell_of(cost, "sphere hard").ways.at(0).accuracy.wrong ==
             cell_of(cost, "sphere family grazing").ways.at(0).accuracy.wrong);
}

BOOST_AUTO_TEST_CASE(the_front_is_marked_in_every_cell) {
  Cast cast;
  cast.add("right", always(100));
  blind(cast.add("blind", always(10)));
  blind(cast.add("blind and slow", always(1000)));
  const Cost cost = measure(cast.plan({family_of("anywhere"), family_of("grazing")}, {sphere}));
  BOOST_TEST(cost.cells.size() == 5u);
  for (const Cell& cell : cost.cells) check(names(cell.front()), {"blind", "right"});
}

BOOST_AUTO_TEST_CASE(the_price_of_hard_cases_is_told_by_rounds_for_each_way_of_a_shape) {
  Cast cast;
  cast.add("dearer", [](int call) { return call < 4 ? 10.0 : 25.0 + (call == 5 ? 5 : 0); });
  cast.add("the same", always(7));
  const Cost cost = measure(cast.plan({family_of("anywhere"), family_of("grazing")}, {sphere}));
  const std::vector<Price> prices = cost.prices(sphere);
  BOOST_TEST_REQUIRE(prices.size() == 2u);
  BOOST_TEST(prices[0].easy->subject->name == "dearer");
  BOOST_TEST(prices[0].hard->subject->name == "dearer");
  BOOST_TEST(prices[0].times.low == 2.5);
  BOOST_TEST(prices[0].times.median == 2.5);
  BOOST_TEST(prices[0].times.high == 2.75);
  BOOST_TEST(prices[1].times.median == 1);
  BOOST_TEST(cost.prices(disk).empty());
  BOOST_TEST(measure(cast.plan({family_of("anywhere")}, {sphere})).prices(sphere).empty());
}

BOOST_AUTO_TEST_CASE(a_dear_subject_is_asked_fewer_cases_but_not_too_few) {
  Subject subject;
  CostPlan plan;
  const auto check_counts = [&](std::uint64_t cases, int dear, std::uint64_t judged,
                                std::size_t timed) {
    plan.cases = cases;
    subject.dear = dear;
    BOOST_TEST_CONTEXT(cases << " cases, " << dear << " times as dear") {
      BOOST_TEST(judged_cases(plan, subject) == judged);
      BOOST_TEST(timed_cases(plan, subject) == timed);
    }
  };
  check_counts(4096, 1, 4096, 1024);
  check_counts(4096, 2, 4096, 1024);
  check_counts(4096, 4, 4096, 512);
  check_counts(4096, 50, 4096, 40);
  check_counts(4096, 100, 2048, 20);
  check_counts(4096, 100'000, 64, 16);
  check_counts(100, 100, 64, 16);
  check_counts(8, 100, 8, 8);
  check_counts(1'000'000'000, 1, 1'000'000'000, 1024);
}

BOOST_AUTO_TEST_CASE(every_way_is_told_by_how_many_cases_it_was_measured) {
  Cast cast;
  cast.add("cheap", always(1));
  Subject& dear = cast.add("dear", always(100));
  dear.dear = 100;
  dear.timed[sphere] = [](std::span<const Case> cases, std::span<Answer> answers) {
    BOOST_TEST(cases.size() == 20u);
    BOOST_TEST(answers.size() == 20u);
    return 2000.0;
  };
  const Cost cost = measure(cast.plan({family_of("anywhere")}, {sphere}, 1000));
  const Cell& cell = cell_of(cost, "sphere family anywhere");
  BOOST_TEST(way_of(cell, "cheap").timed == 1000u);
  BOOST_TEST(way_of(cell, "cheap").accuracy.cases == 1000u);
  BOOST_TEST(way_of(cell, "dear").timed == 20u);
  BOOST_TEST(way_of(cell, "dear").accuracy.cases == 500u);
  // Of fewer cases, what is told is told a case.
  BOOST_TEST(way_of(cell, "dear").nanoseconds.median == 100);
}

BOOST_AUTO_TEST_CASE(every_format_is_asked_the_very_same_cases_drawn_as_floats) {
  Cast cast;
  std::map<std::string, std::vector<Case>> timed_on, judged_by;
  for (const Format& format : {float_format, double_format, long_double_format, float128_format}) {
    const std::string name(format.name);
    Subject& subject = cast.add(name, always(1), format);
    subject.timed[sphere] = [&timed_on, name](std::span<const Case> cases, std::span<Answer>) {
      timed_on[name].assign(cases.begin(), cases.end());
      return 1.0;
    };
    subject.answer[sphere] = [&judged_by, name, answer = subject.answer[sphere]](
                                 std::span<const Case> cases, std::span<Answer> answers) {
      judged_by[name].insert(judged_by[name].end(), cases.begin(), cases.end());
      answer(cases, answers);
    };
  }
  CostPlan plan = cast.plan({family_of("grazing")}, {sphere}, 200);
  plan.threads = 1;
  measure(plan);
  std::vector<Case> drawn(200);
  draw(*family_of("grazing"), sphere, float_format, {}, plan.seed, 0, drawn);
  for (Case& question : drawn)
    each_number(question, [&](double x) { BOOST_TEST(x == static_cast<float>(x)); });
  for (const Subject* subject : plan.subjects) {
    BOOST_TEST((timed_on.at(subject->name) == drawn), subject->name);
    BOOST_TEST((judged_by.at(subject->name) == drawn), subject->name);
  }
}

BOOST_AUTO_TEST_CASE(a_subject_that_cannot_be_timed_is_named_and_the_others_are_measured) {
  Cast cast;
  cast.add("first", always(10));
  int asked = 0;
  // Its rounds on the first family are whole; on the second it breaks off, on one of several.
  cast.add("breaks", [&asked](int call) -> double {
    asked = call;
    if (call == 6) throw NoAnswer("it broke off");
    return 5;
  });
  cast.add("last", always(20));
  const Cost cost = measure(cast.plan(
      {family_of("anywhere"), family_of("grazing"), family_of("tangent")}, {sphere, disk}));
  BOOST_TEST_REQUIRE(cost.untimed.size() == 1u);
  BOOST_TEST(cost.untimed[0].subject->name == "breaks");
  BOOST_TEST(cost.untimed[0].why == "it broke off");
  BOOST_TEST(asked == 6, "it was asked again");
  BOOST_TEST(cost.cells.size() == 11u);
  for (const Cell& cell : cost.cells) {
    check(names(cell), {"first", "last"});
    for (const Way& way : cell.ways) BOOST_TEST(way.rounds.size() == 3u, title(cell));
    BOOST_TEST(way_of(cell, "first").nanoseconds.median == 10);
    BOOST_TEST(way_of(cell, "last").nanoseconds.median == 20);
    BOOST_TEST(way_of(cell, "last").accuracy.wrong == 0u);
  }
  for (const Price& price : cost.prices(sphere)) BOOST_TEST(price.times.median == 1);
}

BOOST_AUTO_TEST_CASE(a_subject_that_needs_too_long_for_a_batch_is_not_timed) {
  Cast cast;
  cast.add("slow", [](int call) { return call == 2 ? 3e7 : 1; });
  cast.add("slow but not too", always(1.9e7));
  const Cost cost = measure(cast.plan({family_of("anywhere")}, {sphere}));
  BOOST_TEST_REQUIRE(cost.untimed.size() == 1u);
  BOOST_TEST(cost.untimed[0].why == "slow needs too long: 3 s for 100 cases");
  check(names(cell_of(cost, "sphere all")), {"slow but not too"});
}

BOOST_AUTO_TEST_CASE(where_no_subject_can_be_timed_all_are_named_and_no_cell_is_left) {
  Cast cast;
  for (const char* name : {"one", "other"})
    cast.add(name, [](int) -> double { throw NoAnswer("it is not there"); });
  const Cost cost = measure(cast.plan({family_of("anywhere"), family_of("grazing")}, {sphere}));
  BOOST_TEST(cost.cells.empty());
  BOOST_TEST_REQUIRE(cost.untimed.size() == 2u);
  BOOST_TEST(cost.untimed[0].subject->name == "one");
  BOOST_TEST(cost.untimed[1].subject->name == "other");
}

BOOST_AUTO_TEST_CASE(subjects_that_break_off_while_judged_harm_no_other) {
  const auto plan_of = [](const Cast& cast) {
    return cast.plan({family_of("anywhere"), family_of("grazing")}, {sphere, disk}, 3000);
  };
  const auto add_sound = [](Cast& cast, const std::string& name) {
    Subject& subject = cast.add(name, always(1));
    for (std::size_t shape : {sphere, disk})
      subject.answer[shape] = (*subject_of("textbook/float")).answer[shape];
  };
  const auto add_broken = [](Cast& cast, const std::string& name) {
    for (auto& answer : cast.add(name, always(1)).answer)
      answer = [name](std::span<const Case>, std::span<Answer>) {
        throw NoAnswer(name + " broke");
      };
  };
  Cast sound;
  add_sound(sound, "a"), add_sound(sound, "c"), add_sound(sound, "e");
  const Cost alone = measure(plan_of(sound));
  Cast cast;
  add_sound(cast, "a"), add_broken(cast, "b"), add_sound(cast, "c"), add_broken(cast, "d");
  add_sound(cast, "e");
  for (const int threads : {1, 4}) {
    CostPlan plan = plan_of(cast);
    plan.threads = threads;
    const Cost cost = measure(plan);
    Words untimed;
    for (const auto& [subject, why] : cost.untimed) untimed.push_back(subject->name + ": " + why);
    std::ranges::sort(untimed);
    check(untimed, {"b: b broke", "d: d broke"});
    BOOST_TEST_REQUIRE(cost.cells.size() == alone.cells.size());
    for (std::size_t i = 0; i < cost.cells.size(); ++i) {
      check(names(cost.cells[i]), {"a", "c", "e"});
      for (std::size_t j = 0; j < 3; ++j) {
        const Accuracy &here = cost.cells[i].ways[j].accuracy,
                       &there = alone.cells[i].ways[j].accuracy;
        BOOST_TEST(here.cases == there.cases);
        BOOST_TEST(here.verdicts == there.verdicts, boost::test_tools::per_element());
        BOOST_TEST(here.ulps == there.ulps);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(what_no_subject_answers_or_no_family_draws_leaves_no_cell) {
  Cast cast;
  cast.add("planted", always(1)).answer[disk] = nullptr;
  const Cost cost = measure(cast.plan({family_of("tangent"), family_of("anywhere")}, {disk}));
  BOOST_TEST(cost.cells.empty());
  BOOST_TEST(cost.untimed.empty());
}

BOOST_AUTO_TEST_CASE(progress_rises_to_the_end) {
  Cast cast;
  cast.add("cheap", always(1));
  cast.add("dear", always(1)).dear = 100;
  CostPlan plan = cast.plan({family_of("anywhere"), family_of("grazing")}, {sphere, disk}, 1000);
  plan.threads = 1;
  Progress last = {0, 0};
  measure(plan, [&](const Progress& progress) {
    BOOST_TEST(progress.done >= last.done);
    BOOST_TEST(progress.done <= progress.all);
    last = progress;
  });
  BOOST_TEST(last.all == 2u * 4u * (1000u + 500u));
  BOOST_TEST(last.done == last.all);
}
