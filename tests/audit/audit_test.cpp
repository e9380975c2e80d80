#include "audit/audit.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>
#include <string_view>
#include <type_traits>

#include "geometry/case_line.hpp"
#include "tests/audit/named.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2, cone = 3;

Tally told(std::string_view subject, std::size_t shape, std::string_view family,
           std::uint64_t cases = 20'000) {
  const std::vector<Audit> audits = run({.subjects = {subject_of(subject)},
                                         .families = {family_of(family)},
                                         .shapes = {shape},
                                         .cases = cases,
                                         .seed = 1});
  BOOST_REQUIRE(audits.size() == 1u);
  return audits[0].tally;
}

/// Every subject, shape and family.
Plan whole(std::uint64_t cases) {
  Plan plan;
  plan.shapes = {disk, sphere, cylinder, cone};
  plan.cases = cases;
  plan.seed = 7;
  for (const Subject& subject : built_in_subjects()) plan.subjects.push_back(&subject);
  for (const Family& family : families()) plan.families.push_back(&family);
  return plan;
}

/// A few subjects of every format on families of every strength.
Plan part(std::uint64_t cases) {
  return {.subjects = {subject_of("handout/float"), subject_of("textbook/float"),
                       subject_of("stable_quadratic/double"), subject_of("textbook/long_double")},
          .families = {family_of("anywhere"), family_of("tangent"), family_of("grazing"),
                       family_of("invalid")},
          .shapes = {disk, sphere, cone},
          .cases = cases,
          .seed = 7};
}

/// A double by its bits, so that NaN is like itself.
std::string shown(double x) {
  std::string words;
  write(words, x);
  return words;
}

std::string shown(const Worst& worst) {
  std::string line = case_line(worst.question) + ' ';
  write(line, worst.answer);
  const Judgement& judgement = worst.judgement;
  for (const double x :
       {worst.severity, judgement.ulps, judgement.relative, judgement.forced, judgement.distance})
    line += ' ' + shown(x);
  line += ' ' + std::to_string(worst.place) + ' ' + std::string(name(judgement.verdict)) + ' ' +
          std::string(name(judgement.claim)) + ' ' + std::string(name(judgement.side)) + ' ' +
          std::to_string(judgement.crossing);
  return line;
}

std::string shown(const Histogram& histogram) {
  std::string line = std::to_string(histogram.count()) + " to " + shown(histogram.largest());
  for (int i = 0; i <= 64; ++i) line += ' ' + shown(histogram.quantile(i / 64.0));
  return line;
}

/// All that a tally holds, on lines that differ where tallies do.
std::string shown(const Tally& tally) {
  std::string lines = std::to_string(tally.cases) + " by";
  for (const std::uint64_t count : tally.decided_by) lines += ' ' + std::to_string(count);
  const auto add = [&](const auto& counts) {
    lines += '\n';
    for (const std::uint64_t count : counts) lines += ' ' + std::to_string(count);
  };
  add(tally.verdicts), add(tally.sides);
  for (const TouchCount& touch : tally.touches)
    lines += '\n' + std::to_string(touch.taken) + ' ' + std::to_string(touch.passed);
  for (const Histogram* histogram : {&tally.ulps, &tally.forced, &tally.distance})
    lines += '\n' + shown(*histogram);
  for (const Outcome& outcome : tally.outcomes)
    lines += '\n' + std::string(name(outcome.verdict)) + ' ' + std::string(name(outcome.claim)) +
             ' ' + std::to_string(outcome.count) + ' ' + shown(outcome.worst.value());
  return lines + '\n' + (tally.worst_forced ? shown(*tally.worst_forced) : "");
}

std::string title(const Audit& audit) {
  return audit.subject->name + ' ' + std::string(shape_names[audit.shape]) + ' ' +
         std::string(audit.family->id);
}

void require_same(const std::vector<Audit>& some, const std::vector<Audit>& others) {
  BOOST_REQUIRE(some.size() == others.size());
  for (std::size_t i = 0; i < some.size(); ++i) {
    BOOST_TEST(title(some[i]) == title(others[i]));
    BOOST_TEST(shown(some[i].tally) == shown(others[i].tally), title(some[i]));
  }
}

std::uint64_t total(const Tally& tally) {
  std::uint64_t sum = 0;
  for (const std::uint64_t count : tally.verdicts) sum += count;
  return sum;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_tallies_are_the_same_for_any_number_of_threads) {
  for (const std::uint64_t cases : {1u, 127u, 1024u, 5003u}) {
    Plan plan = part(cases);
    plan.threads = 1;
    const std::vector<Audit> alone = run(plan);
    for (const int threads : {2, 3, 0}) {
      plan.threads = threads;
      require_same(alone, run(plan));
    }
  }
}

BOOST_AUTO_TEST_CASE(every_case_is_judged_once) {
  for (const std::uint64_t cases : {1u, 129u, 1023u, 1025u, 3000u})
    for (const Audit& audit : run(part(cases))) {
      BOOST_TEST(audit.tally.cases == cases, title(audit));
      BOOST_TEST(total(audit.tally) == cases, title(audit));
    }
}

BOOST_AUTO_TEST_CASE(every_case_is_decided_or_invalid) {
  for (const Audit& audit : run(whole(600))) {
    const Tally& tally = audit.tally;
    const std::uint64_t invalid =
        tally.of(Verdict::invalid_handled) + tally.of(Verdict::invalid_mishandled);
    BOOST_TEST(tally.decided() + invalid == tally.cases, title(audit));
    BOOST_TEST((invalid == tally.cases) == (audit.family->id == "invalid"), title(audit));
  }
}

BOOST_AUTO_TEST_CASE(an_audit_does_not_depend_on_what_is_audited_beside_it) {
  const Plan plan = part(1500);
  for (const Audit& audit : run(plan)) {
    Plan alone = plan;
    alone.subjects = {audit.subject}, alone.families = {audit.family};
    alone.shapes = {audit.shape};
    const std::vector<Audit> single = run(alone);
    BOOST_REQUIRE(single.size() == 1u);
    const Tally &together = audit.tally, &apart = single[0].tally;
    BOOST_TEST(together.verdicts == apart.verdicts, title(audit));
    BOOST_TEST(together.decided_by == apart.decided_by, title(audit));
    // Of t itself no more is known than 2^-10 ulp.
    BOOST_TEST(std::fabs(together.ulps.largest() - apart.ulps.largest()) <= 0x1p-9, title(audit));
    BOOST_TEST(together.ulps.count() == apart.ulps.count(), title(audit));
  }
}

namespace {

/// A subject that notes the cases it is shown in batches, and says miss.
Subject noting(std::vector<Case>& seen, const Format& format) {
  Subject subject{"noting/" + std::string(format.name), format, {}};
  subject.answer[sphere] = [&seen](std::span<const Case> cases, std::span<Answer> answers) {
    seen.insert(seen.end(), cases.begin(), cases.end());
    for (Answer& answer : answers) answer = Answer::miss();
  };
  return subject;
}

std::vector<Case> shown_to(const Format& format, std::uint64_t cases, std::uint64_t seed = 5) {
  std::vector<Case> seen;
  const Subject subject = noting(seen, format);
  run({.subjects = {&subject},
       .families = {family_of("grazing")},
       .shapes = {sphere},
       .cases = cases,
       .seed = seed,
       .causes = false,  // for which it is asked again
       .threads = 1});
  return seen;
}

bool holds_floats(Case question) {
  bool all = true;
  each_number(question, [&](double x) { all = all && double{static_cast<float>(x)} == x; });
  return all;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_cases_of_a_longer_run_are_those_of_a_shorter) {
  const std::vector<Case> longer = shown_to(double_format, 2500);
  const std::vector<Case> shorter = shown_to(double_format, 1300);
  BOOST_REQUIRE(longer.size() == 2500u);
  BOOST_REQUIRE(shorter.size() == 1300u);
  BOOST_TEST(std::equal(shorter.begin(), shorter.end(), longer.begin()));
}

BOOST_AUTO_TEST_CASE(the_place_of_a_worst_case_tells_where_it_was_drawn) {
  const Plan plan = part(3000);
  for (const Audit& audit : run(plan))
    for (const Outcome& outcome : audit.tally.outcomes) {
      std::vector<Case> chunk(outcome.worst->place % chunk_cases + 1);
      draw(*audit.family, audit.shape, audit.subject->drawn_in(), {}, plan.seed,
           outcome.worst->place / chunk_cases, chunk);
      BOOST_TEST(case_line(chunk.back()) == case_line(outcome.worst->question), title(audit));
    }
}

BOOST_AUTO_TEST_CASE(another_seed_gives_other_cases) {
  BOOST_TEST((shown_to(double_format, 10, 5) != shown_to(double_format, 10, 6)));
  BOOST_TEST((shown_to(double_format, 10, 5) == shown_to(double_format, 10, 5)));
}

BOOST_AUTO_TEST_CASE(every_subject_is_shown_cases_of_its_own_format) {
  for (const Case& question : shown_to(float_format, 1500))
    if (!holds_floats(question)) BOOST_ERROR(case_line(question));
  for (const Format& format : {double_format, long_double_format}) {
    const std::vector<Case> seen = shown_to(format, 1500);
    const auto of_floats = std::count_if(seen.begin(), seen.end(), holds_floats);
    BOOST_TEST(of_floats < 15, format.name);
  }
}

BOOST_AUTO_TEST_CASE(subjects_of_one_format_are_shown_the_same_cases) {
  std::vector<Case> one, other, floats;
  const Subject a = noting(one, double_format), b = noting(other, long_double_format),
                c = noting(floats, float_format);
  run({.subjects = {&a, &b, &c},
       .families = {family_of("anywhere")},
       .shapes = {sphere},
       .cases = 1100,
       .causes = false,
       .threads = 1});
  BOOST_TEST((one == other));
  BOOST_TEST((one != floats));
}

BOOST_AUTO_TEST_CASE(audits_are_planned_by_subject_then_shape_then_family) {
  const Plan plan = whole(1);
  const std::vector<Audit> audits = planned(plan);
  const auto place = [](const auto& list, const auto& item) {
    return std::find(list.begin(), list.end(), item) - list.begin();
  };
  const auto key = [&](const Audit& audit) {
    return std::array{place(plan.subjects, audit.subject), place(plan.shapes, audit.shape),
                      place(plan.families, audit.family)};
  };
  std::size_t fitting = 0;
  for (const Subject* subject : plan.subjects)
    for (const std::size_t shape : plan.shapes)
      for (const Family* family : plan.families)
        fitting += subject->answers(shape) && family->draw[shape] != nullptr ? 1 : 0;
  BOOST_TEST(audits.size() == fitting);
  for (std::size_t i = 1; i < audits.size(); ++i)
    BOOST_TEST((key(audits[i - 1]) < key(audits[i])), title(audits[i]));
  for (const Audit& audit : audits) {
    BOOST_TEST(audit.subject->answers(audit.shape));
    BOOST_TEST(audit.family->draw[audit.shape] != nullptr);
    BOOST_TEST(audit.tally.cases == 0u);
  }
}

BOOST_AUTO_TEST_CASE(nothing_is_planned_where_nothing_fits) {
  const Plan apex_of_a_sphere = {.subjects = {subject_of("textbook/double")},
                                 .families = {family_of("apex")},
                                 .shapes = {sphere},
                                 .cases = 10};
  BOOST_TEST(planned(apex_of_a_sphere).empty());
  BOOST_TEST(run(apex_of_a_sphere).empty());
  const Plan a_shape_not_answered = {.subjects = {subject_of("division_free/double")},
                                     .families = {family_of("anywhere")},
                                     .shapes = {sphere},
                                     .cases = 10};
  BOOST_TEST(planned(a_shape_not_answered).empty());
  BOOST_TEST(planned({}).empty());
}

BOOST_AUTO_TEST_CASE(progress_is_told_up_to_all) {
  for (const int threads : {1, 2, 3}) {
    Plan plan = part(2500);
    plan.threads = threads;
    const std::uint64_t all = planned(plan).size() * plan.cases;
    std::uint64_t most = 0, times = 0;
    run(plan, [&](Progress progress) {
      BOOST_TEST(progress.all == all);
      BOOST_TEST(progress.done <= all);
      BOOST_TEST(progress.done > 0u);
      most = std::max(most, progress.done);
      ++times;
    });
    BOOST_TEST(times > 1u);
    // What two threads have to tell at once is told by one of them.
    if (threads == 1) BOOST_TEST(most == all);
  }
}

BOOST_AUTO_TEST_CASE(a_convention_reaches_the_judge) {
  Plan plan = part(1000);
  plan.families = {family_of("tangent")}, plan.shapes = {sphere};
  std::uint64_t open = 0, refused = 0;
  for (const Audit& audit : run(plan)) open += audit.tally.of(Verdict::touch);
  plan.convention.of(oracle::Kind::tangent) = Convention::Stance::miss;
  for (const Audit& audit : run(plan)) {
    BOOST_TEST(audit.tally.of(Verdict::touch) == 0u);
    refused += audit.tally.of(Claim::declined);
  }
  BOOST_TEST(open == plan.subjects.size() * plan.cases);
  BOOST_TEST(refused > 0u);
}

BOOST_AUTO_TEST_CASE(what_a_subject_declares_is_what_it_is_held_to) {
  Subject declaring = *subject_of("textbook/double");
  declaring.convention.of(oracle::Kind::tangent) = Convention::Stance::miss;
  Plan plan = part(1000);
  plan.subjects = {&declaring, subject_of("textbook/double")};
  plan.families = {family_of("tangent")}, plan.shapes = {sphere};
  const std::vector<Audit> audits = run(plan);
  BOOST_TEST(audits[0].tally.of(Verdict::touch) == 0u);
  BOOST_TEST(audits[0].tally.of(Claim::declined) > 0u);
  BOOST_TEST(audits[1].tally.of(Verdict::touch) == plan.cases);
}

BOOST_AUTO_TEST_CASE(who_takes_unit_directions_only_is_asked_with_such) {
  Subject unit = *subject_of("unit_direction/double");
  unit.convention.unit_direction = true;
  Plan plan = part(2000);
  plan.subjects = {&unit, subject_of("unit_direction/double")};
  plan.families = {family_of("length")}, plan.shapes = {sphere};
  const std::vector<Audit> audits = run(plan);
  BOOST_TEST(audits[0].tally.wrong() < audits[1].tally.wrong() / 4);
  for (const Outcome& outcome : audits[0].tally.outcomes) {
    const auto& [x, y, z] = outcome.worst->question.ray.direction;
    BOOST_TEST(std::fabs(std::hypot(x, y, z) - 1) < 0x1p-51, case_line(outcome.worst->question));
  }
}

BOOST_AUTO_TEST_CASE(shards_that_are_merged_tell_what_one_run_tells) {
  Plan plan = part(5000);
  const std::vector<Audit> whole = gathered(plan);
  std::vector<Audit> merged;
  plan.shards = 3;
  for (plan.shard = 0; plan.shard < plan.shards; ++plan.shard) {
    const std::vector<Audit> shard = gathered(plan);
    if (merged.empty()) merged = shard;
    for (std::size_t i = 0; plan.shard > 0 && i < shard.size(); ++i)
      merged[i].tally.merge(shard[i].tally);
  }
  BOOST_TEST_REQUIRE(merged.size() == whole.size());
  for (std::size_t i = 0; i < whole.size(); ++i) {
    BOOST_TEST(merged[i].tally.cases == whole[i].tally.cases);
    BOOST_TEST((merged[i].tally.verdicts == whole[i].tally.verdicts));
    BOOST_TEST(merged[i].tally.ulps.largest() == whole[i].tally.ulps.largest());
  }
}

BOOST_AUTO_TEST_CASE(a_difficulty_reaches_the_family) {
  Plan plan = part(1000);
  plan.subjects = {subject_of("textbook/float")}, plan.families = {family_of("far")};
  plan.shapes = {sphere};
  plan.difficulty = family_of("far")->difficulty->least;
  const std::uint64_t easy = run(plan)[0].tally.wrong();
  plan.difficulty = family_of("far")->difficulty->most_float;
  BOOST_TEST(run(plan)[0].tally.wrong() > easy + 100);
}

BOOST_AUTO_TEST_CASE(the_handout_takes_parallel_rays_for_hits_on_the_disk) {
  for (const auto name : {"handout/float", "handout/double"}) {
    const Tally tally = told(name, disk, "parallel");
    BOOST_TEST(tally.of(Verdict::false_hit) > tally.cases / 50);
    BOOST_TEST(tally.of(Verdict::right) + tally.of(Verdict::false_hit) == tally.cases);
  }
}

namespace {

/// Is the point of an answer the centre of its sphere?
bool claims_the_centre(const Worst& worst) {
  const auto& centre = std::get<Sphere<double>>(worst.question.shape).centre;
  return worst.answer.point == Vec3<Real>{real(centre.x), real(centre.y), real(centre.z)};
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_handout_reports_misses_of_the_sphere_as_its_centre) {
  for (const auto name : {"handout/float", "handout/double"}) {
    const Tally tally = told(name, sphere, "anywhere");
    BOOST_TEST(tally.of(Verdict::false_hit) > tally.cases / 3);
    BOOST_REQUIRE(tally.worst(Verdict::false_hit) != nullptr);
    BOOST_TEST(claims_the_centre(*tally.worst(Verdict::false_hit)));
  }
}

BOOST_AUTO_TEST_CASE(the_handout_loses_hits_on_the_sphere) {
  for (const auto name : {"handout/float", "handout/double"}) {
    // A lost hit comes back as the centre; only at the world origin is that a miss.
    const Tally elsewhere = told(name, sphere, "anywhere");
    BOOST_TEST(elsewhere.of(Verdict::right) < elsewhere.cases / 20);
    BOOST_TEST(elsewhere.of(Verdict::wrong_t) > elsewhere.cases / 3);
    for (const auto family : {"axis", "lattice"}) {
      const Tally tally = told(name, sphere, family);
      BOOST_TEST(tally.of(Verdict::false_miss) > tally.cases / 20, family);
    }
  }
}

BOOST_AUTO_TEST_CASE(the_textbook_in_float_goes_wrong_at_a_distance) {
  for (const std::size_t shape : {sphere, cylinder, cone}) {
    const Tally tally = told("textbook/float", shape, "far");
    BOOST_TEST(tally.wrong() > tally.cases / 10, shape_names[shape]);
    BOOST_TEST(told("textbook/double", shape, "anywhere").wrong() == 0u, shape_names[shape]);
  }
}

BOOST_AUTO_TEST_CASE(sound_routines_in_double_are_never_wrong_anywhere) {
  for (const auto name : {"closest_approach/double", "stable_quadratic/double"})
    for (const std::size_t shape : {sphere, cylinder, cone}) {
      const Tally tally = told(name, shape, "anywhere");
      for (const Outcome& outcome : tally.outcomes)
        if (is_wrong(outcome.verdict))
          BOOST_ERROR(name << ": " << case_line(outcome.worst->question));
      BOOST_TEST(tally.of(Verdict::right) > tally.cases * 99 / 100);
    }
}

BOOST_AUTO_TEST_CASE(every_wrong_case_that_is_shown_has_its_cause) {
  for (const Audit& audit : run(part(2000)))
    for (const Outcome& outcome : audit.tally.outcomes) {
      if (!is_wrong(outcome.verdict)) continue;
      const Diagnosis& found = outcome.worst->diagnosis;
      BOOST_TEST((found.cause != Cause::unknown && found.cause != Cause::convention),
                 title(audit) << ": " << case_line(outcome.worst->question));
      BOOST_TEST((found.cause == Cause::flip) == found.turned.has_value());
    }
}

BOOST_AUTO_TEST_CASE(a_share_is_replayed_where_much_is_wrong_and_all_where_little_is) {
  Plan plan = part(3 * chunk_cases);
  for (const Audit& audit : run(plan)) {
    const std::uint64_t wrong = audit.tally.wrong(), replayed = audit.tally.causes().replayed();
    BOOST_TEST(replayed <= 3 * replays_a_chunk, title(audit));
    BOOST_TEST(replayed >= std::min<std::uint64_t>(wrong, replays_a_chunk), title(audit));
  }
  plan.thorough = true;
  for (const Audit& audit : run(plan))
    BOOST_TEST(audit.tally.causes().replayed() == audit.tally.wrong(), title(audit));
}

BOOST_AUTO_TEST_CASE(no_certified_verdict_differs_from_the_exact_replay) {
  std::uint64_t compared = 0;
  for (const Audit& audit : run(part(2000))) {
    const Certificate& certificate = audit.tally.certificate;
    compared += certificate.compared;
    BOOST_TEST(certificate.wrong == 0U, title(audit)
                                            << ": "
                                            << (certificate.first_wrong
                                                    ? case_line(certificate.first_wrong->question)
                                                    : ""));
    if (certificate.proved)
      BOOST_TEST(certificate.proved->severity >= certificate.observed->severity, title(audit));
  }
  BOOST_TEST(compared > 1000U);
}

BOOST_AUTO_TEST_CASE(a_subject_is_told_the_same_alone_and_among_others) {
  // Those of a group share the margins of their cases, worked out for whoever asks first.
  Plan plan = {.subjects = {subject_of("unit_direction/double"), subject_of("textbook/double"),
                            subject_of("stable_quadratic/double")},
               .families = {family_of("parallel"), family_of("within-near"), family_of("flat")},
               .shapes = {cylinder},
               .cases = 2500,
               .seed = 3};
  const std::vector<Audit> among = run(plan);
  plan.subjects = {subject_of("stable_quadratic/double")};
  const std::vector<Audit> alone = run(plan);
  BOOST_REQUIRE(alone.size() == 3);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    const Tally &a = alone[i].tally, &b = among[6 + i].tally;
    BOOST_REQUIRE(among[6 + i].subject == alone[i].subject);
    BOOST_TEST(a.wrong() == b.wrong(), title(alone[i]));
    BOOST_TEST(a.causes().counts == b.causes().counts, title(alone[i]));
    for (int exponent = MarginCurve::least; exponent <= MarginCurve::most; ++exponent) {
      BOOST_TEST(a.curve.at(exponent).cases == b.curve.at(exponent).cases, title(alone[i]));
      BOOST_TEST(a.curve.at(exponent).wrong == b.curve.at(exponent).wrong, title(alone[i]));
    }
    BOOST_REQUIRE((a.widest() == nullptr) == (b.widest() == nullptr));
    if (a.widest() != nullptr) BOOST_TEST(a.widest()->place == b.widest()->place);
  }
}

BOOST_AUTO_TEST_CASE(an_error_beyond_what_is_held_is_replayed_too) {
  Plan plan = {.subjects = {subject_of("textbook/float")},
               .families = {family_of("far")},
               .shapes = {cylinder},
               .cases = 1000,
               .seed = 5};
  const auto right_replayed = [&] {
    const std::vector<Audit> audits = run(plan);
    for (const Outcome& outcome : audits[0].tally.outcomes)
      if (outcome.verdict == Verdict::right) return outcome.causes.replayed();
    return std::uint64_t{0};
  };
  plan.thorough = true;
  BOOST_TEST(right_replayed() == 0U);
  plan.bounds = read_bounds("textbook/float cylinder far max_ulp 1 observed", "a file");
  BOOST_TEST(right_replayed() > 0U);
}

BOOST_AUTO_TEST_CASE(a_run_takes_no_memory_for_cases_that_are_not_drawn_yet) {
  struct Stopped {};
  Plan plan = part(1'000'000'000'000'000);
  BOOST_CHECK_THROW(run(plan, [](Progress) { throw Stopped{}; }), Stopped);
}

BOOST_AUTO_TEST_CASE(a_tally_does_not_grow_with_its_cases) {
  static_assert(std::is_trivially_copyable_v<Histogram>);
  static_assert(std::is_trivially_copyable_v<MarginCurve>);
  for (const Audit& audit : run(part(4000))) {
    BOOST_TEST(audit.tally.outcomes.size() <= 2 * claim_count, title(audit));
    // A comparison each, at most, of the routine's lines.
    for (const Outcome& outcome : audit.tally.outcomes)
      BOOST_TEST(outcome.causes.turned.size() <= 20, title(audit));
  }
}
