#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "reports/page.hpp"
#include "tests/reports/hand_made.hpp"

using namespace rayaudit;
using Json = nlohmann::json;

namespace {

const std::string opening = "<script type=\"application/json\" id=\"report\">";

std::string between(const std::string& html, const std::string& before, const std::string& after) {
  const std::size_t first = html.find(before) + before.size();
  return html.substr(first, html.find(after, first) - first);
}

std::string report_text(const std::string& html) { return between(html, opening, "</script>"); }

Json told(const HandMade& made) { return Json::parse(report_text(write_html(made.run(), {}))); }

/// Where the build had no npm there are no pages, and reports/page_absent is all there is to hold.
boost::test_tools::assertion_result is_there(boost::unit_test::test_unit_id) { return has_page(); }

}  // namespace

BOOST_AUTO_TEST_SUITE(pages, *boost::unit_test::precondition(is_there))

BOOST_AUTO_TEST_CASE(a_page_is_whole_and_holds_its_report_and_its_scripts) {
  const std::string html = page("a title", R"({"report":"cost"})");
  BOOST_TEST(html.starts_with("<!doctype html>"));
  BOOST_TEST(html.ends_with("</html>\n"));
  BOOST_TEST(between(html, "<title>", "</title>") == "a title");
  BOOST_TEST(Json::parse(report_text(html)) == Json({{"report", "cost"}}));
  for (const auto* part : {"vegaEmbed", "function audit_page", "function cost_page"})
    BOOST_TEST(html.find(part) != html.npos, part);
}

BOOST_AUTO_TEST_CASE(a_page_without_data_takes_less_than_a_megabyte) {
  BOOST_TEST(page("", "{}").size() < 1'000'000);
}

BOOST_AUTO_TEST_CASE(nothing_in_a_page_may_fetch_anything) {
  const std::string html = page("", "{}");
  BOOST_TEST(between(html, "Content-Security-Policy\" content=\"", "\"")
                 .starts_with("default-src 'none'; style-src 'unsafe-inline'; img-src data: blob:; "
                              "script-src 'sha256-"));
  BOOST_TEST(html.find("<script src") == html.npos);
  BOOST_TEST(html.find("sourceMappingURL") == html.npos);
}

BOOST_AUTO_TEST_CASE(neither_title_nor_report_can_become_markup) {
  const std::string evil = "</title></script><b>&amp;\u2028\u2029";
  const std::string html = page(evil, Json(evil).dump());
  BOOST_TEST(between(html, "<title>", "</title>") ==
             "&lt;/title&gt;&lt;/script&gt;&lt;b&gt;&amp;amp;\u2028\u2029");
  const std::string report = report_text(html);
  BOOST_TEST(report.find_first_of("<>&\xe2") == report.npos, report);
  BOOST_TEST(Json::parse(report) == Json(evil));
}

BOOST_AUTO_TEST_CASE(a_title_that_looks_like_a_place_to_fill_in_is_text) {
  BOOST_TEST(report_text(page("@REPORT@", "\"@TITLE@\"")) == "\"@TITLE@\"");
}

BOOST_AUTO_TEST_CASE(the_name_of_a_subject_is_told_to_the_letter_whatever_it_is) {
  HandMade made;
  made.add("<img src=x onerror=alert(1)>", 1, "far");
  BOOST_TEST(told(made)["subjects"][0]["name"] == "<img src=x onerror=alert(1)>");
  made.add("\xff", 1, "far");
  BOOST_TEST(told(made)["subjects"][1]["name"] == "\uFFFD");
}

BOOST_AUTO_TEST_CASE(an_audit_is_told_with_its_verdicts_errors_margins_and_worst_cases) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  turn(tally, Verdict::false_miss, Claim::none, 7, 3, 40);
  for (const double ulps : {0.25, 1.5, 1.75, 8.0}) tally.ulps.add(ulps);
  tally.curve.add(6, true);
  tally.curve.add(7, false);
  const Json report = told(made), audit = report["audits"][0];
  BOOST_TEST(report["report"] == "audit");
  BOOST_TEST(report["families"][audit["family"].get<int>()]["id"] == "far");
  BOOST_TEST(report["shapes"][audit["shape"].get<int>()] == "sphere");
  BOOST_TEST(audit["verdicts"] == Json({93, 0, 0, 7, 0, 0, 0, 0, 0, 0, 0}));
  BOOST_TEST(audit["ulp"].back() == 8);
  BOOST_TEST(audit["ulps"] == Json({-2, 1, 0, 2, 0, 0, 1}));
  BOOST_TEST(audit["curve"] == Json({2, 2, 1}));
  BOOST_TEST(audit["margin"] == 40);
  const Json outcome = audit["outcomes"][0];
  BOOST_TEST(report["verdicts"][outcome[0].get<int>()] == "false_miss");
  BOOST_TEST(outcome[2] == 7);
  BOOST_TEST(report["findings"][0]["routine"] == "mine");
  BOOST_TEST(report["wrong_verdicts"] == Json({2, 3, 4, 5, 6, 7, 8, 10}));
}

BOOST_AUTO_TEST_CASE(a_case_line_is_told_once_with_what_stands_along_its_ray) {
  HandMade made;
  for (const auto* family : {"far", "unit"})
    turn(made.add("mine/float", 1, family), Verdict::wrong_t, Claim::none, 1, 0.5, 40);
  const Json report = told(made);
  BOOST_TEST(report["lines"].size() == 1);
  const Json line = report["lines"][0];
  BOOST_TEST(line[0].get<std::string>().starts_with("sphere 0x0p+0 0x0p+0 0x1.4p+2 0x1p+0 ray "));
  BOOST_TEST(line[1].size() == 2);
  BOOST_TEST(line[1][0][0] == "proper");
  BOOST_TEST(line[1][0][1].get<double>() == 4.13977, boost::test_tools::tolerance(1e-5));
  BOOST_TEST(line[1][1][0] == "later");
}

BOOST_AUTO_TEST_SUITE_END()
