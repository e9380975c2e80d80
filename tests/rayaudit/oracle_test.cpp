#include "rayaudit/oracle.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>
#ifdef __SSE2__
#include <immintrin.h>
#endif

using namespace rayaudit;

namespace rayaudit {
inline namespace face {
std::ostream& operator<<(std::ostream& to, Invalid word) { return to << name(word); }
std::ostream& operator<<(std::ostream& to, Kind word) { return to << name(word); }
std::ostream& operator<<(std::ostream& to, Verdict word) { return to << name(word); }
std::ostream& operator<<(std::ostream& to, Claim word) { return to << name(word); }
std::ostream& operator<<(std::ostream& to, Side word) { return to << name(word); }
}  // namespace face
}  // namespace rayaudit

namespace {

const Case half_up = question_of(ray({0, 0.5, -3}, {0, 0, 1}), sphere({0, 0, 0}, 1));
const Case tangent = question_of("sphere 0 0 0 1 ray 0 1 -3 0 0 1");
/// (6 - sqrt(3)) / 2
constexpr long double half_up_t = 2.133974596215561353236276829247063816529L;

Verdict verdict(const Answer& answer, const Case& question, const Convention& convention = {}) {
  return judge(answer, question, convention).verdict;
}

}  // namespace

BOOST_AUTO_TEST_CASE(t_is_correctly_rounded_to_each_format) {
  const Truth known = truth(half_up);
  BOOST_TEST((known.t() == 0x1.1126145e9ecd5p+1));
  BOOST_TEST((known.t<float>() == 0x1.112614p+1f));
  BOOST_TEST((known.t<long double>() == half_up_t));
}

BOOST_AUTO_TEST_CASE(a_t_beside_the_middle_of_two_floats_goes_to_the_nearer) {
  // 2^-74 below it, where the double nearest to t is the middle itself, and the other float even.
  const Truth known = truth(
      question_of("disk 0 0 0 0 0 1 1 ray 0 0 0x1.0000030000001p+0 0 0 -0x1.0000000000001p+0"));
  BOOST_TEST((known.t() == 0x1.000003p+0));
  BOOST_TEST((known.t<float>() == 0x1.000002p+0f));
}

BOOST_AUTO_TEST_CASE(a_t_beyond_double_is_one_in_long_double) {
  const Truth known = truth(question_of("sphere 0 0 0 1 ray 0 0 -2 0 0 0x1p-1074"));
  BOOST_TEST((known.t() == std::numeric_limits<double>::infinity()));
  BOOST_TEST((known.t<long double>() == 0x1p+1074L));
}

BOOST_AUTO_TEST_CASE(a_miss_has_no_t) {
  const Truth known = truth(question_of("sphere 0 0 0 1 ray 0 2 -3 0 0 1"));
  BOOST_TEST(!known.hit);
  BOOST_TEST(!known.t());
  BOOST_TEST(known.crossings.empty());
}

BOOST_AUTO_TEST_CASE(touches_come_before_the_hit_with_their_kinds) {
  const Truth known = truth(question_of("cylinder 0 0 0 0 1 0 1 ray -3 0 0 1 0.25 0"));
  BOOST_TEST(truth(tangent).crossings.at(0).kind == static_cast<int>(Kind::tangent));
  BOOST_TEST(!truth(tangent).hit);
  BOOST_TEST((known.t() == 2));
  const Truth within = truth(question_of("cylinder 0 0 0 0 1 0 1 ray 1 -2 0 0 0.5 0"));
  BOOST_TEST(within.crossings.at(0).kind == static_cast<int>(Kind::within));
  BOOST_TEST(within.crossings[0].t.in_double == 4);
  BOOST_TEST(within.crossings[0].t_last.in_double == 6);
  BOOST_TEST(within.crossings[0].t_last.in_long_double == 6);
}

BOOST_AUTO_TEST_CASE(invalid_cases_are_named) {
  const auto invalid = [](const char* line) { return truth(question_of(line)).invalid; };
  BOOST_TEST(invalid("sphere 0 0 0 1 ray 0 0 -3 0 0 1") == Invalid::no);
  BOOST_TEST(invalid("sphere 0 0 0 1 ray 0 0 -3 0 0 0") == Invalid::zero_direction);
  BOOST_TEST(invalid("disk 0 0 0 0 0 0 1 ray 0 0 -3 0 0 1") == Invalid::zero_normal);
  BOOST_TEST(invalid("cone 0 0 0 0 0 0 1 ray 0 0 -3 0 0 1") == Invalid::zero_axis);
  BOOST_TEST(invalid("sphere 0 0 0 0 ray 0 0 -3 0 0 1") == Invalid::radius);
  BOOST_TEST(invalid("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 2 1") == Invalid::empty_range);
}

BOOST_AUTO_TEST_CASE(many_at_once_have_the_truths_of_each) {
  std::vector<Case> questions;
  questions.reserve(2500);
  for (int i = 0; i < 2500; ++i)
    questions.push_back(question_of(ray({0, i / 1024.0, -3}, {0, 0, 1}), sphere({0, 0, 0}, 1)));
  const std::vector<Truth> known = truths(questions);
  BOOST_REQUIRE(known.size() == questions.size());
  for (std::size_t i = 0; i < questions.size(); i += 7)
    BOOST_TEST((known[i].t<long double>() == truth(questions[i]).t<long double>()),
               case_line(questions[i]));
}

BOOST_AUTO_TEST_CASE(answers_are_judged_in_their_own_format) {
  BOOST_TEST(verdict(hit(2.125), half_up) == Verdict::right);
  BOOST_TEST(judge(hit(0x1.112614p+1f), half_up).ulps < 0.5);
  BOOST_TEST(judge(hit(0x1.112614p+1), half_up).ulps > 1e6);
  BOOST_TEST(judge(hit(half_up_t), half_up).ulps < 0.5);
  BOOST_TEST(judge(hit(static_cast<double>(half_up_t)), half_up).ulps > 0.01);
}

BOOST_AUTO_TEST_CASE(every_form_of_answer_is_taken) {
  BOOST_TEST(verdict(true, half_up) == Verdict::right);
  BOOST_TEST(verdict(false, half_up) == Verdict::false_miss);
  BOOST_TEST(verdict(std::optional<float>(), half_up) == Verdict::false_miss);
  BOOST_TEST(judge(std::optional<float>(0x1.112614p+1f), half_up).ulps < 0.5);
  BOOST_TEST(verdict(hit_if(false, 2.0f), half_up) == Verdict::false_miss);
  BOOST_TEST(verdict(hit_if(true, 3.9f), half_up) == Verdict::wrong_root);
  BOOST_TEST(verdict(at(0.0, 0.5, -0x1.bb67ae8584caap-1), half_up) == Verdict::right);
  BOOST_TEST(verdict(at(0.0, 0.5, 0x1.bb67ae8584caap-1), half_up) == Verdict::wrong_root);
  BOOST_TEST(verdict(miss(), half_up) == Verdict::false_miss);
  BOOST_TEST(verdict(hit(std::nan("")), half_up) == Verdict::not_finite);
}

BOOST_AUTO_TEST_CASE(a_judgement_tells_what_was_measured) {
  const Judgement wrong = judge(hit(3.866025f), half_up);
  BOOST_TEST(wrong.claim == Claim::later);
  BOOST_TEST(std::isnan(wrong.ulps));
  const Judgement right = judge(hit(2.125f), half_up);
  BOOST_TEST(right.side == Side::before);
  BOOST_TEST(right.relative == 1 - 2.125 / 2.1339745962155614, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(right.margin == 1.6e6, boost::test_tools::tolerance(0.05));
  BOOST_TEST(judge(hit(2.125), half_up).margin == 8.4e14, boost::test_tools::tolerance(0.05));
  const Judgement touch = judge(hit(3.0), tangent);
  BOOST_TEST(touch.verdict == Verdict::touch);
  BOOST_TEST((touch.touch == Kind::tangent));
  BOOST_TEST(touch.taken);
  BOOST_TEST(!judge(miss(), tangent).taken);
  BOOST_TEST(touch.margin == 0);
}

BOOST_AUTO_TEST_CASE(a_convention_is_held) {
  Convention convention = {};
  convention.tangent = RAYAUDIT_IS_MISS;
  BOOST_TEST(verdict(hit(3.0), tangent, convention) == Verdict::false_hit);
  convention.tangent = RAYAUDIT_IS_HIT;
  BOOST_TEST(verdict(miss(), tangent, convention) == Verdict::false_miss);
  BOOST_TEST(!agrees(tangent, miss(), {0, convention}));
  Convention inside = {};
  inside.inside = RAYAUDIT_INSIDE_IS_MISS;
  BOOST_TEST(verdict(miss(), question_of("sphere 0 0 0 1 ray 0 0 0 0 0 1"), inside) ==
             Verdict::right);
}

BOOST_AUTO_TEST_CASE(a_case_is_posed_as_the_convention_has_it) {
  Convention convention = {};
  convention.unit_direction = 1;
  const Case twice = question_of("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2 range 0 8");
  BOOST_TEST(case_line(posed(twice, convention)) ==
             case_line(question_of("sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 range 0 16")));
}

BOOST_AUTO_TEST_CASE(a_posed_case_has_the_form_that_is_declared_and_stays) {
  Convention convention = {};
  convention.extent = RAYAUDIT_UNBOUNDED, convention.stand = RAYAUDIT_UPRIGHT_Z;
  convention.segment = 1;
  const Case drawn = question_of("cylinder 1 2 3 5 2 3 0.5 ray 1 -6 3 0 1 0");
  const Case made = posed(drawn, convention, Format::in_float);
  BOOST_TEST(case_line(made) == case_line(question_of("cylinder 0 0 -2 0 0 2 0.5 unbounded "
                                                      "ray -8 0 -2 32 0 0 range 0 1")));
  BOOST_TEST(case_line(posed(made, convention, Format::in_float)) == case_line(made));
  convention.stand = RAYAUDIT_ANYWHERE, convention.opening = RAYAUDIT_BY_ANGLE;
  BOOST_CHECK_THROW(posed(drawn, convention), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(closed_and_endless_shapes_are_questions_too) {
  const auto line_of = [](const auto&... shape) {
    return case_line(question_of(ray({0, 0, -3}, {0, 0, 1}), shape...));
  };
  const auto is = [](const std::string& shape) {
    return case_line(question_of(shape + " ray 0 0 -3 0 0 1"));
  };
  BOOST_TEST(line_of(capped_cylinder({1, 2, 3}, {4, 5, 6}, 7)) ==
             is("capped_cylinder 1 2 3 4 5 6 7"));
  BOOST_TEST(line_of(capped_cone({1, 2, 3}, {4, 5, 6}, 7)) == is("capped_cone 1 2 3 4 5 6 7"));
  BOOST_TEST(line_of(cylinder({1, 2, 3}, {4, 5, 6}, 7)) == is("cylinder 1 2 3 4 5 6 7"));
  BOOST_TEST(line_of(disk({1, 2, 3}, {4, 5, 6}, 7), Extent::unbounded) ==
             is("disk 1 2 3 4 5 6 7 unbounded"));
  BOOST_TEST(line_of(cylinder({1, 2, 3}, {4, 5, 6}, 7), Extent::unbounded) ==
             is("cylinder 1 2 3 4 5 6 7 unbounded"));
  BOOST_TEST(line_of(cone({1, 2, 3}, {4, 5, 6}, 7), Extent::both_nappes) ==
             is("cone 1 2 3 4 5 6 7 both_nappes"));
  const Case up =
      question_of(ray({0, 0, -3}, {0, 0, 1}), capped_cylinder({0, 0, -1}, {0, 0, 1}, 1));
  BOOST_TEST((truth(up).t() == 2));
  const Case plane =
      question_of(ray({9, 0, -3}, {0, 0, 1}), disk({0, 0, 0}, {0, 0, 1}, 1), Extent::unbounded);
  BOOST_TEST((truth(plane).t() == 3));
}

BOOST_AUTO_TEST_CASE(agreement_is_not_being_wrong_within_the_ulps_allowed) {
  BOOST_TEST(!!agrees(half_up, hit(2.125f)));
  BOOST_TEST(!agrees(half_up, hit(2.125f), {1}));
  BOOST_TEST(!!agrees(half_up, hit(0x1.112614p+1f), {0.5}));
  BOOST_TEST(!agrees(half_up, hit(0x1.112616p+1f), {0.5}));
  BOOST_TEST(!!agrees(half_up, true, {0.5}));
  BOOST_TEST(!!agrees(tangent, hit(3.0), {0.5}));
  BOOST_TEST(!!agrees(tangent, miss(), {0.5}));
  BOOST_TEST(!agrees(half_up, miss()));
}

BOOST_AUTO_TEST_CASE(a_failure_tells_what_a_person_needs) {
  BOOST_TEST(
      agrees(half_up, std::optional<float>()).text() ==
      "case     sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x1p-1 -0x1.8p+1 0x0p+0 0x0p+0 "
      "0x1p+0\n"
      "got      miss\n"
      "truth    hit 0x1.112614p+1 (2.1339746)\n"
      "verdict  false_miss: a miss where there is a hit\n"
      "margin   1.6e6 u in float: no rounding of the case excuses it\n"
      "explain  rayaudit explain --format float 'sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 "
      "0x1p-1 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 miss'\n");
}

namespace {

/// The row of a failure's text that begins with the label, without it.
std::string row(const std::string& label, const Agreement& agreement) {
  const std::string text = '\n' + agreement.text();
  const std::size_t begin = text.find('\n' + label + ' ');
  if (begin == text.npos) return "";
  const std::size_t words = text.find_first_not_of(' ', begin + 1 + label.size());
  return text.substr(words, text.find('\n', words) - words);
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_failure_tells_the_error_where_there_is_one) {
  BOOST_TEST(row("error", agrees(half_up, hit(2.125f), {1})) ==
             "3.8e4 ulp of float, 0.00421 of t, 2.3e4 times what rounding the case would do");
  BOOST_TEST(row("verdict", agrees(half_up, hit(2.125f), {1})) ==
             "right, but t is off by more than the 1 ulp allowed");
  BOOST_TEST(row("error", agrees(half_up, hit(3.9f))) == "");
}

BOOST_AUTO_TEST_CASE(a_failure_tells_the_cause_only_where_the_answer_shows_it) {
  const Case twice = question_of("sphere 0 0 0 1 ray 0 0.5 -3 0 0 2");
  BOOST_TEST(row("cause", agrees(twice, hit(2.1339746f))) ==
             "assumption, it seems: t is right for a direction of length 1, which this is not");
  BOOST_TEST(row("cause", agrees(twice, hit(1.9330127f))) == "");  // the later root
  BOOST_TEST(row("cause", agrees(half_up, hit(3.9f))) == "");
  const Case beside = question_of("sphere 1 2 3 1 ray 5 5 5 0 0 1");
  BOOST_TEST(row("cause", agrees(beside, at(1.0, 2.0, 3.0))) ==
             "formula, it seems: a point stands for \"no hit\"");
  Convention convention = {};
  convention.tangent = RAYAUDIT_IS_MISS;
  BOOST_TEST(row("cause", agrees(tangent, hit(3.0), {0, convention})) ==
             "convention: declared to be a miss");
}

BOOST_AUTO_TEST_CASE(a_failure_tells_how_to_explain_it) {
  Convention convention = {};
  convention.tangent = RAYAUDIT_IS_HIT;
  convention.rim = RAYAUDIT_IS_MISS;
  convention.inside = RAYAUDIT_INSIDE_IS_START;
  const std::string line = case_line(tangent);
  BOOST_TEST(row("explain", agrees(tangent, hit(2.5), {0, convention})) ==
             "rayaudit explain --convention tangent=hit,rim=miss,inside=start '" + line +
                 " hit 0x1.4p+1'");
  BOOST_TEST(row("explain", agrees(tangent, hit(2.5L))) ==
             "rayaudit explain --format long_double '" + line + " hit 0x1.4p+1'");
  BOOST_TEST(row("truth", agrees(tangent, hit(2.5))) == "touch tangent 0x1.8p+1 (3), then miss");
  BOOST_TEST(row("truth", agrees(question_of("disk 0 0 0 0 0 0 1 ray 0 1 -3 0 0 1"), true)) ==
             "invalid: zero normal");
}

#ifdef __SSE2__
BOOST_AUTO_TEST_CASE(the_state_of_the_thread_does_not_matter_and_stays) {
  const Truth plain = truth(half_up);
  const Case tiny = question_of("sphere 0 0 0 0x1p-1070 ray 0 0 -0x1p-1069 0 0 0x1p-1074");
  const unsigned kept = _mm_getcsr();
  const unsigned upward_and_flushing = (kept & ~0x603fU) | 0x4000U | 0x8040U;
  _mm_setcsr(upward_and_flushing);
  const Truth known = truth(half_up), of_tiny = truth(tiny);
  const double ulps = judge(hit(0x1.112614p+1f), half_up).ulps;
  const unsigned left = _mm_getcsr();
  _mm_setcsr(kept);
  BOOST_TEST((known.t<long double>() == plain.t<long double>()));
  BOOST_TEST((of_tiny.t() == 16));
  BOOST_TEST(ulps < 0.5);
  BOOST_TEST((left & ~0x3fU) == (upward_and_flushing & ~0x3fU));
}
#endif

BOOST_AUTO_TEST_CASE(what_there_is_not_is_refused) {
  Case question = half_up;
  rayaudit_truth known;
  rayaudit_judgement judgement;
  rayaudit_answer answer = rayaudit_miss();
  question.shape = 6;
  BOOST_TEST(rayaudit_truth_of(&question, &known) == RAYAUDIT_NONE_SUCH);
  Case further = half_up;
  further.extent = 3;
  BOOST_TEST(rayaudit_truth_of(&further, &known) == RAYAUDIT_NONE_SUCH);
  BOOST_TEST(rayaudit_judge(&half_up, &answer, 3, nullptr, &judgement) == RAYAUDIT_NONE_SUCH);
  Convention convention = {};
  convention.rim = 3;
  BOOST_TEST(rayaudit_judge(&half_up, &answer, 0, &convention, &judgement) == RAYAUDIT_NONE_SUCH);
  convention = {};
  convention.t_min = 2, convention.t_max = 1;
  BOOST_TEST(rayaudit_judge(&half_up, &answer, 0, &convention, &judgement) == RAYAUDIT_NONE_SUCH);
  answer.form = 4;
  BOOST_TEST(rayaudit_judge(&half_up, &answer, 0, nullptr, &judgement) == RAYAUDIT_NONE_SUCH);
  BOOST_CHECK_THROW(truth(question), std::invalid_argument);
}

BOOST_AUTO_TEST_CASE(texts_are_cut_to_the_room_there_is) {
  char text[8] = "xxxxxxx";
  const rayaudit_answer answer = rayaudit_miss();
  const std::string whole = agrees(half_up, miss()).text();
  BOOST_TEST(rayaudit_told(&half_up, &answer, nullptr, text, 5) == static_cast<int>(whole.size()));
  BOOST_TEST(std::string(text) == "case");
  BOOST_TEST(text[5] == 'x');
}

BOOST_AUTO_TEST_CASE(case_lines_are_read_and_written) {
  const std::string line =
      "cone 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x1p+0 ray 0x1p+0 "
      "0x1p-1 0x0p+0 -0x1p+0 0x0p+0 0x0p+0 range -0x1p+0 0x1p+3";
  Case question;
  rayaudit_answer answer;
  BOOST_TEST(rayaudit_read_case((line + " hit 0x1p-1").c_str(), &question, &answer, nullptr, 0) ==
             RAYAUDIT_DONE);
  BOOST_TEST(answer.form == RAYAUDIT_HIT);
  BOOST_TEST(answer.t == 0.5);
  BOOST_TEST(case_line(question) == line);
  char text[200];
  rayaudit_write_case(&question, &answer, text, sizeof text);
  BOOST_TEST(text == line + " hit 0x1p-1");
  BOOST_CHECK_EXCEPTION(question_of("sphere 0 0 0 one"), std::invalid_argument, [](const auto& e) {
    return std::strcmp(e.what(), "sphere: expected radius, got `one`") == 0;
  });
}

BOOST_AUTO_TEST_CASE(the_words_are_those_of_reports) {
  const auto words = [](const char* (*name)(int32_t)) {
    std::string all;
    for (int32_t i = 0; name(i) != nullptr; ++i) (all += all.empty() ? "" : " ") += name(i);
    return all;
  };
  BOOST_TEST(words(rayaudit_verdict_name) ==
             "right touch false_hit false_miss wrong_root wrong_t not_finite crashed timed_out "
             "invalid_handled invalid_mishandled");
  BOOST_TEST(
      words(rayaudit_claim_name) ==
      "none no_root nan infinite behind past clipped mirrored later declined parallel centre "
      "origin garbage ended hung");
  BOOST_TEST(words(rayaudit_side_name) == "unknown before on beyond");
  BOOST_TEST(words(rayaudit_kind_name) == "proper tangent rim apex start end within");
  BOOST_TEST(words(rayaudit_invalid_name) ==
             "no nan infinite zero_direction zero_normal zero_axis radius empty_range");
  BOOST_TEST(words(rayaudit_format_name) == "double float long_double");
  BOOST_TEST(rayaudit_verdict_name(-1) == nullptr);
  BOOST_TEST(name(Verdict::invalid_mishandled) == std::string("invalid_mishandled"));
  BOOST_TEST(name(Claim::hung) == std::string("hung"));
  BOOST_TEST(name(Format::in_long_double) == std::string("long_double"));
}
