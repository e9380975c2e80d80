#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <sstream>

#include "geometry/case_line.hpp"
#include "reports/page.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

constexpr std::string_view explain = "     rayaudit explain --subject ";

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> all;
  for (std::string line; std::getline(stream, line);) all.push_back(line);
  return all;
}

std::string table(const HandMade& made, const Look& look = {}) {
  return write_table(made.run(), look);
}

bool tells(const std::string& text, std::string_view words) {
  return text.find(words) != text.npos;
}

std::size_t count(const std::string& text, std::string_view words) {
  std::size_t found = 0;
  for (auto at = text.find(words); at != text.npos; at = text.find(words, at + 1)) ++found;
  return found;
}

/// The line that begins with this name, but for the indent.
std::string row(const std::string& text, const std::string& name) {
  for (const std::string& line : lines(text))
    if (line.starts_with("  " + name + ' ')) return line;
  return "";
}

/// As wide and as many as it gets: long names, all verdicts, all touches, figures of any size.
HandMade crowded(std::size_t families) {
  HandMade made;
  for (int s = 0; s < 5; ++s)
    for (std::size_t f = 0; f < families; ++f) {
      Tally& tally =
          made.add("a_routine_of_a_rather_long_name_" + std::to_string(s) + "/long_double", s % 4,
                   "parallel-near-" + std::to_string(f));
      for (std::size_t v = 2; v < verdict_count; ++v) {
        const auto verdict = static_cast<Verdict>(v);
        const bool claims = verdict == Verdict::false_hit || verdict == Verdict::wrong_root;
        turn(tally, verdict, claims ? Claim::clipped : Claim::none, 1 + (s + f + v) % 9);
      }
      for (const double error : {1e-300, 0.5, 123456.0, 1e300}) {
        tally.ulps.add(error);
        tally.forced.add(error);
      }
      for (TouchCount& touch : tally.touches) touch = {1, 9999 + f};
    }
  made.environment.flags = std::string(90, '-');
  made.environment.processor = std::string(60, 'p');
  return made;
}

BOOST_AUTO_TEST_CASE(it_fits_the_page_but_for_case_lines) {
  for (const std::size_t families : {3, 30})
    for (const std::string& line : lines(table(crowded(families), {.everything = true})))
      BOOST_TEST((line.size() <= 120 || line.starts_with(explain)), line);
}

BOOST_AUTO_TEST_CASE(there_are_escape_codes_only_where_colour_is_wanted) {
  BOOST_TEST(!tells(table(crowded(3)), "\x1b"));
  BOOST_TEST(!tells(table(crowded(30)), "\x1b"));
  BOOST_TEST(tells(table(crowded(3), {.colour = true}), "\x1b[31m"));
}

BOOST_AUTO_TEST_CASE(without_its_colour_it_is_the_plain_table) {
  std::string text = table(crowded(3), {.colour = true});
  for (auto at = text.find('\x1b'); at != text.npos; at = text.find('\x1b'))
    text.erase(at, text.find('m', at) + 1 - at);
  BOOST_TEST(text == table(crowded(3)));
}

BOOST_AUTO_TEST_CASE(few_audits_get_a_row_each) {
  HandMade made;
  turn(made.add("textbook/float", 1, "grazing"), Verdict::false_miss, Claim::none, 12);
  made.add(1, "far");
  const std::string text = table(made);
  const std::string first = row(text, "textbook/float");
  BOOST_TEST(tells(first, "grazing"));
  BOOST_TEST(tells(first, "12.0     -  12.0     -"), first);
  BOOST_TEST(count(text.substr(0, text.find("\nLimits")), "\n  textbook/float") == 2);
}

BOOST_AUTO_TEST_CASE(many_audits_are_a_row_for_each_subject_and_shape) {
  HandMade made;
  made.add("textbook/float", 1, "f0");
  for (int f = 1; f < 120; ++f)
    turn(made.add(1, "f" + std::string(1, static_cast<char>('0' + f % 10))), Verdict::wrong_t,
         Claim::none, f == 7 ? 50 : f % 2);
  const std::string text = table(made);
  const std::string only = row(text, "textbook/float");
  BOOST_TEST(count(text.substr(0, text.find("\nLimits")), "\n  textbook/float") == 1);
  BOOST_TEST(tells(only, "60/120"), only);
  BOOST_TEST(tells(only, " f7 "), only);
}

BOOST_AUTO_TEST_CASE(what_holds_says_how_sure_that_is) {
  HandMade made;
  made.add("textbook/float", 1, "anywhere");
  BOOST_TEST(tells(row(table(made), "textbook/float"), "0 of 100, < 3% at 95%"));
}

BOOST_AUTO_TEST_CASE(a_little_is_never_told_as_nothing_nor_nearly_all_as_all) {
  HandMade made;
  Tally& little = made.add("little/float", 1, "anywhere");
  little.cases = little.verdicts[0] = 1000000;
  turn(little, Verdict::wrong_t, Claim::none, 1);
  Tally& much = made.add("much/float", 1, "anywhere");
  much.cases = much.verdicts[0] = 1000000;
  turn(much, Verdict::wrong_t, Claim::none, 999999);
  BOOST_TEST(tells(row(table(made), "little/float"), " <0.01"));
  BOOST_TEST(tells(row(table(made), "much/float"), " >99.9"));
}

BOOST_AUTO_TEST_CASE(a_shape_without_audits_is_left_out) {
  HandMade made;
  made.add("textbook/float", 1, "anywhere");
  BOOST_TEST(tells(table(made), "\nsphere "));
  BOOST_TEST(!tells(table(made), "\ncone "));
}

BOOST_AUTO_TEST_CASE(findings_of_one_routine_alike_are_one_with_all_its_shapes) {
  HandMade made;
  turn(made.add("textbook/float", 1, "far"), Verdict::false_miss, Claim::none, 10, 1);
  turn(made.add(1, "rim"), Verdict::false_miss, Claim::none, 5, 2);
  turn(made.add(3, "far"), Verdict::false_miss, Claim::none, 20, 3);
  turn(made.add("textbook/double", 1, "far"), Verdict::false_miss, Claim::none, 7, 4);
  const std::string text = table(made);
  BOOST_TEST(tells(text, "  1. false miss by textbook: a miss where there is a hit\n"));
  BOOST_TEST(tells(text,
                   "     cone, sphere in float, double: 20.0% of far (cone), 5.00% of rim "
                   "(sphere)\n"));
  BOOST_TEST(!tells(text, "  2. "));
  BOOST_TEST(
      tells(text, std::string(explain) + "textbook/float '" + case_line(known_case(3)) + " hit "));
}

BOOST_AUTO_TEST_CASE(a_finding_tells_its_causes_its_margin_and_the_bound_there) {
  HandMade made;
  Tally& tally = made.add("textbook/float", 1, "far");
  turn(tally, Verdict::false_miss, Claim::none, 10, 1, 3e5);
  replay::Step step;
  step.file = "routines/a.hpp", step.line = 7, step.text = "if (a < b) return {};";
  CauseCount& causes = tally.outcome(Verdict::false_miss, Claim::none).causes;
  for (int i = 0; i < 3; ++i) causes.add({Cause::flip, {}, step});
  causes.add({Cause::formula, "a division by 0", {}});
  tally.certificate.cases = 100, tally.certificate.certified = 25;
  tally.certificate.proved = Worst{.severity = 12.5},
  tally.certificate.observed = Worst{.severity = 2};
  const std::string text = table(made);
  BOOST_TEST(
      tells(text,
            "     cause (by 4 of 10 replayed): 75% flip (all at routines/a.hpp:7 `if (a < b) "
            "return {};`), 25% formula (a division by\n     0)\n"),
      text);
  BOOST_TEST(tells(text,
                   "     margin: textbook/float wrong up to 3.0e5 u; bound: 25.0% of far "
                   "certified, rounding alone within "
                   "12.5 ulps proved,\n     2 seen\n"),
             text);
  const std::string first = row(text, "textbook/float");
  BOOST_TEST(tells(first, "flip    3.0e5"), first);
}

BOOST_AUTO_TEST_CASE(a_small_margin_is_said_to_be_excusable) {
  HandMade made;
  turn(made.add("textbook/float", 1, "far"), Verdict::false_miss, Claim::none, 10, 1, 3);
  BOOST_TEST(tells(table(made),
                   "margin: textbook/float wrong up to 3 u, as rounding the case itself may do\n"));
}

BOOST_AUTO_TEST_CASE(limits_tell_how_often_a_subject_is_wrong_at_which_margin) {
  HandMade made;
  Tally& tally = made.add("textbook/float", 1, "far");
  for (int i = 0; i < 4; ++i) tally.curve.add(2, i == 0);
  for (int i = 0; i < 8; ++i) tally.curve.add(0x1p20, false);
  tally.certificate.cases = 200, tally.certificate.certified = 100;
  const std::string text = table(made);
  const std::string told = row(text.substr(text.find("\nLimits")), "textbook/float");
  BOOST_TEST(tells(told, "25.0"), told);
  BOOST_TEST(tells(told, "50.0"), told);
  BOOST_TEST(!tells(told, "DIFFER"), told);
  tally.certificate.wrong = 1;
  BOOST_TEST(tells(table(made), "1 DIFFER from the exact replay"));
}

BOOST_AUTO_TEST_CASE(a_finding_on_one_shape_does_not_say_of_which_at_each_family) {
  HandMade made;
  turn(made.add("textbook/float", 1, "far"), Verdict::false_miss, Claim::none, 10);
  BOOST_TEST(tells(table(made), "     sphere in float: 10.0% of far\n"));
}

BOOST_AUTO_TEST_CASE(findings_of_another_routine_verdict_or_claim_stand_apart_worst_first) {
  HandMade made;
  turn(made.add("a/float", 1, "far"), Verdict::false_hit, Claim::behind, 10);
  turn(made.add(1, "rim"), Verdict::false_hit, Claim::clipped, 20);
  turn(made.add(1, "tangent"), Verdict::wrong_root, Claim::clipped, 30);
  turn(made.add("b/float", 1, "far"), Verdict::wrong_root, Claim::clipped, 40);
  const std::string text = table(made);
  BOOST_TEST(count(text, explain) == 4);
  BOOST_TEST(tells(text, "  1. wrong root by b: "));
  BOOST_TEST(tells(text, "  2. wrong root by a: "));
  BOOST_TEST(tells(text, "  3. false hit by a: "));
  BOOST_TEST(tells(text, "40.0% of far"));
  BOOST_TEST(text.find("20.0% of rim") < text.find("10.0% of far"));
}

BOOST_AUTO_TEST_CASE(the_slips_of_the_handout_are_findings_of_their_own) {
  Plan plan = {.subjects = {}, .families = {}, .shapes = {0, 1}, .cases = 10'000, .seed = 1};
  for (const Subject& subject : built_in_subjects())
    if (subject.name.starts_with("handout/")) plan.subjects.push_back(&subject);
  for (const Family& family : families()) plan.families.push_back(&family);
  const std::vector<Audit> audits = run(plan);
  const auto told = lines(write_table({"1.2.3", plan, audits, {}}, {}));
  const auto has = [&](std::string_view verdict, std::string_view claim, std::string_view shape) {
    for (std::size_t i = 0; i + 1 < told.size(); ++i)
      if (tells(told[i], verdict) && tells(told[i], claim) && tells(told[i + 1], shape))
        return true;
    return false;
  };
  BOOST_TEST(has("false hit by handout", "the ray runs parallel to it", " disk in float"));
  BOOST_TEST(has("false hit by handout", "the shape's own centre", " sphere in float"));
  BOOST_TEST(has("false miss by handout", "lies at the world origin", " sphere in "));
}

BOOST_AUTO_TEST_CASE(sentinels_are_shown_however_few_they_are) {
  HandMade made;
  for (int i = 0; i < 25; ++i)
    turn(made.add("r" + std::to_string(i) + "/float", 1, "far"), Verdict::wrong_t, Claim::none, 9);
  turn(made.add("odd/float", 1, "far"), Verdict::false_miss, Claim::origin, 1);
  BOOST_TEST(tells(table(made), "\n 26. false miss by odd: "));
  BOOST_TEST(tells(table(made), "\n5 more, less severe: --all-findings shows them.\n"));
}

BOOST_AUTO_TEST_CASE(what_holds_is_told_by_routine_and_shape_the_most_first) {
  HandMade made;
  made.add("weak/float", 1, "f0");
  for (int f = 1; f < 40; ++f)
    turn(made.add(1, "f" + std::to_string(f)), Verdict::wrong_t, Claim::none, f % 2);
  made.add("strong/float", 0, "f0");
  for (int f = 1; f < 40; ++f)
    turn(made.add(0, "f" + std::to_string(f)), Verdict::wrong_t, Claim::none, f == 7);
  made.add("strong/double", 0, "f0");
  for (int f = 1; f < 40; ++f) made.add(0, "f" + std::to_string(f));
  const std::string text = table(made);
  const std::string told = text.substr(text.find("\nWhat holds"));
  BOOST_TEST(row(told, "strong") == "  strong           disk 39/40");
  BOOST_TEST(row(told, "weak") == "  weak                             sphere 20/40");
  BOOST_TEST(told.find("strong") < told.find("weak"));
}

BOOST_AUTO_TEST_CASE(conduct_on_invalid_cases_is_not_what_is_most_wrong) {
  HandMade made;
  turn(made.add("textbook/float", 1, "invalid"), Verdict::invalid_mishandled, Claim::none, 90);
  for (int f = 0; f < 120; ++f)
    turn(made.add(1, "f" + std::to_string(f)), Verdict::wrong_t, Claim::none, f == 7);
  BOOST_TEST(tells(row(table(made), "textbook/float"), " f7 "));
}

BOOST_AUTO_TEST_CASE(only_the_worst_findings_are_shown_and_the_rest_counted_or_all) {
  HandMade made;
  for (int i = 0; i < 25; ++i)
    turn(made.add("a/float", 1, "f" + std::string(1, static_cast<char>('a' + i))), Verdict::wrong_t,
         Claim::none, 1 + i);
  // 25 families of one routine are one finding; of 25 routines they are 25.
  BOOST_TEST(count(table(made), explain) == 1);
  for (std::size_t i = 0; i < 25; ++i)
    made.subjects[i].name = "r" + std::string(1, static_cast<char>('a' + i)) + "/float";
  BOOST_TEST(count(table(made), explain) == 20);
  BOOST_TEST(tells(table(made), "\n5 more, less severe: --all-findings shows them.\n"));
  BOOST_TEST(count(table(made, {.everything = true}), explain) == 25);
}

BOOST_AUTO_TEST_CASE(touches_tell_what_was_taken_for_a_hit) {
  constexpr auto tangent = static_cast<std::size_t>(oracle::Kind::tangent);
  constexpr auto rim = static_cast<std::size_t>(oracle::Kind::rim);
  constexpr auto end = static_cast<std::size_t>(oracle::Kind::end);
  HandMade made;
  Tally& first = made.add("textbook/float", 2, "tangent");
  first.touches[tangent] = {4, 0};
  first.touches[rim] = {1, 3};
  Tally& second = made.add("textbook/double", 2, "tangent");
  second.touches[tangent] = {9, 0};
  second.touches[rim] = {2, 2};
  second.touches[end] = {0, 7};
  const std::string text = table(made);
  const std::string told = row(text.substr(text.find("\nTouches")), "cylinder");
  BOOST_TEST(tells(told, "textbook"), told);
  BOOST_TEST(tells(told, "hit           25.0-50.0%    miss"), told);
  BOOST_TEST(!tells(text, "apex"));
}

BOOST_AUTO_TEST_CASE(it_ends_with_all_in_one_line) {
  HandMade made;
  turn(made.add("textbook/float", 1, "far"), Verdict::false_miss, Claim::none, 10);
  Tally& invalid = made.add(1, "invalid");
  turn(invalid, Verdict::invalid_handled, Claim::none, 100);
  Tally& exact = made.add(1, "tangent");
  exact.decided_by = {0, 0, 0, 60, 40};
  BOOST_TEST(lines(table(made)).back() ==
             "3.33% of 300 cases wrong; 2 of 3 audits hold; 0 undecided (50.0% needed exact "
             "numbers)");
  exact.decided_by = {0, 0, 0, 60, 39};
  BOOST_TEST(tells(lines(table(made)).back(), "; 1 undecided"));
}

BOOST_AUTO_TEST_CASE(seed_version_convention_and_surroundings_are_on_record) {
  HandMade made;
  made.add("textbook/float", 1, "far");
  made.plan.convention.of(oracle::Kind::rim) = Convention::Stance::hit;
  const std::string text = table(made);
  BOOST_TEST(tells(text, "rayaudit 1.2.3"));
  BOOST_TEST(tells(text, "seed 18364758544493064720"));
  BOOST_TEST(tells(text, "rim declared to be a hit"));
  BOOST_TEST(tells(text, "rounding to nearest, no contraction, no flush to zero"));
}

BOOST_AUTO_TEST_CASE(what_subjects_declare_is_told) {
  HandMade made;
  made.add("mine/float", 1, "far");
  Convention& convention = made.subjects.front().convention;
  BOOST_TEST(!tells(table(made), "declare"));
  convention.of(oracle::Kind::rim) = Convention::Stance::miss;
  convention.inside = Convention::Inside::start;
  convention.unit_direction = convention.line = true;
  convention.t_max = 0.1;
  BOOST_TEST(
      tells(table(made),
            "\n  mine/float declares rim=miss,inside=start,direction=unit,ray=line,t_max=0.1\n"));
  made.plan.convention.inside = Convention::Inside::miss;
  BOOST_TEST(tells(table(made), "; declared: inside=miss\n"));
}

BOOST_AUTO_TEST_CASE(crashes_and_time_outs_have_a_column_where_there_are_any) {
  HandMade made;
  turn(made.add("mine/float", 1, "far"), Verdict::wrong_t, Claim::none, 1);
  const std::string before = table(made);
  BOOST_TEST(!tells(before, "cra-"));
  BOOST_TEST(!tells(before, "timed"));
  turn(made.audits[0].tally, Verdict::crashed, Claim::none, 7);
  BOOST_TEST(tells(table(made), "cra-"));
  BOOST_TEST(!tells(table(made), "timed"));
  BOOST_TEST(tells(row(table(made), "mine/float"), "  8.00     -     -     -  1.00     -  7.00"),
             row(table(made), "mine/float"));
  turn(made.audits[0].tally, Verdict::timed_out, Claim::none, 20);
  BOOST_TEST(tells(table(made), "timed"));
}

BOOST_AUTO_TEST_CASE(a_crash_is_told_with_its_signal_and_whether_it_shows_again) {
  HandMade made;
  turn(made.add("mine/float", 1, "far"), Verdict::crashed, Claim::none, 7);
  made.subjects.front().brought_by = "--plugin './my mine.so'";
  Worst& worst = *made.audits[0].tally.outcome(Verdict::crashed, Claim::none).worst;
  worst.answer = Answer::crashed(11);
  BOOST_TEST(tells(table(made), "ended, killed by SIGSEGV\n"));
  BOOST_TEST(tells(table(made), "explain --subject mine/float --plugin './my mine.so' 'sphere "));
  worst.repeats = false;
  BOOST_TEST(tells(table(made), "killed by SIGSEGV; not reproducible: "));
}

BOOST_AUTO_TEST_CASE(cases_that_were_not_asked_are_told) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  BOOST_TEST(!tells(table(made), "not asked"));
  tally.unasked = 1234;
  BOOST_TEST(tells(table(made), "; 1,234 not asked\n"));
}

BOOST_AUTO_TEST_CASE(every_report_is_in_the_list_and_ends_its_last_line) {
  HandMade made;
  made.add("textbook/float", 1, "far");
  BOOST_TEST(reports().size() == 7);
  for (const auto& report : reports())
    if (report.name != "html" || has_page())
      BOOST_TEST(report.write(made.run(), {}).back() == '\n', report.name);
}

}  // namespace
}  // namespace rayaudit
