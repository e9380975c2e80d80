#include <boost/test/unit_test.hpp>

#include "reports/markdown_text.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

std::string markdown(const HandMade& made, bool everything = false) {
  return write_markdown(made.run(), {.everything = everything});
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

BOOST_AUTO_TEST_CASE(the_verdict_stands_in_the_first_line) {
  HandMade made;
  made.add("mine/float", 1, "far");
  made.add(2, "far");
  BOOST_TEST(first_line(markdown(made)) == "**rayaudit: all 2 audits hold**; 0 of 200 cases wrong");
  turn(made.audits[0].tally, Verdict::false_hit, Claim::nan, 3);
  BOOST_TEST(first_line(markdown(made)) ==
             "**rayaudit: 1 of 2 audits have wrong answers**; 3 of 200 cases wrong");
  made.plan.bounds = read_bounds("mine/* * * false_hit 3 observed\n", "rows.txt");
  BOOST_TEST(first_line(markdown(made)) ==
             "**rayaudit: every bound is kept** in 2 audits; 3 of 200 cases wrong");
  made.plan.bounds = read_bounds("mine/* * * false_hit 2 observed\n", "rows.txt");
  BOOST_TEST(first_line(markdown(made)) ==
             "**rayaudit: bounds are broken** in 1 of 2 audits; 3 of 200 cases wrong");
}

BOOST_AUTO_TEST_CASE(the_table_has_a_row_a_subject_and_a_column_a_shape) {
  HandMade made;
  turn(made.add("mine/float", 1, "far"), Verdict::false_hit, Claim::nan, 3);
  made.add(1, "anywhere");
  made.add(3, "far");
  made.add("other/float", 0, "far");
  const std::string text = markdown(made);
  BOOST_TEST(contains(text, "| wrong answers | disk | sphere | cylinder | cone |\n"), text);
  BOOST_TEST(contains(text, "\n| mine/float |  | **1.50 % of 200** |  | 0 of 100 |\n"), text);
  BOOST_TEST(contains(text, "\n| other/float | 0 of 100 |  |  |  |\n"), text);
}

BOOST_AUTO_TEST_CASE(a_finding_is_folded_up_with_its_case_and_command) {
  HandMade made;
  turn(made.add("mine/float", 1, "far"), Verdict::false_hit, Claim::nan, 3);
  const std::string text = markdown(made);
  BOOST_TEST(contains(text,
                      "\n<details><summary>false hit by mine on sphere: a hit where there is none: "
                      "t is NaN; 3.00 % of far</summary>\n\n```\ncase     sphere "),
             text);
  BOOST_TEST(contains(text, "\nexplain  rayaudit explain --subject mine/float 'sphere "), text);
  BOOST_TEST(contains(text, "\n```\n\n</details>\n"), text);
}

BOOST_AUTO_TEST_CASE(a_broken_limit_is_folded_up_instead_where_there_are_bounds) {
  HandMade made;
  turn(made.add("mine/float", 1, "far"), Verdict::false_hit, Claim::nan, 3);
  made.plan.bounds = read_bounds("mine/* * * false_hit 2 observed\n", "rows.txt");
  const std::string text = markdown(made);
  BOOST_TEST(contains(text, "<summary>mine/float on sphere, family far: false_hit is"), text);
  made.plan.bounds = read_bounds("mine/* * * false_hit 3 observed\n", "rows.txt");
  BOOST_TEST(!contains(markdown(made), "<details>"));
}

BOOST_AUTO_TEST_CASE(what_the_run_is_to_fail_on_is_told_before_the_findings) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  turn(tally, Verdict::false_hit, Claim::nan, 3);
  made.fail_on.verdicts[static_cast<std::size_t>(Verdict::false_miss)] = true;
  BOOST_TEST(first_line(markdown(made)) == "**rayaudit: all 1 audit hold**; 3 of 100 cases wrong");
  made.fail_on.most_ulps = 4;
  tally.ulps.add(5);
  tally.worst_ulps = Worst{5, 0, known_case(9), Answer::hit(real(4.5)), {}, {}};
  const std::string text = markdown(made);
  BOOST_TEST(first_line(text) ==
             "**rayaudit: 1 of 1 audit fail by --fail-on**; 3 of 100 cases wrong");
  const std::size_t breach = text.find(
      "<summary>mine/float on sphere, family far: a t is off by 5 ulps, more than 4</summary>");
  BOOST_TEST(breach < text.find("<summary>false hit by mine on sphere: "), text);
  HandMade unasked;
  unasked.add("mine/float", 1, "far").unasked = 5;
  unasked.fail_on.most_ulps = 4;
  BOOST_TEST(contains(markdown(unasked), ": 5 cases were not asked after 100</summary>"),
             markdown(unasked));
  unasked.plan.bounds = read_bounds("mine/* * * wrong 0 unasked 5 observed\n", "rows.txt");
  BOOST_TEST(first_line(markdown(unasked)) ==
             "**rayaudit: bounds are broken, or --fail-on** in 1 of 1 audit; 0 of 100 cases wrong, "
             "5 not asked");
}

/// Many subjects, each wrong everywhere.
HandMade many(std::size_t subjects) {
  HandMade made;
  for (std::size_t i = 0; i < subjects; ++i)
    turn(made.add("subject_" + std::to_string(i) + "/float", 1, "far"), Verdict::false_hit,
         Claim::nan, 3);
  return made;
}

BOOST_AUTO_TEST_CASE(it_is_never_longer_than_github_takes) {
  for (const std::size_t subjects : {200, 400, 3000}) {
    const std::string text = markdown(many(subjects), true);
    BOOST_TEST(text.size() <= 65'535);
    BOOST_TEST(text.size() > 40'000);
    BOOST_TEST(contains(text, " more findings, less severe, are left out.\n"));
    BOOST_TEST(contains(text, "; seed 18364758544493064720\n"));
    BOOST_TEST(contains(text, " more subjects are left out.\n") == (subjects == 3000));
  }
}

BOOST_AUTO_TEST_CASE(twenty_findings_are_told_unless_all_are_asked_for) {
  const auto count = [](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t i = text.find("<details>"); i != text.npos; i = text.find("<details>", i + 1))
      ++found;
    return found;
  };
  BOOST_TEST(count(markdown(many(50))) == 20);
  BOOST_TEST(contains(markdown(many(50)), "\n30 more findings, less severe, are left out.\n"));
  BOOST_TEST(count(markdown(many(50), true)) == 50);
}

BOOST_AUTO_TEST_CASE(no_name_is_a_mark) {
  BOOST_TEST(markdown_text("a|b") == "a&#124;b");
  BOOST_TEST(markdown_text("*a*_b_c_d") == "&#42;a&#42;&#95;b_c_d");
  BOOST_TEST(markdown_text("<script>\n") == "&#60;script&#62;&#92;x0a");
  BOOST_TEST(markdown_text("\"as it is\"") == "\"as it is\"");
  BOOST_TEST(markdown_text("stable_quadratic/float") == "stable_quadratic/float");
  HandMade made;
  turn(made.add("</details>|```\n````x", 1, "far"), Verdict::false_hit, Claim::nan, 3);
  const std::string text = markdown(made);
  BOOST_TEST(contains(text, "\n`````\ncase     "), text);
}

BOOST_AUTO_TEST_CASE(code_is_fenced_by_more_backquotes_than_it_has) {
  BOOST_TEST(code_span("<a>_b") == "`<a>_b`");
  BOOST_TEST(code_span("of `dir`.\nEnd") == "``of `dir`. End``");
  BOOST_TEST(code_span("`dir`") == "`` `dir` ``");
  BOOST_TEST(fenced("a\n") == "```\na\n```\n");
  BOOST_TEST(fenced("a ``` b ```` c\n") == "`````\na ``` b ```` c\n`````\n");
}

}  // namespace
}  // namespace rayaudit
