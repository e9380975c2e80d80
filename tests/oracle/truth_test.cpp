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
std::string told(std::string_view line, Extent extent = Extent::bounded) {
  Case question = read(line);
  question.extent = extent;
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

const std::string can = "capped_cylinder 0 0 0 0 1 0 1 ray ";
const std::string tent = "capped_cone 0 0 0 0 1 0 1 ray ";

BOOST_AUTO_TEST_CASE(a_closed_shape_is_met_on_its_lateral_surface_or_on_a_cap) {
  BOOST_TEST(told(can + "-3 0.5 0 1 0 0") == "proper 2");
  BOOST_TEST(told(can + "0 2 0 1 -2 0") == "proper 0.5");
  BOOST_TEST(told(can + "0 -2 0 1 4 0") == "proper 0.5");
  BOOST_TEST(told(can + "-3 2 0 1 0 0") == "");
  BOOST_TEST(told(can + "-3 0.5 2 1 0 0") == "");
  BOOST_TEST(told(tent + "-3 0.5 0 1 0 0") == "proper 2.5");
  BOOST_TEST(told(tent + "0.25 -3 0 0 2 0") == "proper 1.5");
  BOOST_TEST(told(tent + "-3 1.5 0 1 0 0") == "");
  // Parallel to a generator: in by the base, out at the other side.
  BOOST_TEST(told(tent + "0.5 -1 0 -1 1 0") == "proper 1");
  BOOST_TEST(told(tent + "0.5 -1 0 -1 1 0 range 1.125 inf") == "proper 1.25");
}

BOOST_AUTO_TEST_CASE(a_ray_that_starts_inside_a_closed_shape_leaves_it_where_it_comes_out) {
  BOOST_TEST(told(can + "0 0.5 0 0 1 0") == "proper 0.5");
  BOOST_TEST(told(can + "0 0.5 0 0 -2 0") == "proper 0.25");
  BOOST_TEST(told(can + "0 0.5 0 1 0 0") == "proper 1");
  BOOST_TEST(told(can + "0 0.5 0 1 0.25 0") == "proper 1");
  BOOST_TEST(told(can + "0 0.5 0 1 1 0") == "proper 0.5");
  BOOST_TEST(told(tent + "0 0.5 0 0 -1 0") == "proper 0.5");
  BOOST_TEST(told(tent + "0 0.5 0 1 0 0") == "proper 0.5");
}

BOOST_AUTO_TEST_CASE(an_edge_of_a_closed_shape_is_passed_or_touched_like_any_place_of_its_surface) {
  BOOST_TEST(told(can + "-2 2 0 1 -1 0") == "proper 1");
  BOOST_TEST(told(can + "-2 2 0 1 -1 0 range 1.5 inf") == "proper 2");
  BOOST_TEST(told(can + "-2 0 0 1 1 0") == "rim 1");
  BOOST_TEST(told(can + "-2 -1 0 1 1 0") == "proper 1");
  BOOST_TEST(told(can + "0 0 0 1 1 0 range 0x1p-1 inf") == "proper 1");
  BOOST_TEST(told(tent + "-3 -1 0 2 1 0") == "proper 1");
  BOOST_TEST(told(tent + "-2 1 0 1 -1 0") == "rim 1");
  // Tangent to the lateral surface, at its edge.
  BOOST_TEST(told(can + "-3 -2 1 1 1 0") == "rim 3");
  BOOST_TEST(told(can + "-3 -2.5 1 1 1 0") == "tangent 3");
  BOOST_TEST(told(can + "-3 -1 1 1 1 0") == "");
  // From edge to edge.
  BOOST_TEST(told(can + "-2 1.5 0 2 -1 0") == "proper 0.5");
  BOOST_TEST(told(can + "-2 1.5 0 2 -1 0 range 1 inf") == "proper 1.5");
}

BOOST_AUTO_TEST_CASE(the_apex_of_a_closed_cone_is_entered_left_or_touched) {
  BOOST_TEST(told(tent + "0 3 0 0 -1 0") == "proper 2");
  BOOST_TEST(told(tent + "0 3 0 0 -1 0 range 2.5 inf") == "proper 3");
  BOOST_TEST(told(tent + "0 0.5 0 0 1 0") == "proper 0.5");
  BOOST_TEST(told(tent + "-3 1 0 1 0 0") == "apex 3");
  BOOST_TEST(told(tent + "-4 2 0 4 -1 0") == "apex 1");
}

BOOST_AUTO_TEST_CASE(a_ray_in_a_patch_of_a_closed_shape_is_within_it) {
  BOOST_TEST(told(can + "-3 1 0 1 0 0") == "within 2 to 4");
  BOOST_TEST(told(can + "-3 0 0 1 0 0 range 0 2.5") == "within 2 to 2.5");
  BOOST_TEST(told(can + "-3 1 1 1 0 0") == "within 3 to 3");
  BOOST_TEST(told(can + "-3 1 2 1 0 0") == "");
  BOOST_TEST(told(can + "1 -2 0 0 0.5 0") == "within 4 to 6");
  BOOST_TEST(told(can + "2 -2 0 0 0.5 0") == "");
  BOOST_TEST(told(tent + "-3 0 0 1 0 0") == "within 2 to 4");
  BOOST_TEST(told(tent + "2 -1 0 -1 1 0") == "within 1 to 2");
}

BOOST_AUTO_TEST_CASE(a_range_may_end_on_a_cap) {
  BOOST_TEST(told(can + "0.25 3 0 0 -1 0") == "proper 2");
  BOOST_TEST(told(can + "0.25 3 0 0 -1 0 range 2 inf") == "start 2, proper 3");
  BOOST_TEST(told(can + "0.25 3 0 0 -1 0 range 0 2") == "end 2");
  BOOST_TEST(told(can + "0.25 3 0 0 -1 0 range 2.5 3") == "end 3");
  BOOST_TEST(told(can + "0.25 1 0 0 -1 0") == "start 0, proper 1");
  BOOST_TEST(told(can + "0.25 1 0 0 1 0") == "start 0");
  BOOST_TEST(told(can + "1 1 0 -1 -1 0") == "start 0, proper 1");
  BOOST_TEST(told(tent + "0 1 0 0 -1 0") == "start 0, proper 1");
}

BOOST_AUTO_TEST_CASE(the_patch_of_a_crossing_is_told_and_an_edge_is_its_caps) {
  const auto patch = [](const std::string& line) {
    return int{oracle::truth(read(line)).listed[0].patch};
  };
  BOOST_TEST(patch(can + "-3 0.5 0 1 0 0") == 0);
  BOOST_TEST(patch(can + "0 2 0 1 -2 0") == 2);
  BOOST_TEST(patch(can + "0 -2 0 1 4 0") == 1);
  BOOST_TEST(patch(can + "-2 2 0 1 -1 0") == 2);
  BOOST_TEST(patch(can + "-3 1 0 1 0 0") == 2);
  BOOST_TEST(patch(can + "1 -2 0 0 0.5 0") == 0);
  BOOST_TEST(patch(tent + "0 3 0 0 -1 0") == 0);
  BOOST_TEST(patch(tent + "0.25 -3 0 0 2 0") == 1);
  // By an edge 2^40 away, a little beside it on either side.
  const std::string far = "-0x1.00000000010p+40 ", beside = " 0 1 -1 0";
  BOOST_TEST(patch(can + far + "0x1.00000000014p+40" + beside) == 2);
  BOOST_TEST(patch(can + far + "0x1.0000000000cp+40" + beside) == 0);
}

BOOST_AUTO_TEST_CASE(closed_shapes_of_any_size_are_decided) {
  for (const int e : {-700, -100, 100, 700}) {
    Case question = read("capped_cylinder 0 0 0 0 1 0 1 ray -2 2 0 1 -1 0");
    auto& shape = std::get<CappedCylinder<double>>(question.shape);
    shape.top.y = shape.radius = std::ldexp(1, e);
    question.ray.origin = {std::ldexp(-2, e), std::ldexp(2, e), 0};
    const oracle::Truth truth = oracle::truth(question);
    BOOST_TEST_REQUIRE(truth.count == 1);
    BOOST_TEST((truth.listed[0].kind == Kind::proper));
    BOOST_TEST(nearest<double>(truth.listed[0].t) == std::ldexp(1, e));
  }
  BOOST_TEST(told("capped_cone 0 0 0 0 0x1p-1000 0 0x1p+500 ray 0 -2 0 0 1 0") == "proper 2");
}

BOOST_AUTO_TEST_CASE(an_endless_surface_has_no_rim) {
  using enum Extent;
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 5 3 0 0 -1 0", unbounded) == "proper 3");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 1 3 0 0 -1 0", unbounded) == "proper 3");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 5 3 0 1 0 0", unbounded) == "");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray -3 9 0 1 0 0", unbounded) == "proper 2");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", unbounded) == "proper 2");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 0 9 0 0 1 0", unbounded) == "");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -9 -4 0 1 0 0", unbounded) == "proper 4");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -9 2 0 1 0 0", unbounded) == "");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -9 2 0 1 0 0", both_nappes) == "proper 8");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -9 -4 0 1 0 0", both_nappes) == "proper 4");
}

BOOST_AUTO_TEST_CASE(the_apex_of_a_double_cone_is_a_touch_for_no_side_of_it_is_left) {
  using enum Extent;
  const std::string along = "cone 0 0 0 0 1 0 1 ray 0 -3 0 0 2 0";
  BOOST_TEST(told(along, unbounded) == "proper 2");
  BOOST_TEST(told(along, both_nappes) == "apex 2");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", both_nappes) == "apex 3");
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0", unbounded) == "apex 3");
  // Tangent to the mirrored nappe, along the plane x + y = 1 + z of its generator.
  BOOST_TEST(told("cone 0 0 0 0 1 0 1 ray 1 2 -2 0 0 1", both_nappes) == "tangent 2");
}

BOOST_AUTO_TEST_CASE(a_ray_in_an_endless_surface_is_within_it_for_all_its_range) {
  using enum Extent;
  const std::string plane = "disk 0 0 0 0 1 0 1 ray -3 0 5 1 0 0";
  BOOST_TEST(told(plane, unbounded) == "within 0 to inf");
  BOOST_TEST(told(plane + " range -inf inf", unbounded) == "within -inf to inf");
  BOOST_TEST(told(plane + " range 1 2", unbounded) == "within 1 to 2");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 1 -2 0 0 0.5 0", unbounded) == "within 0 to inf");
  const std::string generator = "cone 0 0 0 0 1 0 1 ray 2 -1 0 -1 1 0 range -inf inf";
  BOOST_TEST(told(generator, unbounded) == "within -inf to 2");
  BOOST_TEST(told(generator, both_nappes) == "within -inf to inf");
  Case question = read(plane);
  question.extent = unbounded;
  const oracle::Crossing crossing = oracle::truth(question).listed[0];
  BOOST_TEST(oracle::rounded<float>(question, crossing) == 0);
  BOOST_TEST(std::isinf(oracle::rounded_last<float>(question, crossing)));
  BOOST_TEST(std::isinf(oracle::rounded_last<long double>(question, crossing)));
}

BOOST_AUTO_TEST_CASE(what_is_closed_has_no_other_extent) {
  for (const Extent extent : {Extent::unbounded, Extent::both_nappes}) {
    BOOST_TEST(told(can + "-3 2 0 1 0 0", extent) == "");
    BOOST_TEST(told(can + "0 2 0 1 -2 0", extent) == "proper 0.5");
    BOOST_TEST(told(tent + "-3 1.5 0 1 0 0", extent) == "");
    BOOST_TEST(told(tent + "0 3 0 0 -1 0", extent) == "proper 2");
    BOOST_TEST(told("sphere 0 0 0 1 ray 0 1 -3 0 0 1", extent) == "tangent 3");
  }
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
  // Base, lateral surface, top, lateral surface.
  BOOST_TEST(standings(can + "-3 0.5 0 8 1.5 0") == "behind acceptable later clipped");
  BOOST_TEST(standings(can + "3 0.5 0 -8 1.5 0") == "behind acceptable later clipped");
  BOOST_TEST(standings(can + "3 0.5 0 -8 -1.5 0") == "behind acceptable later clipped");
  // An edge is one root of two patches.
  BOOST_TEST(standings(can + "-2 2 0 1 -1 0") == "acceptable later clipped");
  BOOST_TEST(standings(tent + "-3 1.5 0 1 0 0") == "mirrored mirrored");
  BOOST_TEST(standings(tent + "-0.5 3 0 0.25 -1 0") == "acceptable later");
}

BOOST_AUTO_TEST_CASE(easy_cases_are_decided_by_lanes_or_intervals_and_ties_by_integers) {
  const auto stage = [](std::string_view line) { return oracle::truth(read(line)).stage; };
  BOOST_TEST((stage("sphere 0.1 0.2 0.3 1 ray 0 0 -3 0.1 0 1") == Stage::lanes));
  const Case grazing = read("sphere 0 0 0 1 ray 0 0x1.fffffffep-1 -3 0 0 1");
  BOOST_TEST((oracle::truth(grazing, 63).stage == Stage::lanes));
  BOOST_TEST((oracle::truth(grazing, 88).stage == Stage::wide_lanes));
  BOOST_TEST((stage("disk 0 0 0 0 1 0 1 unbounded ray 0.1 2 0.3 0.1 -1 0") == Stage::interval));
  BOOST_TEST((stage("sphere 0 0 0 1 ray 0 1 -3 0 0 1") == Stage::integers));
  BOOST_TEST((stage("sphere 0 0 0 0.1 ray 0 0.1 -3 0 0 1.1") == Stage::integers));
  BOOST_TEST((stage("disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0") == Stage::integers));
  BOOST_TEST((stage("disk 0 0 0 0 1 0 1 unbounded ray -3 0 0 1 0 0") == Stage::integers));
  // Of numbers too far apart for those.
  BOOST_TEST((stage("sphere 0 0 0 1e-30 ray 0 1e-30 -3 0 0 1.1") == Stage::exact));
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
    BOOST_TEST((alone.stage == truths[i].stage), case_line(cases[i]));
    for (int k = 0; k < alone.count; ++k)
      BOOST_TEST((alone.listed[k].t == truths[i].listed[k].t), case_line(cases[i]));
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
