#include "reports/shard.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <limits>

#include "audit/parts.hpp"
#include "geometry/error.hpp"

namespace rayaudit {
namespace {

/// How large a struct of just these members is: a member that parts() leaves out would be missed.
template <class... Part>
constexpr std::size_t size_of(const std::tuple<Part&...>*) {
  std::size_t end = 0, widest = 1;
  const auto align = [&](std::size_t to) { end = (end + to - 1) / to * to; };
  ((align(alignof(Part)), end += sizeof(Part), widest = std::max(widest, alignof(Part))), ...);
  align(widest);
  return end;
}

/// Calls visit(leaf) for every number, text and enumerator that a value is made of; lists and
/// optional members that are empty are given one element first.
template <class T, class Visit>
void each_leaf(T& of, const Visit& visit) {
  constexpr bool is_leaf =
      std::is_enum_v<T> || std::is_arithmetic_v<T> || std::is_convertible_v<T, std::string_view>;
  if constexpr (is_leaf) {
    visit(of);
  } else if constexpr (requires { of.emplace_back(); }) {
    if (of.empty()) of.emplace_back();
    for (auto& each : of) each_leaf(each, visit);
  } else if constexpr (std::is_same_v<T, Shape>) {
    std::visit([&](auto& shape) { each_leaf(shape, visit); }, of);
  } else if constexpr (requires { of.has_value(); }) {
    if (!of) of.emplace();
    each_leaf(*of, visit);
  } else if constexpr (requires { of.begin(); }) {
    for (auto& each : of) each_leaf(each, visit);
  } else {
    using Parts = decltype(parts(of));
    static_assert(size_of(static_cast<const Parts*>(nullptr)) == sizeof(T));
    std::apply([&](auto&... part) { (each_leaf(part, visit), ...); }, parts(of));
  }
}

/// Sets every leaf to another value than it had, all of them different where they can be.
struct Fill {
  int& count;

  template <class T>
  void operator()(T& leaf) const {
    ++count;
    if constexpr (std::is_same_v<T, std::string_view>) {
      static const std::string_view texts[] = {"one", "two", "three", "four", "five"};
      leaf = texts[count % 5];
    } else if constexpr (std::is_same_v<T, bool>) {
      leaf = !leaf;
    } else if constexpr (std::is_enum_v<T>) {
      leaf = static_cast<T>(1);
    } else if constexpr (std::is_floating_point_v<T>) {
      leaf = count + 0.1;
    } else if constexpr (std::is_same_v<T, std::uint64_t>) {
      leaf = std::numeric_limits<T>::max() - static_cast<T>(count);
    } else {
      leaf = static_cast<T>(count % 100 + 1);
    }
  }
};

/// The leaves of a value as texts, in order.
std::vector<std::string> leaves(Tally& of) {
  std::vector<std::string> all;
  each_leaf(of, [&](const auto& leaf) {
    using T = std::remove_cvref_t<decltype(leaf)>;
    if constexpr (std::is_convertible_v<T, std::string_view>)
      all.emplace_back(leaf);
    else if constexpr (std::is_enum_v<T>)
      all.push_back(std::to_string(static_cast<int>(leaf)));
    else if constexpr (std::is_floating_point_v<T>)
      all.push_back(std::to_string(std::bit_cast<std::uint64_t>(leaf)));
    else
      all.push_back(std::to_string(leaf));
  });
  return all;
}

const Subject* subject_named(const std::string& name) {
  for (const Subject& subject : built_in_subjects())
    if (subject.name == name) return &subject;
  throw Error("subject `" + name + "` is not known");
}

Plan plan() {
  Plan plan;
  plan.subjects = {subject_named("textbook/float"), subject_named("handout/double")};
  for (const Family& family : families())
    if (family.id == "far" || family.id == "tangent") plan.families.push_back(&family);
  plan.shapes = {1, 3};
  plan.cases = 5000;
  plan.seed = 0xfedcba9876543210;
  plan.shard = 1, plan.shards = 3;
  return plan;
}

const Environment here = {.compiler = "a compiler",
                          .flags = "-O2",
                          .processor = "a processor",
                          .contraction = false,
                          .flush_to_zero = false,
                          .rounding = "to nearest",
                          .processors = 2};

std::string file(const Plan& plan, const std::vector<Audit>& audits,
                 const std::string& version = "1.2.3", const std::string& command = "rayaudit") {
  return write_shard({version, plan, audits, here, command}, {});
}
std::string file(const Plan& plan) { return file(plan, planned(plan)); }

Shard read(const std::string& bytes) {
  return read_shard(bytes, "a.shard", "1.2.3", subject_named);
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

BOOST_AUTO_TEST_CASE(every_member_of_a_tally_survives) {
  const Plan of = plan();
  std::vector<Audit> audits = planned(of);
  int count = 0;
  for (Audit& audit : audits) {
    Tally& tally = audit.tally;
    tally.outcomes.resize(2);
    // A case of the cone, which is not the shape of a case that nothing is known of.
    each_leaf(tally, Fill{count});
    tally.worst_own->question.shape = Cone<double>{{1, 2, 3}, {4, 5, 6}, 7};
  }
  const Shard shard = read(file(of, audits));
  BOOST_TEST(shard.tallies.size() == audits.size());
  for (std::size_t i = 0; i < audits.size(); ++i) {
    Tally there = shard.tallies[i];
    BOOST_TEST(leaves(there) == leaves(audits[i].tally), boost::test_tools::per_element());
  }
  BOOST_TEST(leaves(audits[0].tally).size() > 7000u);
}

BOOST_AUTO_TEST_CASE(what_is_not_there_stays_away) {
  const Plan of = plan();
  const Shard shard = read(file(of));
  for (const Tally& tally : shard.tallies) {
    BOOST_TEST(tally.outcomes.empty());
    BOOST_TEST(!tally.worst_ulps.has_value());
    BOOST_TEST(!tally.certificate.first_wrong.has_value());
    BOOST_TEST(std::isnan(tally.proper_own));
  }
}

BOOST_AUTO_TEST_CASE(numbers_that_are_none_survive_to_the_bit) {
  const Plan of = plan();
  std::vector<Audit> audits = planned(of);
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  Worst worst = {.severity = infinity};
  worst.question.ray.origin = {-0.0, std::copysign(nan, -1), 0x1p-1074};
  worst.answer = Answer::hit({-infinity, 0, 0, 5});
  audits[0].tally.worst_ulps = worst;
  Tally there = read(file(of, audits)).tallies[0];
  BOOST_TEST(leaves(there) == leaves(audits[0].tally), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(the_plan_survives) {
  Plan of = plan();
  of.difficulty = -7;
  of.convention.of(oracle::Kind::tangent) = Convention::Stance::hit;
  of.convention.inside = Convention::Inside::start;
  of.convention.unit_direction = of.convention.line = true;
  of.convention.t_max = 1e10;
  of.bounds = read_bounds("textbook/* * far wrong 3 max_ulp 0.1 proved\n* * * false_hit 0 observed",
                          "rows.txt");
  of.thorough = true;
  of.causes = false;
  of.drawn_in = float_format;
  const Shard shard = read(file(of, planned(of), "1.2.3", "rayaudit audit --seed 7"));
  const Plan& there = shard.plan;
  BOOST_TEST((there.subjects == of.subjects));
  BOOST_TEST((there.families == of.families));
  BOOST_TEST(there.shapes == of.shapes);
  BOOST_TEST(there.cases == of.cases);
  BOOST_TEST(there.seed == of.seed);
  BOOST_TEST((there.difficulty == of.difficulty));
  BOOST_TEST((there.convention == of.convention));
  BOOST_TEST(there.bounds.size() == 2u);
  BOOST_TEST((there.bounds[0].limits == of.bounds[0].limits));
  BOOST_TEST(there.bounds[0].proved);
  BOOST_TEST(there.bounds[1].place == "rows.txt:2");
  BOOST_TEST(there.thorough);
  BOOST_TEST(!there.causes);
  BOOST_TEST((there.drawn_in == of.drawn_in));
  BOOST_TEST(there.shard == 1u);
  BOOST_TEST(there.shards == 3u);
  BOOST_TEST(shard.command == "rayaudit audit --seed 7");
  BOOST_TEST(shard.environment.processor == "a processor");
}

BOOST_AUTO_TEST_CASE(any_byte_changed_or_missing_is_told) {
  const std::string whole = file(plan());
  const std::string broken = "`a.shard` is not whole, or was changed";
  for (std::size_t i = 0; i < whole.size(); i += 1 + whole.size() / 300) {
    std::string changed = whole;
    changed[i] ^= 1;
    const std::string told = refusal([&] { read(changed); });
    BOOST_TEST((told == broken || told == "`a.shard` is no shard of an audit"), i << told);
    BOOST_TEST(refusal([&] { read(whole.substr(0, i)); }) != "not refused", i);
  }
  BOOST_TEST(refusal([&] { read(whole.substr(0, whole.size() - 1)); }) == broken);
  BOOST_TEST(refusal([&] { read(whole + "x"); }) == broken);
}

BOOST_AUTO_TEST_CASE(what_another_version_made_is_refused) {
  const std::string other = file(plan(), planned(plan()), "1.2.4");
  BOOST_TEST(refusal([&] { read(other); }) ==
             "`a.shard` is of no use here: it was made by rayaudit 1.2.4, and this is 1.2.3");
}

BOOST_AUTO_TEST_CASE(a_subject_that_is_not_what_it_was_is_refused) {
  Subject other = *subject_named("textbook/float");
  other.convention.line = true;
  const auto named = [&](const std::string& name) {
    return name == other.name ? &other : subject_named(name);
  };
  BOOST_TEST(refusal([&] { read_shard(file(plan()), "a.shard", "1.2.3", named); }) ==
             "`a.shard` is of no use here: subject `textbook/float` is not what it was: format, "
             "shapes, conventions or what it is made of differ");
}

/// The shard of a plan, under a name of its own.
Shard shard_of(Plan of, std::uint64_t shard, const std::string& name) {
  of.shard = shard;
  return read_shard(file(of), name, "1.2.3", subject_named);
}

BOOST_AUTO_TEST_CASE(a_shard_that_is_missing_or_there_twice_is_told) {
  ShardSum sum;
  sum.add(shard_of(plan(), 1, "b"));
  BOOST_TEST(refusal([&] { sum.require_all(); }) == "shards 1, 3 of 3 are missing");
  sum.add(shard_of(plan(), 0, "a"));
  BOOST_TEST(refusal([&] { sum.require_all(); }) == "shard 3 of 3 is missing");
  BOOST_TEST(refusal([&] { sum.add(shard_of(plan(), 1, "c")); }) ==
             "`b` and `c` are both shard 2 of 3");
  sum.add(shard_of(plan(), 2, "c"));
  BOOST_TEST(refusal([&] { sum.require_all(); }) == "not refused");
  BOOST_TEST(sum.plan().shards == 1u);
}

BOOST_AUTO_TEST_CASE(a_shard_of_another_run_is_told_with_what_differs) {
  ShardSum sum;
  sum.add(shard_of(plan(), 0, "a"));
  const auto told = [&](const auto& change) {
    Plan other = plan();
    change(other);
    return refusal([&] { sum.add(shard_of(other, 1, "b")); });
  };
  const std::string head = "`b` is no shard of the same run as `a`: ";
  BOOST_TEST(told([](Plan& of) { of.seed = 2; }) ==
             head + "its seed is 2, not 18364758544493064720");
  BOOST_TEST(told([](Plan& of) { of.cases = 6000; }) == head + "its cases is 6000, not 5000");
  BOOST_TEST(told([](Plan& of) { of.difficulty = 3; }) == head + "its difficulty is 3, not null");
  BOOST_TEST(told([](Plan& of) { of.shards = 4; }) == head + "its shards is 4, not 3");
  BOOST_TEST(told([](Plan& of) { of.thorough = true; }) ==
             head + "its thorough is true, not false");
  BOOST_TEST(told([](Plan& of) { of.subjects.pop_back(); }) == head + "its subjects differ");
  BOOST_TEST(told([](Plan& of) { of.families.pop_back(); }) == head + "its families differ");
  BOOST_TEST(told([](Plan& of) { of.shapes.pop_back(); }) == head + "its shapes differ");
  BOOST_TEST(told([](Plan& of) { of.convention.line = true; }) == head + "its convention differ");
  BOOST_TEST(told([](Plan& of) {
               of.bounds = read_bounds("* * * wrong 0 observed", "rows.txt");
             }) == head + "its bounds differ");
}

BOOST_AUTO_TEST_CASE(shards_put_together_in_any_order_are_the_whole) {
  Plan whole = plan();
  whole.shard = 0, whole.shards = 1, whole.cases = 3500;
  std::vector<Audit> at_once = gathered(whole);
  for (const std::array<std::uint64_t, 3> order :
       {std::array<std::uint64_t, 3>{0, 1, 2}, {2, 0, 1}}) {
    ShardSum sum;
    for (const std::uint64_t shard : order) {
      Plan part = whole;
      part.shard = shard, part.shards = 3;
      sum.add(read(file(part, gathered(part))));
    }
    sum.require_all();
    BOOST_TEST(sum.audits().size() == at_once.size());
    for (std::size_t i = 0; i < at_once.size(); ++i)
      BOOST_TEST(leaves(sum.audits()[i].tally) == leaves(at_once[i].tally),
                 boost::test_tools::per_element());
  }
}

BOOST_AUTO_TEST_CASE(where_shards_ran_on_several_machines_each_is_told) {
  ShardSum sum;
  Shard other = shard_of(plan(), 1, "b");
  other.environment.processor = "another";
  other.environment.processors = 8;
  sum.add(shard_of(plan(), 0, "a"));
  sum.add(other);
  sum.add(shard_of(plan(), 2, "c"));
  BOOST_TEST(sum.environment().processor == "a processor; another");
  BOOST_TEST(sum.environment().processors == 8u);
  BOOST_TEST(sum.environment().compiler == "a compiler");
}

}  // namespace
}  // namespace rayaudit
