#include "audit/drawn.hpp"

#include <boost/test/unit_test.hpp>

namespace rayaudit {
namespace {

const Subject* subject_named(std::string_view name) {
  for (const Subject& subject : built_in_subjects())
    if (subject.name == name) return &subject;
  return nullptr;
}

Plan plan(std::string_view subject = "textbook/float") {
  Plan plan;
  plan.subjects = {subject_named(subject)};
  for (const Family& family : families())
    if (family.id == "far") plan.families.push_back(&family);
  plan.shapes = {1};
  plan.cases = 100;
  plan.seed = 1;
  return plan;
}

std::uint64_t drawn_by(const Plan& plan) { return *drawn(plan, planned(plan).front()); }

BOOST_AUTO_TEST_CASE(the_same_cases_are_told_alike) {
  BOOST_TEST(drawn_by(plan()) == drawn_by(plan()));
  BOOST_TEST(drawn_by(plan()) == drawn_by(plan("handout/float")));
  Plan part = plan();
  part.shard = 1, part.shards = 2, part.threads = 3;
  BOOST_TEST(drawn_by(part) == drawn_by(plan()));
}

BOOST_AUTO_TEST_CASE(other_cases_are_told_apart) {
  const auto differs = [](const auto& change) {
    Plan other = plan();
    change(other);
    return drawn_by(other) != drawn_by(plan());
  };
  BOOST_TEST(differs([](Plan& of) { of.seed = 2; }));
  BOOST_TEST(differs([](Plan& of) { of.difficulty = 5; }));
  BOOST_TEST(differs([](Plan& of) { of.shapes = {0}; }));
  BOOST_TEST(differs([](Plan& of) { of.subjects = {subject_named("textbook/double")}; }));
  BOOST_TEST(differs([](Plan& of) { of.drawn_in = double_format; }));
  BOOST_TEST(differs([](Plan& of) { of.convention.unit_direction = true; }));
  BOOST_TEST(differs([](Plan& of) { of.convention.t_max = 5; }));
}

BOOST_AUTO_TEST_CASE(a_family_that_draws_none_has_nothing_to_tell) {
  Family none = *plan().families.front();
  none.draw = {};
  const Audit audit = {subject_named("textbook/float"), &none, 1, {}, {}};
  BOOST_TEST(!drawn(plan(), audit).has_value());
}

}  // namespace
}  // namespace rayaudit
