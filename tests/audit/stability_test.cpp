#include <algorithm>
#include <boost/test/data/monomorphic.hpp>
#include <boost/test/data/test_case.hpp>
#include <boost/test/unit_test.hpp>
#include <fstream>
#include <iterator>
#include <ostream>
#include <string>
#include <vector>

#include "audit/ladder.hpp"
#include "geometry/case_line.hpp"
#include "tests/watched.hpp"

/// Hard cases stay numerically stable: the routines that promise to hold keep their rows of
/// data/bounds along every ladder, and the textbook, held to the same rows, does not.
using namespace rayaudit;

namespace {

std::vector<Bound> rows_of(const std::string& name) {
  const std::string path = std::string(RAYAUDIT_BOUNDS) + '/' + name;
  std::ifstream file(path);
  BOOST_TEST_REQUIRE(file.good(), path);
  return read_bounds(std::string(std::istreambuf_iterator<char>(file), {}), path);
}

const std::vector<Bound>& all_rows() {
  static const std::vector<Bound> rows = [] {
    std::vector<Bound> all = rows_of("robust.txt");
    for (const Bound& bound : rows_of("certified.txt")) all.push_back(bound);
    return all;
  }();
  return rows;
}

std::vector<std::string> families_with_difficulty() {
  std::vector<std::string> ids;
  for (const Family& family : families())
    if (family.difficulty) ids.emplace_back(family.id);
  return ids;
}

std::vector<const Subject*> subjects_of(const std::string& routine) {
  std::vector<const Subject*> subjects;
  for (const Subject& subject : built_in_subjects())
    if (subject.name.starts_with(routine + '/')) subjects.push_back(&subject);
  BOOST_TEST_REQUIRE(!subjects.empty(), routine);
  return subjects;
}

LadderPlan plan_of(const std::string& id, std::vector<const Subject*> subjects) {
  LadderPlan plan;
  plan.subjects = std::move(subjects);
  plan.cases = 256;
  plan.seed = 1;
  plan.family = &*std::ranges::find(families(), id, &Family::id);
  for (std::size_t shape = 0; shape < shape_count; ++shape) plan.shapes.push_back(shape);
  return plan;
}

std::string told(const Climb& climb) {
  const Break& broken = *climb.broken;
  return climb.subject->name + " at k = " + std::to_string(broken.k) + ": " +
         std::string(broken.limit.quantity->name) + " is " + std::to_string(broken.seen) +
         ", more than " + std::to_string(broken.limit.most) + " (" + broken.bound.place +
         "): " + case_line(broken.worst.value().question);
}

/// A routine on a family and shape that it is known to fail on, and the one that holds there.
struct Control {
  std::string failing, holding, family, shape;

  friend std::ostream& operator<<(std::ostream& out, const Control& control) {
    return out << control.failing << " on " << control.shape << ", family " << control.family;
  }
};

const std::vector<Control> controls = {
    {"textbook/float", "closest_approach/float", "grazing", "sphere"},
    {"textbook/float", "closest_approach/float", "grazing", "cylinder"},
    {"textbook/float", "closest_approach/float", "grazing", "cone"},
    {"textbook/double", "closest_approach/double", "grazing", "sphere"},
    {"textbook/float", "closest_approach/float", "tangent-near", "sphere"},
    {"textbook/float", "closest_approach/float", "tangent-near", "cone"},
    {"textbook/float", "closest_approach/float", "rim-near", "cylinder"},
    {"textbook/float", "closest_approach/float", "apex-near", "cone"},
    {"textbook/float", "closest_approach/float", "parallel-near", "cone"},
    {"textbook/float", "closest_approach/float", "surface-near", "sphere"},
    {"textbook/float", "closest_approach/float", "surface-near", "cylinder"},
    {"textbook/float", "closest_approach/float", "far", "sphere"},
    {"textbook/float", "closest_approach/float", "far", "cylinder"},
    {"textbook/float", "closest_approach/float", "far", "cone"},
    {"textbook/float", "closest_approach/float", "placement", "cylinder"},
    {"textbook/float", "closest_approach/float", "placement", "cone"},
    {"textbook/float", "closest_approach/float", "slender", "cylinder"},
    {"textbook/float", "closest_approach/float", "flat", "cylinder"},
    {"textbook/float", "closest_approach/float", "flat", "cone"},
    {"textbook/float", "closest_approach/float", "length", "cone"},
    {"textbook/float", "closest_approach/float", "scale", "sphere"},
};

}  // namespace

BOOST_DATA_TEST_CASE(who_promises_to_hold_does_on_every_rung,
                     boost::unit_test::data::make(families_with_difficulty()), family) {
  std::vector<const Subject*> subjects;
  for (const auto* routine : {"stable_quadratic", "closest_approach", "division_free", "certified"})
    for (const Subject* subject : subjects_of(routine)) subjects.push_back(subject);
  LadderPlan plan = plan_of(family, subjects);
  plan.bounds = all_rows();
  plan.cases /= one_in;
  const std::vector<Climb> climbs = climb(plan);
  BOOST_TEST(!climbs.empty());
  for (const Climb& climb : climbs) {
    const auto& [subject, shape, held_to, rungs, broken, slopes] = climb;
    BOOST_TEST(!held_to.front().place.empty(),
               subject->name << " promises nothing on " << shape_names[shape]);
    BOOST_TEST(!broken.has_value(), (broken ? told(climb) : ""));
    BOOST_TEST(rungs.back().k == plan.family->difficulty->most(subject->drawn_in()));
  }
}

BOOST_DATA_TEST_CASE(who_is_known_to_fail_breaks_the_same_rows,
                     boost::unit_test::data::make(controls), control) {
  LadderPlan plan =
      plan_of(control.family, subjects_of(control.failing.substr(0, control.failing.find('/'))));
  std::erase_if(plan.subjects, [&](const Subject* each) { return each->name != control.failing; });
  for (const Bound& row : all_rows())
    if (row.subject == control.holding && row.shape == control.shape &&
        row.family == control.family) {
      plan.bounds.push_back(row);
      plan.bounds.back().subject = control.failing;
    }
  BOOST_TEST_REQUIRE(!plan.bounds.empty());
  std::erase_if(plan.shapes,
                [&](std::size_t shape) { return shape_names[shape] != control.shape; });
  const std::vector<Climb> climbs = climb(plan);
  BOOST_TEST_REQUIRE(climbs.size() == 1u);
  BOOST_TEST(climbs.front().broken.has_value(), "the control held");
}

BOOST_AUTO_TEST_CASE(an_error_forced_by_the_case_is_told_from_one_of_the_routine) {
  // Near a tangent the error in ulps rises with the case; that of the stable routine itself does
  // not, and that of the textbook far away does.
  const auto slopes = [&](const std::string& routine, const std::string& family) {
    LadderPlan plan = plan_of(family, subjects_of(routine));
    std::erase_if(plan.subjects,
                  [](const Subject* each) { return !each->name.ends_with("/double"); });
    plan.shapes = {1};
    return climb(plan).front().slopes;
  };
  const Slopes stable = slopes("closest_approach", "grazing");
  BOOST_TEST(std::fabs(stable.condition - 0.5) < 0.1);  // dt/dx grows as the root of 2^k
  BOOST_TEST(std::fabs(stable.ulps - stable.condition) < 0.15);
  BOOST_TEST(std::fabs(stable.own) < 0.15);
  BOOST_TEST(slopes("textbook", "far").own > 0.3);
}
