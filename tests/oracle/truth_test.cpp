#define BOOST_TEST_MODULE truth
#include "oracle/truth.hpp"

#include <boost/test/unit_test.hpp>
#include <cfenv>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "geometry/case_line.hpp"
#include "oracle/environment.hpp"
#include "oracle/self_check.hpp"

using namespace rayaudit;
using oracle::Invalid;
using oracle::Kind;
using oracle::Stage;
using oracle::Standing;

namespace {

Case read(std::string_view line) { return read_case_line(line).question; }

/// The crossings of a case in words: kinds and t as decimals.
std::string told(std::string_view line) {
  const Case question = read(line);
  const oracle::Truth truth = oracle::truth(question);
  std::string words;
  for (const oracle::Crossing& crossing : truth.crossings()) {
    if (!words.empty()) words += ", ";
    words += oracle::name(crossing.kind);
    words += " " + oracle::spelled(question, crossing, 12).decimals;
    if (crossing.kind == Kind::within)
      words += " to " + oracle::spelled_last(question, crossing, 12).decimals;
  }
  return words;
}

Invalid why_invalid(std::string_view line) { return oracle::truth(read(line)).invalid; }

}  // namespace

BOOST_AUTO_TEST_CASE(the_self_check_finds_nothing) {
  BOOST_TEST(oracle::self_check().value_or("") == "");
}

BOOST_AUTO_TEST_CASE(a_ray_through_a_sphere_meets_its_near_side) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1") == "proper 2");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2") == "proper 1.06698729811");
}

BOOST_AUTO_TEST_CASE(a_ray_that_starts_inside_meets_the_far_side) {
  BOOST_TEST(told("sphere 0 0 0 5 ray 3 0 0 0 2 0") == "proper 2");
  BOOST_TEST(told("cylinder 0 0 0 0 4 0 5 ray 3 1 0 0 0 2") == "proper 2");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray 0 0.5 0 1 0 0") == "proper 0.5");
}

BOOST_AUTO_TEST_CASE(a_shape_behind_the_ray_is_missed) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 3 0 0 1") == "");
  BOOST_TEST(told("disk 0 0 0 0 0 1 1 ray 0 0 3 0 0 1") == "");
}

BOOST_AUTO_TEST_CASE(a_double_root_is_a_tangent_touch) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 1 -3 0 0 1") == "tangent 3");
  BOOST_TEST(told("cylinder 0 0 0 0 4 0 5 ray 5 2 -3 0 0 1") == "tangent 3");
  // One ulp further out it is a miss, one ulp further in a hit.
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0x1.0000000000001p+0 -3 0 0 1") == "");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0x1.fffffffffffffp-1 -3 0 0 1").starts_with("proper"));
}

BOOST_AUTO_TEST_CASE(a_side_condition_at_zero_is_a_rim_touch) {
  BOOST_TEST(told("disk 0 0 0 0 1 0 5 ray 3 2 4 0 -4 0") == "rim 0.5");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray -3 1 0 1 0 0") == "rim 2, rim 4");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -3 0 0 1 0 0") == "rim 2, rim 4");
  BOOST_TEST(told("disk 0 0 0 0 1 0 5 ray 3 2 0x1.0000000000001p+2 0 -4 0") == "");
}

BOOST_AUTO_TEST_CASE(tangent_at_the_rim_is_told_as_rim) {
  BOOST_TEST(told("cylinder 0 0 0 0 4 0 5 ray 5 4 -3 0 0 1") == "rim 3");
}

BOOST_AUTO_TEST_CASE(the_apex_is_a_touch_from_outside_and_proper_from_inside) {
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0") == "apex 3");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray 0 -3 0 0 2 0") == "proper 2");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray 0.25 3 0 -0.125 -1 0") == "proper 2");
}

BOOST_AUTO_TEST_CASE(only_one_nappe_of_the_cone_counts) {
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0") == "");
  const oracle::Roots roots = oracle::roots(read("cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0"));
  BOOST_REQUIRE(roots.count == 2);
  BOOST_TEST((roots.listed[0].standing == Standing::mirrored));
}

BOOST_AUTO_TEST_CASE(the_range_is_open_and_its_ends_are_touches) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 2 inf") == "start 2, proper 4");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 2") == "end 2");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 0x1.fffffffffffffp+0") == "");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 2.5 4") == "end 4");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 3 0 0 1 range -inf inf") == "proper -4");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -1 0 0 1") == "start 0, proper 2");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -1 0 0 1 range -1 2") == "proper 0");
}

BOOST_AUTO_TEST_CASE(a_ray_in_the_surface_is_within_it_along_a_stretch) {
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0") == "within 2 to 4");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 0 0 0 1 0 0") == "within 0 to 1");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0 range 0 2.5") == "within 2 to 2.5");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 0 1 1 0 0") == "within 3 to 3");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 0 2 1 0 0") == "");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 3 0 0 1 0 0") == "");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0 range 0 1") == "");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 1 -2 0 0 0.5 0") == "within 4 to 6");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 1 -2 0 0 0.5 0 range 5 inf") == "within 5 to 6");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 1 2 0 0 0.5 0") == "");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray 2 -1 0 -1 1 0") == "within 1 to 2");
}

BOOST_AUTO_TEST_CASE(a_parallel_ray_off_the_surface_is_a_miss) {
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 1 0 1 0 0") == "");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 0.5 -2 0 0 1 0") == "");
  // Parallel to a generator of the cone: F is linear, and met once.
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray 1 -1 0 -1 1 0") == "proper 1.5");
}

BOOST_AUTO_TEST_CASE(t_counts_in_units_of_the_direction_as_given) {
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 0x1p-20") == "proper 2097152");
  BOOST_TEST(told("disk 0 0 0 0 0 -7 1 ray 0 0 -3 0 0 0x1p+40") == "proper 2.72848410532e-12");
}

BOOST_AUTO_TEST_CASE(overflow_and_underflow_are_decided_like_any_other_case) {
  BOOST_TEST(told("sphere 0 0 0 0x1p+1023 ray 0 0 -0x1.8p+1023 0 0 0x1p+1021") == "proper 2");
  BOOST_TEST(told("sphere 0 0 0 0x1p-1074 ray 0 0 -0x1.8p-1073 0 0 0x1p-1074") == "proper 2");
  BOOST_TEST(told("sphere 0 0 0 0x1p+1000 ray 0 0 0 0 0 0x1p-1000") == "proper 1.14813069527e602");
  BOOST_TEST(
      told("cylinder 0 0 0 0 0x1p-1000 0 0x1p+500 ray 0 0x1p-1001 0 0 0 1").starts_with("proper"));
}

BOOST_AUTO_TEST_CASE(rounded_t_is_infinite_or_zero_where_the_format_has_it_so) {
  const Case far = read("sphere 0 0 0 0x1p+1000 ray 0 0 0 0 0 0x1p-1000");
  const oracle::Crossing crossing = *oracle::truth(far).hit();
  BOOST_TEST(std::isinf(oracle::rounded<double>(far, crossing)));
  BOOST_TEST(oracle::rounded<long double>(far, crossing) == std::ldexp(1.0L, 2000));
  const Case near = read("sphere 0 0 0 0x1p-1000 ray 0 0 0 0 0 0x1p+100");
  BOOST_TEST(oracle::rounded<double>(near, *oracle::truth(near).hit()) == 0);
}

BOOST_AUTO_TEST_CASE(closed_forms_and_digits_are_exact) {
  const Case question = read("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2");
  const oracle::Spelled spelled = oracle::spelled(question, *oracle::truth(question).hit(), 40);
  BOOST_TEST(spelled.closed_form.value() == "(6 - sqrt(3)) / 4");
  BOOST_TEST(spelled.decimals == "1.066987298107780676618138414623531908264");
  BOOST_TEST(!spelled.terminates);
  const Case plain = read("disk 0 0 0 0 0 1 1 ray 0 0 -1 0 0 8");
  BOOST_TEST(oracle::spelled(plain, *oracle::truth(plain).hit(), 40).decimals == "0.125");
  BOOST_TEST(oracle::spelled(plain, *oracle::truth(plain).hit(), 40).terminates);
}

BOOST_AUTO_TEST_CASE(invalid_cases_are_named) {
  BOOST_TEST((why_invalid("sphere 0 0 0 1 ray 0 0 0 0 0 0") == Invalid::zero_direction));
  BOOST_TEST((why_invalid("disk 0 0 0 0 0 0 1 ray 0 0 0 0 0 1") == Invalid::zero_normal));
  BOOST_TEST((why_invalid("cylinder 1 2 3 1 2 3 1 ray 0 0 0 0 0 1") == Invalid::zero_axis));
  BOOST_TEST((why_invalid("cone 1 2 3 1 2 3 1 ray 0 0 0 0 0 1") == Invalid::zero_axis));
  BOOST_TEST((why_invalid("sphere 0 0 0 0 ray 0 0 0 0 0 1") == Invalid::radius));
  BOOST_TEST((why_invalid("sphere 0 0 0 -1 ray 0 0 0 0 0 1") == Invalid::radius));
  BOOST_TEST((why_invalid("sphere 0 0 0 1 ray 0 0 0 0 0 1 range 2 2") == Invalid::empty_range));
  BOOST_TEST((why_invalid("sphere 0 nan 0 1 ray 0 0 0 0 0 1") == Invalid::nan));
  BOOST_TEST((why_invalid("sphere 0 0 0 inf ray 0 0 0 0 0 1") == Invalid::infinite));
  BOOST_TEST((why_invalid("sphere 0 0 0 1 ray 0 0 0 0 0 1 range nan 2") == Invalid::nan));
  BOOST_TEST((why_invalid("sphere 0 0 0 1 ray 0 0 0 0 0 1") == Invalid::no));
}

BOOST_AUTO_TEST_CASE(every_root_is_told_with_its_standing) {
  const auto standings = [](std::string_view line) {
    std::string words;
    const oracle::Roots all = oracle::roots(read(line));
    for (const oracle::Root& root : all.roots())
      words += std::string(words.empty() ? "" : " ") + std::string(oracle::name(root.standing));
    return words;
  };
  BOOST_TEST(standings("sphere 0 0 0 1 ray 0 0 -3 0 0 1") == "acceptable later");
  BOOST_TEST(standings("sphere 0 0 0 1 ray 0 0 3 0 0 1") == "behind behind");
  BOOST_TEST(standings("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 3") == "acceptable past");
  BOOST_TEST(standings("cylinder 0 0 0 0 1 0 1 ray -3 2 0 1 0 0") == "clipped clipped");
  BOOST_TEST(standings("disk 0 0 0 0 1 0 1 ray 2 3 0 0 -1 0") == "clipped");
}

BOOST_AUTO_TEST_CASE(easy_cases_are_decided_by_intervals_and_ties_by_exact_numbers) {
  const auto stage = [](std::string_view line) { return oracle::truth(read(line)).stage; };
  BOOST_TEST((stage("sphere 0.1 0.2 0.3 1 ray 0 0 -3 0.1 0 1") == Stage::interval));
  BOOST_TEST((stage("sphere 0 0 0 0.1 ray 0 0.1 -3 0 0 1.1") == Stage::exact));
  BOOST_TEST((stage("disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0") == Stage::exact));
}

BOOST_AUTO_TEST_CASE(truth_is_the_same_alone_and_in_a_batch) {
  std::vector<Case> cases;
  for (int i = 0; i < 1000; ++i) {
    const double x = std::ldexp(i - 500, -8);
    cases.push_back({{{x, 0.25, -3}, {0, 0, 1}}, Sphere<double>{{0, 0, 0}, 1}});
  }
  std::vector<oracle::Truth> truths(cases.size());
  oracle::truth(cases, truths);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const oracle::Truth alone = oracle::truth(cases[i]);
    BOOST_REQUIRE(alone.count == truths[i].count);
    BOOST_TEST((alone.listed[0].t == truths[i].listed[0].t), case_line(cases[i]));
  }
}

BOOST_AUTO_TEST_CASE(a_thread_that_does_not_round_to_nearest_is_refused) {
  const Case question = read("sphere 0 0 0 1 ray 0 0 -3 0 0 1");
  std::fesetround(FE_UPWARD);
  BOOST_CHECK_THROW(oracle::truth(question), oracle::UnfitArithmetic);
  const std::string found = oracle::self_check().value_or("nothing");
  std::fesetround(FE_TONEAREST);
  BOOST_TEST(found == "this thread does not round to nearest");
  BOOST_CHECK_NO_THROW(oracle::truth(question));
}

BOOST_AUTO_TEST_CASE(the_oracle_leaves_the_rounding_mode_as_it_found_it) {
  oracle::truth(read("cone 0 0 0 0 1 0 1 ray -3 0.3 0 1 0.1 0"));
  BOOST_TEST(std::fegetround() == FE_TONEAREST);
}
