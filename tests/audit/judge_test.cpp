#include "audit/judge.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

/// The judgement of the answer that stands on a case line.
Judgement judged(std::string_view line, const Format& format = double_format,
                 const Convention& convention = {}) {
  const CaseLine read = read_case_line(line);
  return judge(read.question, read.answer.value(), format, convention);
}

/// Its verdict in words, with the claim where one is made.
std::string told(std::string_view line, const Convention& convention = {}) {
  const Judgement judgement = judged(line, double_format, convention);
  std::string words(name(judgement.verdict));
  if (judgement.claim != Claim::none) words += " " + std::string(name(judgement.claim));
  return words;
}

Convention declared(oracle::Kind kind, Convention::Stance stance) {
  Convention convention;
  convention.of(kind) = stance;
  return convention;
}

const std::string through = "sphere 0 0 0 1 ray 0 0 -3 0 0 1 ";
const std::string past = "sphere 0 0 0 1 ray 0 2 -3 0 0 1 ";
const std::string grazing = "sphere 0 0 0 1 ray 0 1 -3 0 0 1 ";
const std::string behind = "sphere 0 0 0 1 ray 0 0 3 0 0 1 ";
const std::string inside = "sphere 0 0 0 1 ray 0 0 0 0 0 1 ";
const std::string on_it = "sphere 0 0 0 1 ray 0 0 -1 0 0 1 ";
const std::string above = "cylinder 0 0 0 0 1 0 1 ray -3 2 0 1 0 0 ";
const std::string over_apex = "cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0 ";
const std::string in_plane = "disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0 ";
const std::string no_case = "sphere 0 0 0 1 ray 0 0 0 0 0 0 ";

}  // namespace

BOOST_AUTO_TEST_CASE(the_first_proper_hit_is_right) {
  BOOST_TEST(told(through + "hit 2") == "right");
  BOOST_TEST(told(through + "yes") == "right");
  BOOST_TEST(told(through + "at 0 0 -1") == "right");
  BOOST_TEST(told(inside + "hit 1") == "right");
}

BOOST_AUTO_TEST_CASE(a_miss_where_there_is_nothing_is_right) {
  BOOST_TEST(told(past + "miss") == "right");
  BOOST_TEST(told(behind + "miss") == "right");
}

BOOST_AUTO_TEST_CASE(a_miss_where_there_is_a_proper_hit_is_a_false_miss) {
  BOOST_TEST(told(through + "miss") == "false_miss");
  BOOST_TEST(told(on_it + "miss") == "false_miss");
}

BOOST_AUTO_TEST_CASE(a_hit_where_there_is_none_is_false_and_its_claim_is_told) {
  BOOST_TEST(told(past + "hit 3") == "false_hit no_root");
  BOOST_TEST(told(past + "hit nan") == "false_hit nan");
  BOOST_TEST(told(past + "hit inf") == "false_hit infinite");
  BOOST_TEST(told(behind + "hit -2") == "false_hit behind");
  BOOST_TEST(told(above + "hit 2") == "false_hit clipped");
  BOOST_TEST(told(over_apex + "hit 2.5") == "false_hit mirrored");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 1 hit 2") == "false_hit past");
  BOOST_TEST(told(past + "yes") == "false_hit no_root");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 3 1 0 0 -1 0 yes") == "false_hit clipped");
  BOOST_TEST(told(past + "at 0 0 0.5") == "false_hit no_root");
}

BOOST_AUTO_TEST_CASE(a_t_nearest_to_another_root_is_a_wrong_root) {
  BOOST_TEST(told(through + "hit 4") == "wrong_root later");
  BOOST_TEST(told(through + "hit 3.25") == "wrong_root later");
  BOOST_TEST(told(inside + "hit -1") == "wrong_root behind");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray -2 -0.75 0 1 0.5 0 hit 1") == "wrong_root clipped");
}

BOOST_AUTO_TEST_CASE(an_acceptable_root_wins_ties) {
  BOOST_TEST(told(through + "hit 3") == "wrong_t");
  // As far from one root as from the other, to whatever number of bits.
  BOOST_TEST(told("sphere 0 0 0 3 ray 0 0 0 1 1 1 hit 0") == "wrong_t");
  BOOST_TEST(told("sphere 0 0 0 0.1 ray 0 0 0 0.3 0.7 1.1 hit 0") == "wrong_t");
  BOOST_TEST(told("sphere 0 0 0 0.1 ray 0 0 0 0.3 0.7 1.1 hit 1e-9") == "wrong_t");
  BOOST_TEST(told(through + "hit 0x1.8000000000001p+1") == "wrong_root later");
}

BOOST_AUTO_TEST_CASE(an_acceptable_root_wins_a_tie_of_irrational_roots) {
  // The centre projects exactly between the two roots, whatever they are.
  BOOST_TEST(told("sphere 0x1.48ep-8 -0x1.c6dp-6 -0x1.435p-6 0x1.16e8p-5 ray -0x1.0a82dp-1 "
                  "0x1.1b9a8p-2 -0x1.dcp-3 0x1.39b1ep+3 -0x1.4dcdbp+2 0x1.19856p+2 "
                  "at 0x1.48ep-8 -0x1.c6dp-6 -0x1.435p-6") == "right");
  BOOST_TEST(told("sphere 1 2 3 0.3 ray 4.1 5.2 6.3 -3.1 -3.2 -3.3 at 1 2 3") == "wrong_t centre");
}

BOOST_AUTO_TEST_CASE(an_acceptable_root_wins_whenever_the_answer_is_within_an_ulp_of_it) {
  // The roots 2^52 and 2^52 + 2 of a unit sphere far away are two ulps apart.
  const std::string far = "sphere 0 0 0x1.0000000000001p+52 1 ray 0 0 0 0 0 1 ";
  BOOST_TEST(told(far + "hit 0x1.0000000000001p+52") == "right");
  BOOST_TEST(told(far + "hit 0x1.0000000000002p+52") == "wrong_root later");
}

BOOST_AUTO_TEST_CASE(the_right_root_off_by_much_is_a_wrong_t) {
  BOOST_TEST(told(through + "hit 2.25") == "wrong_t");
  BOOST_TEST(told(through + "hit 0x1.02p+1") == "right");  // off by 2^-7 of t exactly
  BOOST_TEST(told(through + "hit 0x1.0200000000001p+1") == "wrong_t");
  BOOST_TEST(told(through + "hit 0") == "wrong_t");
}

BOOST_AUTO_TEST_CASE(nan_and_infinity_are_not_finite_where_a_hit_is_acceptable) {
  BOOST_TEST(told(through + "hit nan") == "not_finite nan");
  BOOST_TEST(told(through + "hit inf") == "not_finite infinite");
  BOOST_TEST(told(through + "at nan 0 0") == "not_finite nan");
}

BOOST_AUTO_TEST_CASE(infinity_is_right_where_the_true_t_rounds_to_it) {
  const std::string far = "sphere 0 0 0 0x1p+1000 ray 0 0 0 0 0 0x1p-1000 ";
  BOOST_TEST(told(far + "hit inf") == "right");
  BOOST_TEST(told(far + "hit -inf") == "not_finite infinite");
}

BOOST_AUTO_TEST_CASE(zero_is_right_where_the_true_t_rounds_to_it) {
  BOOST_TEST(told("sphere 0 0 0 0x1p-1000 ray 0 0 0 0 0 0x1p+100 hit 0") == "right");
}

BOOST_AUTO_TEST_CASE(a_touch_may_be_taken_or_passed_by) {
  const Judgement taken = judged(grazing + "hit 3");
  BOOST_TEST((taken.verdict == Verdict::touch && taken.taken));
  BOOST_TEST((taken.touch == oracle::Kind::tangent));
  const Judgement passed = judged(grazing + "miss");
  BOOST_TEST((passed.verdict == Verdict::touch && !passed.taken));
  BOOST_TEST(told(on_it + "hit 0") == "touch");
  BOOST_TEST(told(on_it + "hit 2") == "right");
  BOOST_TEST(told(in_plane + "hit 2.5") == "touch");
  BOOST_TEST(told(in_plane + "yes") == "touch");
  BOOST_TEST(told(in_plane + "miss") == "touch");
}

BOOST_AUTO_TEST_CASE(a_declared_convention_is_held) {
  using Stance = Convention::Stance;
  const Convention hits = declared(oracle::Kind::tangent, Stance::hit);
  BOOST_TEST(told(grazing + "miss", hits) == "false_miss");
  BOOST_TEST(told(grazing + "hit 3", hits) == "right");
  const Convention misses = declared(oracle::Kind::tangent, Stance::miss);
  BOOST_TEST(told(grazing + "miss", misses) == "right");
  BOOST_TEST(told(grazing + "hit 3", misses) == "false_hit declined");
  const Convention no_start = declared(oracle::Kind::start, Stance::miss);
  BOOST_TEST(told(on_it + "hit 0", no_start) == "wrong_root declined");
  const Convention start = declared(oracle::Kind::start, Stance::hit);
  BOOST_TEST(told(on_it + "hit 2", start) == "wrong_root declined");
}

BOOST_AUTO_TEST_CASE(a_hit_from_inside_may_be_declared_to_be_none) {
  Convention misses;
  misses.inside = Convention::Inside::miss;
  BOOST_TEST(told(inside + "miss", misses) == "right");
  BOOST_TEST(told(inside + "hit 1", misses) == "false_hit declined");
  BOOST_TEST(told(through + "hit 2", misses) == "right");
  BOOST_TEST(told(through + "miss", misses) == "false_miss");
  BOOST_TEST(told(on_it + "hit 2", misses) == "wrong_root declined");
  BOOST_TEST(told(on_it + "hit 0", misses) == "touch");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 0 1 0 0 -1 0 hit 1", misses) == "right");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray 0 -1 0 0 1 0 hit 1", misses) == "right");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 0 0.5 0 1 0 0 miss", misses) == "right");
}

BOOST_AUTO_TEST_CASE(a_hit_from_inside_may_be_declared_to_be_the_start) {
  Convention start;
  start.inside = Convention::Inside::start;
  BOOST_TEST(told(inside + "hit 0", start) == "right");
  BOOST_TEST(told(inside + "at 0 0 0", start) == "right");
  BOOST_TEST(told(inside + "yes", start) == "right");
  BOOST_TEST(told(inside + "hit 1", start) == "wrong_root declined");
  BOOST_TEST(told(inside + "hit nan", start) == "not_finite nan");
  BOOST_TEST(told(inside + "miss", start) == "false_miss");
  BOOST_TEST(told(through + "hit 2", start) == "right");
  BOOST_TEST(told("sphere 0 0 0 1 ray 0 0 0 0 0 1 range 0.5 9 hit 0.5", start) == "right");
}

BOOST_AUTO_TEST_CASE(what_stands_in_place_of_an_answer_is_a_verdict_of_its_own) {
  BOOST_TEST(told(through + "crashed") == "crashed");
  BOOST_TEST(told(past + "crashed") == "crashed");
  BOOST_TEST(told(through + "garbage") == "crashed garbage");
  BOOST_TEST(told(grazing + "timed_out") == "timed_out");
  BOOST_TEST(told(no_case + "crashed") == "invalid_mishandled ended");
  BOOST_TEST(told(no_case + "garbage") == "invalid_mishandled garbage");
  BOOST_TEST(told(no_case + "timed_out") == "invalid_mishandled hung");
  for (const Verdict verdict : {Verdict::crashed, Verdict::timed_out})
    BOOST_TEST(is_wrong(verdict));
}

BOOST_AUTO_TEST_CASE(a_t_past_a_stretch_is_measured_from_its_end) {
  // The ray lies in the disk from 1 to 2000001; the answer is 16 ulps past that.
  const std::string along = "disk 0 0 0 0 1 0 1000000 ray -1000001 0 0 1 0 0 ";
  const Judgement past_it = judged(along + "hit 0x1.e84810000001p+20");
  BOOST_TEST((past_it.verdict == Verdict::touch));
  BOOST_TEST(past_it.ulps == 16);
  BOOST_TEST(judged(along + "hit 1000").ulps == 0);
  const Convention hits = declared(oracle::Kind::within, Convention::Stance::hit);
  BOOST_TEST(told(along + "hit 0x1.e84810000001p+20", hits) == "right");
}

BOOST_AUTO_TEST_CASE(a_sentinel_answer_is_named) {
  BOOST_TEST(told("sphere 1 2 3 1 ray 9 9 9 1 0 0 at 1 2 3") == "false_hit centre");
  BOOST_TEST(told("sphere 1 2 3 1 ray 1 2 0 0 0 1 at 1 2 3") == "wrong_t centre");
  BOOST_TEST(told("sphere 0 0 1 1 ray 0 0 -3 0 0 1 miss") == "false_miss origin");
  BOOST_TEST(told("sphere 0 0 1 1 ray 0 0.1 -3 0 0 1 miss") == "false_miss");
}

BOOST_AUTO_TEST_CASE(a_hit_of_a_parallel_ray_is_told_so) {
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 1 0 1 0 0 yes") == "false_hit parallel");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 1 0 1 0 0 hit inf") == "false_hit infinite");
  BOOST_TEST(told("disk 0 0 0 0 1 0 1 ray -3 0 2 1 0 0 hit 3") == "false_hit parallel");
  BOOST_TEST(told("cylinder 0 0 0 0 1 0 1 ray 0.5 -3 0 0 1 0 hit 3") == "false_hit parallel");
}

BOOST_AUTO_TEST_CASE(an_invalid_case_asks_for_a_clear_miss) {
  BOOST_TEST(told(no_case + "miss") == "invalid_handled");
  BOOST_TEST(told(no_case + "hit 1") == "invalid_mishandled");
  BOOST_TEST(told(no_case + "hit nan") == "invalid_mishandled");
  BOOST_TEST(told(no_case + "yes") == "invalid_mishandled");
}

BOOST_AUTO_TEST_CASE(errors_are_counted_in_ulps_of_the_format_at_the_exact_t) {
  BOOST_TEST(judged(through + "hit 2").ulps == 0);
  BOOST_TEST(judged(through + "hit 0x1.0000000000001p+1").ulps == 1);
  BOOST_TEST(judged(through + "hit 0x1.fffffffffffffp+0").ulps == 0.5);
  BOOST_TEST(judged(through + "hit 0x1.000002p+1", float_format).ulps == 1);
  BOOST_TEST(judged(through + "hit 0x1.0000000000001p+1", long_double_format).ulps == 2048);
  BOOST_TEST(judged(through + "hit 0x1.01p+1").relative == 0x1p-8);
}

BOOST_AUTO_TEST_CASE(a_correctly_rounded_t_has_at_most_half_an_ulp) {
  const std::string line = "sphere 0 0 0 1 ray 0 0.5 -3 0 0 2 ";
  BOOST_TEST(judged(line + "hit 0x1.1126145e9ecd5p+0").ulps <= 0.5);
  BOOST_TEST(judged(line + "hit 0x1.1126145e9ecd4p+0").ulps > 0.5);
}

BOOST_AUTO_TEST_CASE(the_forced_error_is_what_rounding_the_inputs_would_do) {
  // t = (z_c - r - z_o) / d: |z_o t'| + |d t'| + |z_c t'| + |r t'| = 3 + 2 + 0 + 1 in units of u.
  const Judgement judgement = judged(through + "hit 0x1.0000000000001p+1");
  BOOST_TEST(judgement.forced == 4.0 / 6.0, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_rounded_point_has_a_distance_and_a_side) {
  const Judgement on = judged(through + "hit 2");
  BOOST_TEST((on.side == Side::on && on.distance == 0));
  const Judgement short_of = judged(through + "hit 0x1.fffffffffffffp+0");
  BOOST_TEST((short_of.side == Side::before));
  BOOST_TEST(short_of.distance == 1, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((judged(through + "hit 0x1.0000000000001p+1").side == Side::beyond));
  BOOST_TEST((judged(inside + "hit 0x1.fffffffffffffp-1").side == Side::before));
  BOOST_TEST((judged("disk 0 0 0 0 1 0 1 ray 0 3 0 0 -1 0 hit 0x1.8000000000001p+1").side ==
              Side::beyond));
  BOOST_TEST((judged("disk 0 0 0 0 -5 0 1 ray 0 3 0 0 -1 0 hit 0x1.8000000000001p+1").side ==
              Side::beyond));
}

BOOST_AUTO_TEST_CASE(false_answers_are_not_measured) {
  BOOST_TEST(std::isnan(judged(through + "hit 4").ulps));
  BOOST_TEST(std::isnan(judged(past + "hit 4").ulps));
}
