#include <fmt/format.h>

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cstdlib>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "audit/finding.hpp"
#include "geometry/case_line.hpp"
#include "oracle/replay/replay_of.hpp"
#include "reports/figures.hpp"
#include "routines/closest_approach.hpp"
#include "routines/division_free.hpp"
#include "subjects/certified.hpp"
#include "subjects/subject_of.hpp"
#include "tests/field_defects/flaws.hpp"

/// The flaws of public bug reports, each in a routine of its own, under an audit with its default
/// settings: it finds each, names the cause and gives a minimal case, of a routine that it can
/// replay and of one that it cannot look into.
using namespace rayaudit;

namespace {

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2, cone = 3;

/// What a public thread tells of a flaw, what an audit is to tell, and a routine that has it.
struct Flaw {
  std::string thread, about;
  std::size_t shape = 0;
  std::string family = {};  ///< where it shows, as the thread has it
  Verdict verdict = Verdict::false_miss;
  Claim claim = Claim::none;
  std::string cause = {};                ///< by replay
  std::string from_outside = "unknown";  ///< of a routine that cannot be replayed
  Subject subject = {};
  replay::Replay replay = {};
};

template <class Routine, class N>
Flaw in_routine(Flaw flaw) {
  flaw.subject = subject_of<Routine, N>();
  flaw.replay = replay::replay_made_of<Routine>();
  return flaw;
}

const std::vector<Flaw>& all_flaws() {
  static const std::vector<Flaw> flaws = {
      in_routine<planted::NoParallelCheck, double>(
          {.thread = "the handout",
           .about = "no test for a ray parallel to the plane; what refuses t does not refuse it",
           .shape = disk,
           .family = "parallel",
           .verdict = Verdict::false_hit,
           .claim = Claim::infinite,
           .cause = "formula: a division by 0"}),
      in_routine<flaws::HalfOfB, double>({.thread = "the handout",
                                          .about = "the discriminant lacks a factor 4",
                                          .shape = sphere,
                                          .family = "anywhere",
                                          .cause = "formula"}),
      in_routine<planted::Sentinel, double>(
          {.thread = "the handout",
           .about = "a miss is told as the point (0,0,0)",
           .shape = sphere,
           .family = "lattice",
           .claim = Claim::origin,
           .cause = "formula",
           .from_outside = "assumption of the place in the world"}),
      in_routine<flaws::SignOfZero, double>(
          {.thread = "arborx/ArborX#461",
           .about = "q = -(b + sign(b) sqrt(D)) / 2 with sign(0) = 0",
           .shape = sphere,
           .family = "lattice",
           .claim = Claim::origin,
           .cause = "formula: a division by 0"}),
      in_routine<flaws::EpsilonOfTheWrongSign, double>(
          {.thread = "g-truc/glm#578",
           .about = "the epsilon of the parallel test has the wrong sign",
           .shape = disk,
           .family = "within",
           .verdict = Verdict::false_hit,
           .claim = Claim::nan,
           .cause = "formula: a division by 0"}),
      in_routine<flaws::NearRootOnly, double>({.thread = "turanszkij/WickedEngine#1695",
                                               .about = "the far root is found and thrown away",
                                               .shape = sphere,
                                               .family = "inside",
                                               .cause = "formula"}),
      in_routine<flaws::SquareOfLengthLeftOut, double>(
          {.thread = "rustgd/collision-rs#97, SlimDX#493, GeometricTools#20",
           .about = "relies on directions of length 1",
           .shape = sphere,
           .family = "length",
           .verdict = Verdict::wrong_t,
           .cause = "assumption of a direction of length 1",
           .from_outside = "assumption of the length of the direction"}),
      in_routine<flaws::RadiusLostAtADistance, float>({.thread = "ziotom78/pytracer#22",
                                                       .about = "b^2 - 4ac in float, from far away",
                                                       .shape = sphere,
                                                       .family = "far",
                                                       .verdict = Verdict::false_hit,
                                                       .claim = Claim::no_root,
                                                       .cause = "flip"}),
      in_routine<flaws::SquareUnderflows, float>(
          {.thread = "mccode-dev/McCode#986",
           .about = "a coefficient underflows to 0, then a division by it",
           .shape = cylinder,
           .family = "scale",
           .verdict = Verdict::false_hit,
           .claim = Claim::nan,
           .cause = "flip"}),
      in_routine<flaws::EndsAlongTheRay, double>({.thread = "RenderKit/ospray#482",
                                                  .about = "the height test divides by d.axis",
                                                  .shape = cylinder,
                                                  .family = "perpendicular",
                                                  .cause = "formula: a division by 0"}),
      in_routine<flaws::LongTermsCancel, float>(
          {.thread = "RenderKit/ospray#600",
           .about = "terms of the size of (d.w)^2 cancel where the cylinder is long",
           .shape = cylinder,
           .family = "slender",
           .verdict = Verdict::false_hit,
           .claim = Claim::no_root,
           .cause = "flip"}),
      in_routine<planted::OrForAnd, double>({.thread = "doyubkim/fluid-engine-dev#251",
                                             .about = "the height test says or for and",
                                             .shape = cylinder,
                                             .family = "anywhere",
                                             .verdict = Verdict::false_hit,
                                             .claim = Claim::clipped,
                                             .cause = "formula"}),
      in_routine<planted::BothNappes, double>({.thread = "o3de/o3de#3925",
                                               .about = "the mirrored nappe counts",
                                               .shape = cone,
                                               .family = "anywhere",
                                               .verdict = Verdict::false_hit,
                                               .claim = Claim::mirrored,
                                               .cause = "formula"}),
      in_routine<flaws::NothingRefusesNan, double>(
          {.thread = "aardvark-platform/aardvark.base#123",
           .about = "a ray along the axis divides 0 by 0, and NaN is a hit",
           .shape = cylinder,
           .family = "parallel",
           .verdict = Verdict::false_hit,
           .claim = Claim::nan,
           .cause = "formula: a division by 0"}),
      in_routine<flaws::HitsBehind, double>({.thread = "aardvark-platform/aardvark.base#123",
                                             .about = "a negative t counts, from inside",
                                             .shape = cylinder,
                                             .family = "inside",
                                             .verdict = Verdict::wrong_root,
                                             .claim = Claim::behind,
                                             .cause = "formula"}),
      in_routine<flaws::NothingNear, double>({.thread = "RayTracing/raytracing.github.io#1297",
                                              .about = "t_min = 0.001: a near hit is passed by",
                                              .shape = disk,
                                              .family = "surface-near",
                                              .cause = "formula"}),
      in_routine<flaws::NothingNear, double>({.thread = "RayTracing/raytracing.github.io#1297",
                                              .about = "t_min = 0.001: the far hit is told",
                                              .shape = sphere,
                                              .family = "surface-near",
                                              .verdict = Verdict::wrong_root,
                                              .claim = Claim::later,
                                              .cause = "formula"}),
      in_routine<flaws::NothingNear, double>({.thread = "RayTracing/raytracing.github.io#1297",
                                              .about = "t_min = 0.001: a near hit is passed by",
                                              .shape = cylinder,
                                              .family = "surface-near",
                                              .cause = "formula"}),
      in_routine<flaws::NothingNear, double>({.thread = "RayTracing/raytracing.github.io#1297",
                                              .about = "t_min = 0.001: a near hit is passed by",
                                              .shape = cone,
                                              .family = "surface-near",
                                              .cause = "formula"}),
      in_routine<flaws::MeetsItAgain, double>(
          {.thread = "mmp/pbrt-v3#44",
           .about = "a ray meets the surface that it starts on again",
           .shape = cone,
           .family = "spawned",
           .verdict = Verdict::wrong_root,
           .claim = Claim::behind,
           .cause = "flip"}),
      in_routine<flaws::OneCoefficientWithoutLength, double>(
          {.thread = "Embree 3.13.5, cone-linear curve",
           .about = "one coefficient lacks d.d",
           .shape = cylinder,
           .family = "length",
           .verdict = Verdict::wrong_t,
           .cause = "assumption of a direction of length 1",
           .from_outside = "assumption of the length of the direction"}),
      in_routine<flaws::OneCoefficientWithoutLength, double>(
          {.thread = "Embree 3.13.5, cone-linear curve",
           .about = "one coefficient lacks d.d",
           .shape = cone,
           .family = "length",
           .verdict = Verdict::wrong_t,
           .cause = "assumption of a direction of length 1",
           .from_outside = "assumption of the length of the direction"}),
  };
  return flaws;
}

/// The same routine as a program or a plugin shows it: answers, and no way to see how.
Subject closed(const Subject& subject) {
  Subject made = subject;
  made.name.insert(made.name.find('/'), "+closed");
  made.prove = {};
  return made;
}

const replay::Replay* replay_of(std::string_view subject) {
  for (const Flaw& flaw : all_flaws())
    if (flaw.subject.name == subject) return &flaw.replay;
  return replay::replay_of(subject);
}

/// An audit with default settings but for its subjects.
struct Audited {
  std::vector<Subject> subjects;
  Plan plan;
  std::vector<Audit> audits;
  std::vector<Finding> found;

  explicit Audited(std::vector<Subject> of) : subjects(std::move(of)) {
    for (const Subject& subject : subjects) plan.subjects.push_back(&subject);
    for (const Family& family : families()) plan.families.push_back(&family);
    for (std::size_t shape = 0; shape < shape_count; ++shape) plan.shapes.push_back(shape);
    plan.cases = 10'000;
    plan.seed = 1;
    plan.replay_of = replay_of;
    audits = run(plan);
    found = findings(audits);
  }
  Audited(const Audited&) = delete;
  Audited& operator=(const Audited&) = delete;

  const Audit& of(std::string_view subject, std::size_t shape, std::string_view family) const {
    return *std::find_if(audits.begin(), audits.end(), [&](const Audit& audit) {
      return audit.subject->name == subject && audit.shape == shape && audit.family->id == family;
    });
  }
};

const Audited& audited() {
  static const Audited flawed([] {
    std::vector<Subject> subjects = {subject_of<flaws::PointBehindTheSurface, float>()};
    for (const Flaw& flaw : all_flaws()) {
      const auto is_it = [&](const Subject& each) { return each.name == flaw.subject.name; };
      if (std::any_of(subjects.begin(), subjects.end(), is_it)) continue;
      subjects.push_back(flaw.subject);
      subjects.push_back(closed(flaw.subject));
    }
    return subjects;
  }());
  return flawed;
}

/// Routines without a flaw, and the certified ones, which are never wrong.
const Audited& sound() {
  static const Audited audited([] {
    std::vector<Subject> subjects = {certified_float(), certified_double()};
    for (const Subject& open :
         {subject_of<ClosestApproach, float>(), subject_of<DivisionFree, float>(),
          subject_of<ClosestApproach, double>(), subject_of<DivisionFree, double>()}) {
      subjects.push_back(open);
      subjects.push_back(closed(open));
    }
    return subjects;
  }());
  return audited;
}

/// What an audit found of a flaw, in a routine that it can replay or in one that is closed to it.
const Finding& finding(const Flaw& flaw, const Subject& subject) {
  const auto& found = audited().found;
  const std::string routine = subject.name.substr(0, subject.name.find('/'));
  const auto place = std::find_if(found.begin(), found.end(), [&](const Finding& each) {
    return each.routine == routine && each.shape == flaw.shape && each.verdict == flaw.verdict &&
           each.claim == flaw.claim;
  });
  BOOST_TEST_REQUIRE((place != found.end()));
  return *place;
}
const Finding& opened(const Flaw& flaw) { return finding(flaw, flaw.subject); }
const Finding& shut(const Flaw& flaw) { return finding(flaw, closed(flaw.subject)); }

template <class Check>
void for_each_flaw(const Check& check) {
  for (const Flaw& flaw : all_flaws())
    BOOST_TEST_CONTEXT(flaw.thread << ", " << shape_names[flaw.shape] << ": " << flaw.about)
  check(flaw);
}

/// Where a comparison stands is no matter of the table.
std::string cause_of(const Diagnosis& diagnosis) {
  return diagnosis.cause == Cause::flip ? std::string(name(Cause::flip)) : told(diagnosis);
}

bool is_rounding(const Flaw& flaw) { return flaw.cause == "flip" || flaw.cause == "rounding"; }

int numbers_not_zero(const Case& question) {
  int count = 0;
  each_number(question, [&](double x) { count += x != 0; });
  return count;
}

void check_minimal(const Flaw& flaw, const Subject& subject) {
  const Worst& example = finding(flaw, subject).example;
  BOOST_TEST_REQUIRE(example.minimal.has_value(), case_line(example.question));
  const Minimal& minimal = *example.minimal;
  const Answer said = answer_one(subject, minimal.question);
  const Judgement judgement = judge(minimal.question, said, subject.format);
  BOOST_TEST((judgement.verdict == flaw.verdict), case_line(minimal.question));
  BOOST_TEST((judgement.claim == flaw.claim), case_line(minimal.question));
  BOOST_TEST(numbers_not_zero(minimal.question) <= numbers_not_zero(example.question),
             case_line(minimal.question));
}

std::string found_as(const Finding& finding) {
  const std::string verdict = figures::words(name(finding.verdict));
  if (finding.claim == Claim::none) return verdict;
  return verdict + ", " + figures::words(name(finding.claim));
}

std::string row(const Flaw& flaw) {
  const Finding& found = opened(flaw);
  const Afflicted& most = found.families.front();
  return fmt::format("| {} | {} | {} | {} | {} | {} % | {} | {} | `{}` |\n", flaw.about,
                     flaw.thread, shape_names[flaw.shape], found_as(found), most.family,
                     figures::percent(most.wrong, most.cases),
                     cause_of(told_first(found.example).diagnosis),
                     cause_of(told_first(shut(flaw).example).diagnosis),
                     case_line(found.example.minimal->question));
}

/// A right answer whose point is off has a row of its own: no verdict is wrong.
std::string row_of_the_point() {
  const Tally& tally = audited().of("point_behind_the_surface/float", sphere, "far").tally;
  return fmt::format(
      "| the hit point lies behind the surface | mitsuba-renderer/mitsuba2#171 | sphere | right, "
      "but t is off by {} times what rounding the case does | far | {} % beyond | {} | | `{}` |\n",
      figures::magnitude(tally.own.largest()),
      figures::percent(tally.sides[static_cast<std::size_t>(Side::beyond)], tally.cases), "",
      case_line(tally.worst_own->question));
}

std::string table() {
  std::string text =
      "# Flaws of public bug reports, as an audit with default settings tells them\n\n"
      "Each is in a routine of `tests/field_defects/flaws.hpp`. By replay: the cause where the "
      "routine can be run in exact numbers; from outside: where only its answers are seen. Written "
      "by `field_defects_field_defects_test`, 10,000 cases for each shape and family, seed 1.\n\n"
      "| flaw | seen in | shape | told as | mostly in | of its cases | by replay | from outside | "
      "minimal case |\n|---|---|---|---|---|---|---|---|---|\n";
  for (const Flaw& flaw : all_flaws()) text += row(flaw);
  return text + row_of_the_point();
}

std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

BOOST_AUTO_TEST_CASE(each_flaw_is_found_where_its_thread_saw_it) {
  for_each_flaw([](const Flaw& flaw) {
    const auto& families = opened(flaw).families;
    const auto is_there = [&](const Afflicted& each) { return each.family == flaw.family; };
    BOOST_TEST(std::any_of(families.begin(), families.end(), is_there), flaw.family);
  });
}

BOOST_AUTO_TEST_CASE(its_cause_is_found_by_replay) {
  for_each_flaw([](const Flaw& flaw) {
    const Worst& example = opened(flaw).example;
    BOOST_TEST(cause_of(example.diagnosis) == flaw.cause, case_line(example.question));
  });
}

BOOST_AUTO_TEST_CASE(a_routine_that_cannot_be_replayed_is_told_the_same_verdicts) {
  for_each_flaw([](const Flaw& flaw) {
    BOOST_TEST(shut(flaw).wrong == opened(flaw).wrong);
    BOOST_TEST(shut(flaw).families.front().family == opened(flaw).families.front().family);
  });
}

BOOST_AUTO_TEST_CASE(what_such_a_routine_takes_for_granted_is_named_all_the_same) {
  for_each_flaw([](const Flaw& flaw) {
    const Worst& example = shut(flaw).example;
    if (flaw.from_outside != "unknown")
      BOOST_TEST(cause_of(example.diagnosis) == flaw.from_outside, case_line(example.question));
  });
}

BOOST_AUTO_TEST_CASE(each_flaw_is_shown_by_a_minimal_case) {
  for_each_flaw([](const Flaw& flaw) {
    check_minimal(flaw, flaw.subject);
    check_minimal(flaw, closed(flaw.subject));
  });
}

BOOST_AUTO_TEST_CASE(a_point_beyond_the_surface_is_told_by_its_side_and_its_error) {
  const Tally& off = audited().of("point_behind_the_surface/float", sphere, "far").tally;
  const Tally& near = sound().of("closest_approach/float", sphere, "far").tally;
  BOOST_TEST(off.own.largest() > 1000 * near.own.largest());
  BOOST_TEST(off.sides[static_cast<std::size_t>(Side::beyond)] > 1000);
}

BOOST_AUTO_TEST_CASE(routines_without_a_flaw_are_charged_with_none) {
  for (const Finding& each : sound().found) {
    if (each.verdict == Verdict::invalid_mishandled) continue;
    BOOST_TEST_CONTEXT(each.routine << ": " << case_line(each.example.question)) {
      BOOST_TEST(!each.routine.starts_with("certified"));
      const std::string cause = cause_of(each.example.diagnosis);
      for (const Flaw& flaw : all_flaws()) {
        if (is_rounding(flaw)) continue;
        BOOST_TEST(cause != flaw.cause);
        BOOST_TEST((cause == "unknown" || cause != flaw.from_outside), cause);
      }
    }
  }
}

BOOST_AUTO_TEST_CASE(where_rounding_is_the_flaw_routines_that_take_care_are_wrong_far_less) {
  for_each_flaw([](const Flaw& flaw) {
    if (!is_rounding(flaw)) return;
    const std::string number(flaw.subject.format.name);
    const std::string careful = (flaw.shape == cone ? "certified/" : "closest_approach/") + number;
    const auto wrong = [&](const Audited& all, const std::string& subject) {
      return all.of(subject, flaw.shape, flaw.family).tally.of(flaw.verdict);
    };
    BOOST_TEST(4 * wrong(sound(), careful) <= wrong(audited(), flaw.subject.name));
  });
}

BOOST_AUTO_TEST_CASE(the_table_in_data_is_what_was_found) {
  const std::filesystem::path kept = std::filesystem::path(RAYAUDIT_DATA) / "field_defects.md";
  const std::string told = table();
  std::ofstream("field_defects.md") << told;
  if (std::getenv("RAYAUDIT_WRITE") != nullptr) std::ofstream(kept) << told;
  BOOST_TEST(content(kept) == told,
             kept << " is not what was found, which lies in "
                  << std::filesystem::absolute("field_defects.md")
                  << "; with RAYAUDIT_WRITE=1 in the environment this test writes it anew");
}
