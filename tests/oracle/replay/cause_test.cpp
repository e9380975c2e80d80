#include "audit/cause.hpp"

#include <array>
#include <boost/test/unit_test.hpp>
#include <map>
#include <string>

#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "oracle/replay/replay_of.hpp"
#include "planted.hpp"
#include "routines/closest_approach.hpp"
#include "routines/handout.hpp"
#include "routines/stable_quadratic.hpp"
#include "routines/textbook.hpp"
#include "routines/unit_direction.hpp"
#include "subjects/subject_of.hpp"

using namespace rayaudit;

namespace {

/// What was found of the answers that are not right.
struct Found {
  std::array<int, cause_count> causes = {};
  std::map<std::string, int> told;
  std::string line;  ///< one of the cases, of the rarest cause

  int of(Cause cause) const { return causes[static_cast<std::size_t>(cause)]; }
  int all() const {
    int sum = 0;
    for (const int count : causes) sum += count;
    return sum;
  }
  int told_as(const std::string& text) const {
    const auto place = told.find(text);
    return place == told.end() ? 0 : place->second;
  }
  double share(Cause cause) const { return static_cast<double>(of(cause)) / all(); }
};

std::ostream& operator<<(std::ostream& out, const Found& found) {
  for (const auto& [text, count] : found.told) out << count << " x " << text << "; ";
  return out << found.line;
}

/// A routine in a number, with its replay.
template <class Routine, class N>
struct Planted {
  Subject subject = subject_of<Routine, N>();
  replay::Replay replay = replay::replay_made_of<Routine>();

  std::pair<Judgement, Diagnosis> looked_into(const Case& question,
                                              std::optional<double> most_ulps = {}) const {
    const Answer answer = answer_one(subject, question);
    const oracle::Truth truth = oracle::truth(question, oracle::bits_for(subject.format));
    Settled settled(question, truth);
    const Judgement judgement = judge(settled, answer, subject.format);
    return {judgement, diagnosis({settled, answer, judgement, most_ulps}, subject, &replay, {})};
  }

  void look_into(const Case& question, Found& found) const {
    const auto [judgement, made] = looked_into(question);
    if (!is_wrong(judgement.verdict) && judgement.verdict != Verdict::touch) return;
    ++found.causes[static_cast<std::size_t>(made.cause)];
    ++found.told[told(made)];
    if (found.of(made.cause) == 1) found.line = told(made) + ": " + case_line(question);
  }

  Found of_line(std::string_view line) const {
    Found found;
    look_into(read_case_line(line).question, found);
    return found;
  }

  Found of_family(std::string_view id, std::size_t shape, std::size_t cases = 1024) const {
    const auto family = std::find_if(families().begin(), families().end(),
                                     [&](const Family& f) { return f.id == id; });
    std::vector<Case> drawn(cases);
    draw(*family, shape, subject.drawn_in(), {}, 11, 0, drawn);
    Found found;
    for (const Case& question : drawn) look_into(question, found);
    return found;
  }
};

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2, cone = 3;

}  // namespace

BOOST_AUTO_TEST_CASE(a_wrong_factor_is_the_formula) {
  const Found found = Planted<planted::WrongFactor, double>().of_family("anywhere", sphere);
  BOOST_TEST(found.all() > 100);
  BOOST_TEST(found.share(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(a_missing_parallel_check_is_the_formula_and_the_division_is_named) {
  const Found found = Planted<planted::NoParallelCheck, float>().of_family("within", disk);
  BOOST_TEST(found.of(Cause::formula) > 10);
  BOOST_TEST(found.told.contains("formula: a division by 0"), found);
}

BOOST_AUTO_TEST_CASE(an_open_rim_is_a_convention) {
  const Found found =
      Planted<planted::OpenRim, double>().of_line("disk 0 0 0 0 1 0 1 ray 1 2 0 0 -1 0");
  BOOST_TEST(found.of(Cause::convention) == 1, found);
}

BOOST_AUTO_TEST_CASE(a_direction_taken_for_unit_is_an_assumption) {
  for (const std::size_t shape : {sphere, cylinder}) {
    const Found found = Planted<UnitDirection, double>().of_family("anywhere", shape);
    BOOST_TEST(found.all() > 100);
    BOOST_TEST(found.told_as("assumption of a direction of length 1") == found.all(), found);
  }
}

BOOST_AUTO_TEST_CASE(a_normal_taken_for_unit_is_an_assumption) {
  const Found found = Planted<planted::UnitNormal, double>().of_family("anywhere", disk);
  BOOST_TEST(found.all() > 10);
  BOOST_TEST(found.told_as("assumption of a normal of length 1") == found.all(), found);
}

BOOST_AUTO_TEST_CASE(the_far_root_first_is_the_formula) {
  const Found found = Planted<planted::FarRootFirst, double>().of_family("anywhere", sphere);
  BOOST_TEST(found.all() > 100);
  BOOST_TEST(found.share(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(both_nappes_are_the_formula) {
  const Found found = Planted<planted::BothNappes, double>().of_family("anywhere", cone);
  BOOST_TEST(found.all() > 10);
  BOOST_TEST(found.share(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(or_for_and_is_the_formula) {
  const Found found = Planted<planted::OrForAnd, double>().of_family("anywhere", cylinder);
  BOOST_TEST(found.all() > 10);
  BOOST_TEST(found.share(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(sign_of_zero_is_the_formula) {
  const Found found =
      Planted<planted::SignOfZero, double>().of_line("sphere 0 0 0 2 ray 0 1 0 1 0 0");
  BOOST_TEST(found.of(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(a_sentinel_is_the_formula) {
  const Found found =
      Planted<planted::Sentinel, double>().of_line("sphere 1 0 0 1 ray -2 0 0 1 0 0");
  BOOST_TEST(found.of(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(an_epsilon_on_a_small_sphere_is_the_formula) {
  const Found found =
      Planted<planted::Epsilon, double>().of_line("sphere 0 0 0 1e-5 ray 0 0 -3 0 0 0.5");
  BOOST_TEST(found.of(Cause::formula) == 1, found);
}

BOOST_AUTO_TEST_CASE(an_epsilon_on_a_short_direction_is_an_assumption) {
  const Found found =
      Planted<planted::Epsilon, double>().of_line("sphere 0 0 0 1 ray 0 0 -3 0 1e-6 1e-5");
  BOOST_TEST(found.of(Cause::assumption) == 1, found);
}

BOOST_AUTO_TEST_CASE(a_discriminant_that_cancels_is_a_flip_of_its_comparison) {
  const Found found = Planted<planted::CancellingDiscriminant, float>().of_family("far", sphere);
  BOOST_TEST(found.of(Cause::flip) > 50);
  BOOST_TEST(found.of(Cause::flip) + found.of(Cause::rounding) == found.all(), found);
}

BOOST_AUTO_TEST_CASE(a_flip_names_its_comparison_and_both_exact_sides) {
  // The line passes the centre at more than the radius; in floats b^2 - 4ac is positive.
  const Case question =
      read_case_line(
          "sphere -0x1.15198p-3 0x1.65ce58p-3 -0x1.b7ad3ep-1 0x1.a2d666p+1 ray 0x1.57f0d6p+13 "
          "0x1.656956p+13 0x1.60127cp+13 -0x1.a7ed0ap-1 -0x1.b876d4p-1 -0x1.b24f06p-1")
          .question;
  const Planted<planted::CancellingDiscriminant, float> planted;
  const auto [judgement, made] = planted.looked_into(question);
  BOOST_REQUIRE(is_wrong(judgement.verdict));
  BOOST_REQUIRE(made.turned.has_value());
  const replay::Step& turned = *made.turned;
  BOOST_TEST(turned.operation == "<");
  BOOST_TEST(turned.said != turned.exactly);
  BOOST_TEST(turned.said == (nearest<double>(turned.value) < 0));
  BOOST_TEST(turned.exactly == (nearest<double>(turned.exact) < 0));
  BOOST_TEST(sign(turned.exact_right) == 0);
}

BOOST_AUTO_TEST_CASE(a_flip_in_a_built_in_routine_names_its_line_and_text) {
  const Found found = Planted<Textbook, float>().of_family("far", sphere);
  BOOST_TEST(found.told_as("flip at routines/quadratic_formula.hpp:20") > 10, found);
  BOOST_TEST(replay::source_line("routines/quadratic_formula.hpp", 20) ==
             "if (discriminant < N(0)) return {};");
}

BOOST_AUTO_TEST_CASE(a_height_from_a_rounded_point_is_a_flip_or_rounding) {
  const Found found = Planted<planted::RoundedPoint, float>().of_family("placement", cylinder);
  BOOST_TEST(found.all() > 10);
  BOOST_TEST(found.of(Cause::flip) + found.of(Cause::rounding) == found.all(), found);
}

BOOST_AUTO_TEST_CASE(the_handout_is_wrong_by_its_formula) {
  const Found on_disk = Planted<Handout, double>().of_family("within", disk);
  BOOST_TEST(on_disk.of(Cause::formula) > 0, on_disk);
  const Found on_sphere = Planted<Handout, double>().of_family("anywhere", sphere);
  BOOST_TEST(on_sphere.share(Cause::formula) == 1, on_sphere);
}

BOOST_AUTO_TEST_CASE(the_textbook_at_a_distance_is_wrong_by_rounding) {
  for (const std::size_t shape : {sphere, cylinder, cone}) {
    const Found found = Planted<Textbook, float>().of_family("far", shape);
    BOOST_TEST(found.all() > 100);
    BOOST_TEST(found.of(Cause::flip) > 0);
    BOOST_TEST(found.of(Cause::flip) + found.of(Cause::rounding) == found.all(), found);
  }
}

BOOST_AUTO_TEST_CASE(an_error_beyond_what_is_held_has_a_cause_too) {
  const Planted<Textbook, float> planted;
  const Case question = read_case_line("sphere 0 0 0 1 ray 0.5 0.25 -63.9 0.001 0.002 1").question;
  const auto [judgement, made] = planted.looked_into(question, 0.5);
  BOOST_REQUIRE((judgement.verdict == Verdict::right));
  BOOST_REQUIRE(judgement.ulps > 0.5);
  BOOST_TEST((made.cause == Cause::rounding));
}

BOOST_AUTO_TEST_CASE(what_cannot_be_replayed_is_tried_from_outside) {
  const Subject subject = subject_of<UnitDirection, double>();
  const Case question = read_case_line("sphere 0 0 0 1 ray 0.5 0.25 -8 0 0 2").question;
  const Answer answer = answer_one(subject, question);
  const oracle::Truth truth = oracle::truth(question);
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, double_format);
  BOOST_REQUIRE(is_wrong(judgement.verdict));
  const Diagnosis made = diagnosis({settled, answer, judgement, {}}, subject, nullptr, {});
  BOOST_TEST(told(made) == "assumption of the length of the direction");
}

BOOST_AUTO_TEST_CASE(from_outside_a_formula_stays_unknown) {
  const Subject subject = subject_of<planted::WrongFactor, double>();
  const Case question = read_case_line("sphere 0 0 0 1 ray 0.5 0.25 -8 0 0 2").question;
  const Answer answer = answer_one(subject, question);
  const oracle::Truth truth = oracle::truth(question);
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, double_format);
  BOOST_REQUIRE(is_wrong(judgement.verdict));
  BOOST_TEST(
      (diagnosis({settled, answer, judgement, {}}, subject, nullptr, {}).cause == Cause::unknown));
}
