#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "reports/xml_text.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

std::string junit(const HandMade& made) { return write_junit(made.run(), {}); }

/// Does a command that reads XML take the text? True too where there is no such command.
bool takes(const std::string& reader, const std::string& xml) {
  const std::string program = reader.substr(0, reader.find(' '));
  if (std::system(("command -v " + program + " >/dev/null 2>&1").c_str()) != 0) return true;
  const auto file = std::filesystem::temp_directory_path() /
                    ("rayaudit-junit-" + std::to_string(std::rand()) + ".xml");
  std::ofstream(file, std::ios::binary) << xml;
  const int status = std::system((reader + " <" + file.string() + " >/dev/null").c_str());
  std::filesystem::remove(file);
  return status == 0;
}

bool is_well_formed(const std::string& xml) {
  return takes("xmllint --noout -", xml) &&
         takes("python3 -c 'import sys, xml.dom.minidom as m; m.parse(sys.stdin.buffer)'", xml);
}

/// A run with wrong answers of a subject of any name.
HandMade wrong_by(const std::string& subject) {
  HandMade made;
  turn(made.add(subject, 1, "far"), Verdict::false_miss, Claim::none, 7, 0.3, 12);
  made.audits.back().tally.outcome(Verdict::false_miss, Claim::none).worst->diagnosis = {
      Cause::assumption, "a direction of length 1", {}};
  made.add(2, "anywhere");
  return made;
}

BOOST_AUTO_TEST_CASE(a_subject_is_a_suite_and_an_audit_a_testcase) {
  HandMade made = wrong_by("mine/float");
  made.add("other/float", 0, "rim");
  const std::string xml = junit(made);
  BOOST_TEST(is_well_formed(xml), xml);
  BOOST_TEST(contains(xml,
                      "<testsuites name=\"rayaudit 1.2.3\" tests=\"3\" failures=\"1\" errors=\"0\" "
                      "skipped=\"0\" time=\"0\">"),
             xml);
  BOOST_TEST(contains(xml, "<testsuite name=\"mine/float\" tests=\"2\" failures=\"1\""), xml);
  BOOST_TEST(contains(xml, "<testsuite name=\"other/float\" tests=\"1\" failures=\"0\""), xml);
  BOOST_TEST(
      contains(xml, "<testcase classname=\"mine/float.cylinder\" name=\"anywhere\" time=\"0\"/>"),
      xml);
}

BOOST_AUTO_TEST_CASE(a_failure_says_all_that_a_person_needs) {
  const std::string xml = junit(wrong_by("mine/float"));
  for (const std::string part :
       {"<failure type=\"false_miss\" message=\"false_miss in 7 of 100 cases: a miss where there "
        "is a hit\">",
        "\ncase     sphere ", "\ngot      hit 0x1.2p+2 (4.5)\n", "\ntruth    hit 0x1.",
        "\nverdict  false_miss: a miss where there is a hit\n",
        "\nmargin   12 u in float: ", "\ncause    assumption of a direction of length 1\n",
        "\nexplain  rayaudit explain --subject mine/float 'sphere "})
    BOOST_TEST(contains(xml, part), part + "\n" + xml);
}

BOOST_AUTO_TEST_CASE(the_error_is_told_where_one_was_measured) {
  HandMade made;
  turn(made.add("mine/float", 1, "far"), Verdict::wrong_t, Claim::none, 1);
  Judgement& judgement =
      made.audits[0].tally.outcome(Verdict::wrong_t, Claim::none).worst->judgement;
  BOOST_TEST(!contains(junit(made), "\nerror "));
  judgement.ulps = 1234.5, judgement.forced = 2.5;
  BOOST_TEST(contains(junit(made), "\nerror    1.2e3 ulp of float, 2.5 times "), junit(made));
}

BOOST_AUTO_TEST_CASE(every_kind_of_wrong_answer_is_told_the_farthest_from_right_first) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  turn(tally, Verdict::false_hit, Claim::behind, 2, 0.3, 5);
  turn(tally, Verdict::false_miss, Claim::none, 3, 0.3, 50);
  BOOST_TEST(contains(junit(made),
                      "message=\"false_miss in 3 of 100 cases: a miss where there is a hit; "
                      "false_hit (behind) in 2 of 100 cases: "),
             junit(made));
}

BOOST_AUTO_TEST_CASE(a_touch_is_no_failure) {
  HandMade made;
  turn(made.add("mine/float", 1, "tangent"), Verdict::touch, Claim::none, 50);
  BOOST_TEST(contains(junit(made), " failures=\"0\""));
}

BOOST_AUTO_TEST_CASE(where_there_are_bounds_what_breaks_them_fails_and_nothing_else) {
  HandMade made = wrong_by("mine/float");
  made.plan.bounds = read_bounds("mine/* * * false_miss 7 observed\n", "rows.txt");
  BOOST_TEST(contains(junit(made), " failures=\"0\""), junit(made));
  made.plan.bounds = read_bounds("mine/* * * false_hit 0 false_miss 6 observed\n", "rows.txt");
  const std::string xml = junit(made);
  BOOST_TEST(contains(xml, " failures=\"1\""), xml);
  BOOST_TEST(contains(xml,
                      "type=\"false_miss\" message=\"false_miss is 7 of 100 cases, more than the "
                      "observed 6 (rows.txt:1)\""),
             xml);
}

BOOST_AUTO_TEST_CASE(what_the_run_is_to_fail_on_fails_and_nothing_else) {
  HandMade made = wrong_by("mine/float");
  made.fail_on.verdicts[static_cast<std::size_t>(Verdict::false_hit)] = true;
  BOOST_TEST(contains(junit(made), " failures=\"0\""), junit(made));
  made.fail_on.verdicts[static_cast<std::size_t>(Verdict::false_miss)] = true;
  BOOST_TEST(
      contains(junit(made), "<failure type=\"false_miss\" message=\"7 of 100 cases false_miss\">"),
      junit(made));
  HandMade unasked;
  unasked.add("mine/float", 1, "far").unasked = 5;
  unasked.fail_on.most_ulps = 4;
  BOOST_TEST(contains(junit(unasked),
                      "<failure type=\"unasked\" message=\"5 cases were not asked after 100\">"),
             junit(unasked));
}

BOOST_AUTO_TEST_CASE(an_audit_that_was_planned_and_not_asked_is_skipped) {
  HandMade made = wrong_by("mine/float");
  const Subject hung = {"hung/float", float_format, {}};
  Subject answering = hung;
  answering.answer[1] = [](auto, auto) {};
  made.plan.subjects = {&answering};
  for (const Family& family : families())
    if (family.id == "far") made.plan.families.push_back(&family);
  const std::string xml = junit(made);
  BOOST_TEST(is_well_formed(xml), xml);
  BOOST_TEST(contains(xml, "tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\""), xml);
  BOOST_TEST(contains(xml, "<skipped message=\"not asked: "), xml);
}

BOOST_AUTO_TEST_CASE(cases_that_were_not_asked_are_told) {
  HandMade made;
  made.add("mine/float", 1, "far").unasked = 1234;
  BOOST_TEST(contains(junit(made), "<system-out>1,234 cases were not asked: "), junit(made));
}

BOOST_AUTO_TEST_CASE(one_that_does_not_repeat_is_told) {
  HandMade made = wrong_by("mine/float");
  BOOST_TEST(!contains(junit(made), "not reproducible"));
  made.audits[0].tally.outcome(Verdict::false_miss, Claim::none).worst->repeats = false;
  BOOST_TEST(contains(junit(made), "\nagain    not reproducible"));
}

BOOST_AUTO_TEST_CASE(no_name_whatever_its_bytes_breaks_the_xml) {
  std::string every_byte = "]]> --> &amp; <![CDATA[ </failure> \xef\xbf\xbe \xed\xa0\x80 \xc0\x80 ";
  for (int byte = 1; byte < 256; ++byte) every_byte += static_cast<char>(byte);
  const std::string xml = junit(wrong_by(every_byte));
  BOOST_TEST(is_well_formed(xml), xml);
  for (const char letter : xml) {
    const bool is_control = static_cast<unsigned char>(letter) < 0x20 && letter != '\n';
    BOOST_TEST((!is_control || letter == '\t'));
  }
}

BOOST_AUTO_TEST_CASE(text_keeps_what_xml_has_and_spells_what_it_has_not) {
  BOOST_TEST(xml_text("a<b>&\"c\"") == "a&lt;b&gt;&amp;&quot;c&quot;");
  BOOST_TEST(xml_text("]]>") == "]]&gt;");
  BOOST_TEST(xml_text("\x1b[1m\r\n\t") == "\\x1b[1m&#13;\n\t");
  BOOST_TEST(xml_text("\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\xaf") ==
             "\xc3\xa9 \xe2\x82\xac \xf0\x9f\x8e\xaf");
  BOOST_TEST(xml_text("\xff\xc3") == "\\xff\\xc3");
  BOOST_TEST(xml_text("\xed\xa0\x80") == "\\xed\\xa0\\x80");
  BOOST_TEST(xml_text("\xef\xbf\xbf") == "\\xef\\xbf\\xbf");
  BOOST_TEST(xml_text("\xc0\xaf") == "\\xc0\\xaf");
  BOOST_TEST(xml_attribute("key", "a\nb\t\"") == " key=\"a&#10;b&#9;&quot;\"");
}

}  // namespace
}  // namespace rayaudit
