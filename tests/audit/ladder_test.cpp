#include "audit/ladder.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <deque>
#include <string>

#include "geometry/case_line.hpp"
#include "reports/report.hpp"
#include "tests/audit/named.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2;

/// A ray to the unit sphere, hit at t = 1. Its range tells k, and changes nothing.
Case at_difficulty(Random&, const Format&, int k) {
  return {{{0, 0, -2}, {0, 0, 1}, 0, 1024.0 + k}, Sphere<double>{{0, 0, 0}, 1}};
}
/// Of cases of other families, none of its own.
int difficulty_of(const Case& question) {
  return static_cast<int>(std::fmin(question.ray.t_max, 2e6)) - 1024;
}

const Family planted_family = {"planted",
                               "the same case at every k",
                               Strength::anywhere,
                               Difficulty{1, 20, 30, "k itself"},
                               {nullptr, at_difficulty, nullptr, nullptr}};

/// A subject that answers cases of the planted family by their difficulty.
Subject planted(const Format& format, const std::function<Answer(int k)>& answer) {
  Subject subject = {"planted/" + std::string(format.name), format, {}};
  subject.answer[sphere] = [=](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = answer(difficulty_of(cases[i]));
  };
  return subject;
}

/// A hit that is off by so many ulps of the format.
Answer off_by(double ulps, const Format& format) {
  return Answer::hit(real(1 + ulps * std::ldexp(2.0, format.unit_exponent())));
}
Answer right() { return Answer::hit(real(1.0)); }

LadderPlan plan_of(std::vector<const Subject*> subjects, std::uint64_t cases = 32) {
  return {.subjects = std::move(subjects),
          .family = &planted_family,
          .shapes = {disk, sphere, cylinder},
          .cases = cases,
          .seed = 1,
          .bounds = {}};
}

/// As a file would have it, were the planted names known.
Bound row(const std::string& subject, const std::string& shape, const std::string& family,
          const std::vector<std::pair<std::string_view, double>>& limits, int line = 1) {
  Bound bound = {subject, shape, family, {}, false, "mine.txt:" + std::to_string(line)};
  for (const auto& [name, most] : limits)
    bound.limits.push_back({&*std::ranges::find(quantities(), name, &Quantity::name), most});
  return bound;
}

Climb climbed(const Subject& subject, const std::vector<Bound>& bounds = {},
              std::uint64_t cases = 32) {
  LadderPlan plan = plan_of({&subject}, cases);
  plan.bounds = bounds;
  const std::vector<Climb> climbs = climb(plan);
  BOOST_TEST_REQUIRE(climbs.size() == 1u);
  return climbs[0];
}

std::vector<int> rungs_from(int least, int most) {
  const Family family = {"", "", Strength::anywhere, Difficulty{least, most, most, ""}, {}};
  return rungs_of(family, float_format);
}

void check(const std::vector<int>& got, const std::vector<int>& wanted) {
  BOOST_TEST(got == wanted, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_rungs_lead_from_the_least_difficulty_to_the_last_of_the_format) {
  check(rungs_from(3, 7), {3, 4, 5, 6, 7});
  check(rungs_from(5, 5), {5});
  for (const Family& family : families()) {
    if (!family.difficulty) continue;
    const auto& [least, most_float, most_double, about] = *family.difficulty;
    BOOST_TEST_CONTEXT(family.id) {
      BOOST_TEST(rungs_of(family, float_format).front() == least);
      BOOST_TEST(rungs_of(family, float_format).back() == most_float);
      BOOST_TEST(rungs_of(family, double_format).front() == least);
      BOOST_TEST(rungs_of(family, double_format).back() == most_double);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_long_ladder_has_even_steps_and_no_more_rungs_than_the_most) {
  for (int most = 0; most < 1200; ++most) {
    const std::vector<int> rungs = rungs_from(0, most);
    BOOST_TEST(rungs.size() <= static_cast<std::size_t>(most_rungs), most);
    BOOST_TEST(rungs.back() == most);
    BOOST_TEST((most >= most_rungs || rungs.size() == static_cast<std::size_t>(most + 1)), most);
    for (std::size_t i = 2; i < rungs.size(); ++i) {
      const int step = rungs[1] - rungs[0], here = rungs[i] - rungs[i - 1];
      BOOST_TEST((here == step || (i + 1 == rungs.size() && here > 0 && here < step)), most);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_subject_is_asked_each_difficulty_of_its_format_and_no_other) {
  const Subject in_float = planted(float_format, [](int) { return right(); });
  const Subject in_double = planted(double_format, [](int) { return right(); });
  const std::vector<Climb> climbs = climb(plan_of({&in_float, &in_double}, 5));
  BOOST_TEST_REQUIRE(climbs.size() == 2u);
  for (const Climb& climb : climbs) {
    BOOST_TEST(climb.shape == sphere);
    const int most = climb.subject == &in_float ? 20 : 30;
    BOOST_TEST_REQUIRE(climb.rungs.size() == static_cast<std::size_t>(most));
    for (int k = 1; k <= most; ++k) {
      BOOST_TEST(climb.rungs[k - 1].k == k);
      BOOST_TEST(climb.rungs[k - 1].cases == 5u);
    }
  }
}

BOOST_AUTO_TEST_CASE(a_subject_that_fails_from_a_difficulty_on_holds_to_the_one_before) {
  const Subject subject =
      planted(float_format, [](int k) { return k < 10 ? right() : Answer::miss(); });
  const Climb climb = climbed(
      subject, {row("planted/*", "sphere", "planted", {{"max_ulp", 1}, {"false_miss", 3}})});
  BOOST_TEST(climb.held_to.size() == 1u);
  BOOST_TEST(climb.held_to[0].place == "mine.txt:1");
  BOOST_TEST(climb.holds_to().value() == 9);
  const Break& broken = climb.broken.value();
  BOOST_TEST(broken.k == 10);
  BOOST_TEST(broken.limit.quantity->name == "false_miss");
  BOOST_TEST(broken.limit.most == 3);
  BOOST_TEST(broken.seen == 32);
  BOOST_TEST(broken.bound.place == "mine.txt:1");
  const Worst& worst = broken.worst.value();
  BOOST_TEST(difficulty_of(worst.question) == 10, case_line(worst.question));
  BOOST_TEST((worst.answer == Answer::miss()));
  BOOST_TEST(climb.rungs[8].wrong == 0u);
  BOOST_TEST(climb.rungs[9].wrong == 32u);
  BOOST_TEST(climb.rungs.back().wrong == 32u);
}

BOOST_AUTO_TEST_CASE(a_subject_that_recovers_has_not_held) {
  const Subject subject =
      planted(float_format, [](int k) { return k == 10 ? Answer::miss() : right(); });
  BOOST_TEST(climbed(subject).holds_to().value() == 9);
}

BOOST_AUTO_TEST_CASE(a_subject_that_never_fails_holds_to_the_end_and_one_that_always_does_to_none) {
  const Climb sound = climbed(planted(float_format, [](int) { return right(); }));
  BOOST_TEST(!sound.broken.has_value());
  BOOST_TEST(sound.holds_to().value() == 20);
  const Climb blind = climbed(planted(float_format, [](int) { return Answer::miss(); }));
  BOOST_TEST(blind.broken.value().k == 1);
  BOOST_TEST(!blind.holds_to().has_value());
}

BOOST_AUTO_TEST_CASE(an_error_that_doubles_with_each_k_rises_by_one_power_of_two) {
  for (const Format& format : {float_format, double_format}) {
    const Subject subject =
        planted(format, [&](int k) { return off_by(std::ldexp(1.0, std::min(k, 12)), format); });
    // Beyond k = 12 it is flat; a family that ends there shows the rise alone.
    Family family = planted_family;
    family.difficulty = Difficulty{1, 12, 12, ""};
    LadderPlan plan = plan_of({&subject});
    plan.family = &family;
    const Climb climb = rayaudit::climb(plan).at(0);
    BOOST_TEST(std::fabs(climb.slopes.ulps - 1) < 1e-12, climb.slopes.ulps);
    BOOST_TEST(std::fabs(climb.slopes.own - 1) < 1e-12, climb.slopes.own);
    BOOST_TEST(std::fabs(climb.slopes.condition) < 1e-12, climb.slopes.condition);
    BOOST_TEST(climb.rungs[11].ulps.all == 4096);
    BOOST_TEST(climb.rungs[0].ulps.half == 2);
  }
}

BOOST_AUTO_TEST_CASE(an_error_that_stays_has_slope_0_and_one_that_shrinks_a_negative_one) {
  const auto slopes_of = [](const std::function<double(int)>& ulps) {
    return climbed(planted(double_format, [=](int k) { return off_by(ulps(k), double_format); }))
        .slopes;
  };
  BOOST_TEST(std::fabs(slopes_of([](int) { return 3.0; }).ulps) < 1e-12);
  BOOST_TEST(std::fabs(slopes_of([](int) { return 3.0; }).own) < 1e-12);
  const double shrinking = slopes_of([](int k) { return std::ldexp(1.0, 31 - k); }).ulps;
  BOOST_TEST(std::fabs(shrinking + 1) < 1e-12, shrinking);
}

BOOST_AUTO_TEST_CASE(slopes_are_of_half_of_the_hits_and_of_99_in_100_never_of_the_worst) {
  // Of 200 hits one is off by 2^k ulps, a quarter by the root of it, and all others by one.
  Subject subject = planted(double_format, {});
  const auto count = std::make_shared<int>(0);
  subject.answer[sphere] = [=](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const int place = (*count)++ % 200, k = difficulty_of(cases[i]);
      const int power = place == 0 ? k : place % 4 == 1 ? k / 2 : 0;
      answers[i] = off_by(std::ldexp(1.0, power), double_format);
    }
  };
  LadderPlan plan = plan_of({&subject}, 200);
  plan.threads = 1;
  const Climb climb = rayaudit::climb(plan).at(0);
  // Quantiles are an eighth of an octave sharp.
  const Errors last = climb.rungs[29].ulps;
  BOOST_TEST(last.all == 0x1p30);
  BOOST_TEST((last.half >= 1 && last.half < 1.2), last.half);
  BOOST_TEST((last.most >= 0x1p15 && last.most < 0x1.4p15), last.most);
  BOOST_TEST(std::fabs(climb.slopes.ulps) < 0.02, climb.slopes.ulps);
  BOOST_TEST(std::fabs(climb.slopes.own - 0.5) < 0.05, climb.slopes.own);
}

BOOST_AUTO_TEST_CASE(errors_of_few_hits_or_few_rungs_have_no_slope) {
  const Subject doubling = planted(float_format, [](int k) { return off_by(k, float_format); });
  BOOST_TEST(std::isnan(climbed(doubling, {}, 15).slopes.ulps));
  BOOST_TEST(!std::isnan(climbed(doubling, {}, 16).slopes.ulps));
  const auto hits_on = [](int rungs) {
    return climbed(planted(float_format,
                           [=](int k) {
                             return k <= rungs ? off_by(k, float_format) : Answer::miss();
                           }))
        .slopes;
  };
  for (const double slope : {hits_on(2).ulps, hits_on(2).own, hits_on(2).condition})
    BOOST_TEST(std::isnan(slope));
  BOOST_TEST(!std::isnan(hits_on(3).ulps));
}

BOOST_AUTO_TEST_CASE(what_was_never_hit_has_no_errors) {
  const Rung rung = climbed(planted(float_format, [](int) { return Answer::miss(); })).rungs[0];
  for (const Errors& errors : {rung.ulps, rung.forced, rung.own, rung.condition})
    for (const double error : {errors.half, errors.most, errors.all}) BOOST_TEST(std::isnan(error));
  BOOST_TEST(rung.narrow_margin.has_value());
}

BOOST_AUTO_TEST_CASE(the_margin_of_a_rung_is_of_its_cases_and_touches_have_none) {
  const Subject subject = planted(float_format, [](int) { return right(); });
  const Rung rung = climbed(subject).rungs[0];
  // Of this case the margin is of the order of 1, and u is 2^-24.
  BOOST_TEST(rung.narrow_margin.value() > 20);
  BOOST_TEST(rung.narrow_margin.value() <= 24);
  BOOST_TEST(rung.half_margin.value() == rung.narrow_margin.value());
  const auto tangent = [](Random&, const Format&, int) {
    return Case{{{0, 1, -2}, {0, 0, 1}}, Sphere<double>{{0, 0, 0}, 1}};
  };
  Family touching = planted_family;
  touching.draw[sphere] = tangent;
  LadderPlan plan = plan_of({&subject});
  plan.family = &touching;
  BOOST_TEST(!climb(plan).at(0).rungs[0].half_margin.has_value());
}

BOOST_AUTO_TEST_CASE(who_no_bound_speaks_of_is_held_to_the_yardstick) {
  // An own unit is two ulps here: what rounding origin, direction and radius does to t.
  const auto climb_off_by = [](double ulps, const std::vector<Bound>& bounds) {
    return climbed(planted(float_format, [=](int) { return off_by(ulps, float_format); }), bounds);
  };
  const std::vector<std::vector<Bound>> silent = {
      {},
      {row("planted/double", "sphere", "planted", {{"max_ulp", 1}})},
      {row("planted/float", "disk", "planted", {{"max_ulp", 1}})},
      {row("planted/float", "sphere", "other", {{"max_ulp", 1}})}};
  for (const std::vector<Bound>& bounds : silent) {
    const Climb within = climb_off_by(124, bounds), beyond = climb_off_by(132, bounds);
    BOOST_TEST(within.held_to.at(0).place == "");
    BOOST_TEST(!within.broken.has_value());
    BOOST_TEST(beyond.broken.has_value());
  }
  const auto at_most = [](double ulps) {
    return std::vector{row("planted/float", "sphere", "planted", {{"max_ulp", ulps}})};
  };
  BOOST_TEST(!climb_off_by(132, at_most(200)).broken.has_value());
  BOOST_TEST(climb_off_by(124, at_most(100)).broken.has_value());
  BOOST_TEST(climb_off_by(124, at_most(100)).held_to.size() == 1u);
}

BOOST_AUTO_TEST_CASE(the_yardstick_forgives_what_lies_within_sixteen_u_of_another_truth) {
  const Bound bound = yardstick(planted_family);
  BOOST_TEST(bound.family == "planted");
  BOOST_TEST_REQUIRE(bound.limits.size() == 2u);
  BOOST_TEST(bound.limits[0].quantity->name == "max_own");
  BOOST_TEST(bound.limits[0].most == 64);
  BOOST_TEST(bound.limits[1].quantity->name == "wrong_margin");
  BOOST_TEST(bound.limits[1].most == 16);
}

BOOST_AUTO_TEST_CASE(every_bound_about_a_subject_is_held_and_the_first_broken_is_told) {
  const Subject subject = planted(float_format, [](int k) { return off_by(k, float_format); });
  const Climb climb = climbed(subject, {row("*", "sphere", "planted", {{"max_ulp", 12}}, 1),
                                        row("planted/float", "*", "*", {{"max_ulp", 7}}, 2)});
  BOOST_TEST(climb.held_to.size() == 2u);
  BOOST_TEST(climb.broken.value().k == 8);
  BOOST_TEST(climb.broken.value().bound.place == "mine.txt:2");
  BOOST_TEST(climb.broken.value().seen == 8);
}

BOOST_AUTO_TEST_CASE(a_ladder_is_the_same_on_one_thread_and_on_two) {
  LadderPlan plan = {.subjects = {subject_of("textbook/float"), subject_of("certified/double")},
                     .family = family_of("grazing"),
                     .shapes = {disk, sphere},
                     .cases = 200,
                     .seed = 5,
                     .bounds = {}};
  const auto written = [&](int threads) {
    plan.threads = threads;
    const std::vector<Climb> climbs = climb(plan);
    BOOST_TEST(climbs.size() == 4u);
    return write_ladder_json({"1.2.3", plan, climbs, {}}, {});
  };
  BOOST_TEST(written(1) == written(2));
}

BOOST_AUTO_TEST_CASE(what_no_subject_answers_leaves_no_climb) {
  const Subject subject = planted(float_format, [](int) { return right(); });
  LadderPlan plan = plan_of({&subject});
  plan.shapes = {disk};
  BOOST_TEST(climb(plan).empty());
}

BOOST_AUTO_TEST_CASE(progress_rises_to_the_end) {
  const Subject in_float = planted(float_format, [](int) { return right(); });
  const Subject in_double = planted(double_format, [](int) { return right(); });
  Progress last = {0, 0};
  climb(plan_of({&in_float, &in_double}, 4), [&](const Progress& progress) {
    BOOST_TEST(progress.done > last.done);
    last = progress;
  });
  BOOST_TEST(last.done == last.all);
  BOOST_TEST(last.all == 4u * (20 + 30));
}
