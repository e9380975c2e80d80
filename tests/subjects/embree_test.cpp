#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "audit/finding.hpp"
#include "geometry/case_line.hpp"
#include "subjects/libraries/libraries.hpp"
#include "subjects/plugins.hpp"
#include "tests/cli/shell.hpp"
#include "tests/subjects/from_environment.hpp"

/// Embree's primitives, held to what was observed of them. Built only where Embree is.
using namespace rayaudit;

namespace {

constexpr std::size_t cylinder = 2, cone = 3;

const Subject& embree() {
  static const Subject subject = [] {
    const auto library = std::find_if(libraries().begin(), libraries().end(),
                                      [](const Library& each) { return each.plugin == "embree"; });
    return subjects_of(*library, from_environment("RAYAUDIT")).front();
  }();
  return subject;
}

/// An audit of it with default settings, but for its cases.
Plan plan_of(std::uint64_t cases) {
  Plan plan;
  plan.subjects = {&embree()};
  for (const Family& family : families()) plan.families.push_back(&family);
  for (std::size_t shape = 0; shape < shape_count; ++shape) plan.shapes.push_back(shape);
  plan.cases = cases;
  plan.seed = 1;
  return plan;
}

/// With settings as they are when nothing is asked for.
const std::vector<Audit>& audited() {
  static const std::vector<Audit> audits = run(plan_of(10'000));
  return audits;
}

const Audit& audit_of(const std::vector<Audit>& audits, std::size_t shape,
                      std::string_view family) {
  return *std::find_if(audits.begin(), audits.end(), [&](const Audit& audit) {
    return audit.shape == shape && audit.family->id == family;
  });
}

/// One family of cylinders, whose directions are given as long as 1.
Tally with_unit_directions(std::string_view family, int difficulty) {
  Plan plan = plan_of(10'000);
  plan.families = {&*std::ranges::find(families(), family, &Family::id)};
  plan.shapes = {cylinder};
  plan.difficulty = difficulty;
  plan.convention.unit_direction = true;
  return run(plan).front().tally;
}

/// Under sanitizers a child takes seconds to start.
#ifdef RAYAUDIT_SANITIZED
constexpr bool is_watched = true;
#else
constexpr bool is_watched = false;
#endif

/// Has the family rays beyond 1.8e18, of which Debian's build dies?
bool aborts(const Family& family) {
  return family.id == "length" || family.id == "scale" || family.id == "invalid";
}

/// Of the cases that have a hit to be found, the share that is told as misses.
double share_lost(const Tally& tally) {
  const auto lost = static_cast<double>(tally.of(Verdict::false_miss));
  const auto found = static_cast<double>(tally.ulps.count() + tally.of(Verdict::wrong_root));
  return lost / (lost + found);
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_known_of_it_is_what_its_plugin_declares) {
  const std::string program = from_environment("RAYAUDIT");
  const auto plugin = plugin_beside(program, "embree");
  BOOST_TEST_REQUIRE(plugin.has_value());
  const std::vector<Subject> declared = plugin_subjects(*plugin, plugin_patience, program);
  BOOST_TEST_REQUIRE(declared.size() == 1);
  BOOST_TEST(declared[0].name == embree().name);
  BOOST_TEST((declared[0].format == embree().format));
  BOOST_TEST((declared[0].convention == embree().convention));
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    BOOST_TEST(declared[0].answers(shape) == embree().answers(shape));
}

BOOST_AUTO_TEST_CASE(it_answers_as_its_manual_has_it) {
  const auto is_hit_at = [](double t, std::string_view line) {
    const Answer said = answer_one(embree(), read_case_line(line).question);
    BOOST_TEST((said.form == Answer::Form::hit), line);
    BOOST_TEST(std::fabs(said.t.high - t) < 0x1p-20, line);
  };
  is_hit_at(3, "disk 0 0 0 0 0 1 1 ray 0 0 -3 0 0 1");
  is_hit_at(3, "disk 0 0 0 0 0 1 1 ray 0 0 3 0 0 -1");
  is_hit_at(1.5, "disk 0 0 0 0 0 5 1 ray 0 0 -3 0 0 2");
  is_hit_at(1, "sphere 0 0 0 1 ray 0 0 -3 0 0 2");
  is_hit_at(1, "sphere 0 0 0 1 ray 0 0 0 0 0 1");
  is_hit_at(2.5, "cylinder -1 0 0 1 0 0 0.5 ray 0 0 -3 0 0 1");
  is_hit_at(0.5, "cylinder -1 0 0 1 0 0 0.5 ray 0 0 0 0 0 1");
  is_hit_at(2.75, "cone -1 0 0 1 0 0 0.5 ray 0 0 -3 0 0 1");
}

BOOST_AUTO_TEST_CASE(cylinders_are_open) {
  const Case along = read_case_line("cylinder -1 0 0 1 0 0 0.5 ray -3 0.25 0 1 0 0").question;
  BOOST_TEST((answer_one(embree(), along) == Answer::miss()));
}

BOOST_AUTO_TEST_CASE(it_holds_what_was_observed_of_it) {
  std::string asked;
  for (const Family& family : families())
    if (!is_watched || !aborts(family))
      asked += (asked.empty() ? "" : ",") + std::string(family.id);
  const shell::Ended held = shell::Folder().run(
      "rayaudit audit embree/float --cases 2k --report csv=/dev/null --family " + asked +
      " --bounds '" RAYAUDIT_DATA "/bounds/embree.txt'");
  BOOST_TEST(held.code == 0, held);
}

BOOST_AUTO_TEST_CASE(t_is_wrong_for_directions_that_are_not_unit_and_the_length_is_named) {
  const std::vector<Finding> found = findings(audited());
  for (const std::size_t shape : {cylinder, cone}) BOOST_TEST_CONTEXT(shape_names[shape]) {
      const auto wrong_t = std::find_if(found.begin(), found.end(), [&](const Finding& each) {
        return each.shape == shape && each.verdict == Verdict::wrong_t;
      });
      BOOST_TEST_REQUIRE((wrong_t != found.end()));
      const Worst& example = wrong_t->example;
      BOOST_TEST(told(example.diagnosis) == "assumption of the length of the direction",
                 case_line(example.question));
      BOOST_TEST(audit_of(audited(), shape, "anywhere").tally.of(Verdict::wrong_t) > 1000);
      BOOST_TEST(audit_of(audited(), shape, "unit").tally.of(Verdict::wrong_t) == 0);
      BOOST_TEST_REQUIRE(example.minimal.has_value(), case_line(example.question));
      const Ray<double>& ray = example.minimal->question.ray;
      BOOST_TEST(dot(ray.direction, ray.direction) != 1, case_line(example.minimal->question));
      BOOST_TEST(told(example.minimal->diagnosis) == "assumption of the length of the direction");
    }
}

BOOST_AUTO_TEST_CASE(long_cylinders_lose_hits_whatever_the_length_of_the_direction) {
  const Tally& all = audit_of(audited(), cylinder, "slender").tally;
  BOOST_TEST(all.of(Verdict::false_miss) > 3000);
  BOOST_TEST(share_lost(with_unit_directions("slender", 4)) < 0.001);
  const double lost = share_lost(with_unit_directions("slender", 13));
  BOOST_TEST(lost > 0.37);
  BOOST_TEST(lost < 0.41);
}
