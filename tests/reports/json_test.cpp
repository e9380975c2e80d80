#include <boost/test/unit_test.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "geometry/case_line.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

nlohmann::json parsed(const HandMade& made) {
  return nlohmann::json::parse(write_json(made.run(), {}));
}

BOOST_AUTO_TEST_CASE(the_keys_of_schema_1_are_there) {
  HandMade made;
  turn(made.add("textbook/float", 1, "grazing"), Verdict::false_miss, Claim::none, 7);
  const auto report = parsed(made);
  BOOST_TEST(report.at("schema") == 1);
  BOOST_TEST(report.at("tool").at("version") == "1.2.3");
  BOOST_TEST(report.at("environment").at("rounding") == "to nearest");
  const auto audit = report.at("audits").at(0);
  BOOST_TEST(audit.at("subject") == "textbook/float");
  BOOST_TEST(audit.at("shape") == "sphere");
  BOOST_TEST(audit.at("family") == "grazing");
  BOOST_TEST(audit.at("cases") == 100);
  BOOST_TEST(audit.at("right") == 93);
  BOOST_TEST(audit.at("false_miss") == 7);
  for (const auto* key : {"false_hit", "wrong_root", "wrong_t", "not_finite", "touch",
                          "invalid_handled", "invalid_mishandled"})
    BOOST_TEST(audit.at(key) == 0, key);
  BOOST_TEST(audit.at("decided_by").at("interval") == 100);
  BOOST_TEST(audit.at("decided_by").at("exact") == 0);
  for (const auto* key : {"max", "p50", "p99"}) BOOST_TEST(audit.at("ulp").contains(key), key);
  for (const auto* key : {"max", "p99"}) BOOST_TEST(audit.at("forced").contains(key), key);
}

BOOST_AUTO_TEST_CASE(the_seed_is_exact_to_its_last_bit) {
  BOOST_TEST(parsed({}).at("seed").get<std::uint64_t>() == 0xfedcba9876543210);
}

BOOST_AUTO_TEST_CASE(the_worst_case_is_a_case_line_with_the_answer_appended) {
  HandMade made;
  turn(made.add("textbook/float", 1, "grazing"), Verdict::false_hit, Claim::no_root, 1, 0.3);
  const std::string line = parsed(made).at("audits").at(0).at("worst").at("false_hit");
  const CaseLine read = read_case_line(line);
  BOOST_TEST((read.question == known_case(0.3)), line);
  BOOST_TEST((read.answer == Answer::hit(real(4.5))), line);
}

BOOST_AUTO_TEST_CASE(numbers_that_json_lacks_are_words_or_null) {
  HandMade made;
  Tally& tally = made.add("textbook/float", 1, "grazing");
  tally.ulps.add(infinity);
  const auto audit = parsed(made).at("audits").at(0);
  BOOST_TEST(audit.at("ulp").at("max") == "inf");
  BOOST_TEST(audit.at("forced").at("max").is_null());
}

BOOST_AUTO_TEST_CASE(none_wrong_of_n_bounds_the_share_by_three_nths) {
  HandMade made;
  made.add("textbook/float", 1, "anywhere");
  turn(made.add(1, "far"), Verdict::wrong_t, Claim::none, 1);
  const auto audits = parsed(made).at("audits");
  BOOST_TEST(audits.at(0).at("wrong_below_95").get<double>() == 0.03);
  BOOST_TEST(audits.at(1).at("wrong_below_95").is_null());
}

BOOST_AUTO_TEST_CASE(claims_sides_touches_and_findings_are_named) {
  HandMade made;
  Tally& tally = made.add("handout/float", 0, "within");
  turn(tally, Verdict::false_hit, Claim::mirrored, 5);
  tally.sides[static_cast<std::size_t>(Side::beyond)] = 3;
  tally.touches[static_cast<std::size_t>(oracle::Kind::rim)] = {2, 1};
  const auto report = parsed(made);
  const auto audit = report.at("audits").at(0);
  BOOST_TEST(audit.at("claims").at("mirrored") == 5);
  BOOST_TEST(audit.at("sides").at("beyond") == 3);
  BOOST_TEST(audit.at("touches").at("rim").at("hit") == 2);
  BOOST_TEST(audit.at("touches").at("rim").at("miss") == 1);
  BOOST_TEST(report.at("findings").at(0).at("routine") == "handout");
  BOOST_TEST(report.at("findings").at(0).at("share") == 0.05);
}

BOOST_AUTO_TEST_CASE(causes_margin_and_bound_are_told_for_each_audit) {
  HandMade made;
  Tally& tally = made.add("textbook/float", 1, "far");
  turn(tally, Verdict::false_miss, Claim::none, 10, 0.3, 7);
  turn(tally, Verdict::touch, Claim::none, 5);
  CauseCount& found = tally.outcome(Verdict::false_miss, Claim::none).causes;
  found.add({Cause::flip, {}, {}});
  found.add({Cause::flip, {}, {}});
  found.add({Cause::rounding, {}, {}});
  tally.curve.add(2.5, true);
  tally.curve.add(2.5, false);
  tally.certificate.cases = 8, tally.certificate.certified = 2;
  tally.certificate.proved = Worst{.severity = 12.5};
  tally.certificate.observed = Worst{.severity = 2};
  const auto report = parsed(made);
  const auto audit = report.at("audits").at(0);
  const auto causes = audit.at("causes");
  for (const auto* key : {"formula", "assumption", "unknown"}) BOOST_TEST(causes.at(key) == 0, key);
  BOOST_TEST(causes.at("convention") == 5);
  BOOST_TEST(causes.at("flip") == 2);
  BOOST_TEST(causes.at("rounding") == 1);
  BOOST_TEST(causes.at("replayed") == 3);
  const auto margin = audit.at("margin");
  BOOST_TEST(margin.at("largest_wrong") == 7);
  const std::string line = margin.at("case");
  BOOST_TEST((read_case_line(line).question == known_case(0.3)), line);
  BOOST_TEST(margin.at("curve") == nlohmann::json::parse("[[1, 2, 1]]"));
  BOOST_TEST(audit.at("certified").at("share") == 0.25);
  BOOST_TEST(audit.at("certified").at("wrong") == 0);
  BOOST_TEST(audit.at("bound").at("proved_ulp") == 12.5);
  BOOST_TEST(audit.at("bound").at("observed_ulp") == 2);
  BOOST_TEST(report.at("findings").at(0).at("margin") == 7);
  BOOST_TEST(report.at("findings").at(0).at("causes").at("flip") == 2);
}

BOOST_AUTO_TEST_CASE(what_nothing_is_known_of_is_null) {
  HandMade made;
  made.add("textbook/float", 1, "far");
  const auto audit = parsed(made).at("audits").at(0);
  BOOST_TEST(audit.at("margin").at("largest_wrong").is_null());
  BOOST_TEST(audit.at("certified").at("share").is_null());
  BOOST_TEST(audit.at("bound").at("proved_ulp").is_null());
}

BOOST_AUTO_TEST_CASE(what_was_declared_is_on_record) {
  HandMade made;
  made.plan.convention.of(oracle::Kind::tangent) = Convention::Stance::miss;
  made.plan.difficulty = 7;
  const auto report = parsed(made);
  BOOST_TEST(report.at("convention").at("tangent") == "miss");
  BOOST_TEST(report.at("convention").at("rim") == "either");
  BOOST_TEST(report.at("difficulty") == 7);
  BOOST_TEST(report.at("limits").at("wrong_t") == 0.0078125);
}

BOOST_AUTO_TEST_CASE(what_a_subject_declares_itself_is_on_record) {
  HandMade made;
  made.add("textbook/float", 1, "far");
  made.add("mine/float", 1, "far");
  made.subjects.back().convention.of(oracle::Kind::rim) = Convention::Stance::hit;
  made.subjects.back().convention.t_min = 0.5;
  const auto declared = parsed(made).at("declared");
  BOOST_TEST(declared.size() == 1);
  BOOST_TEST(declared.at("mine/float").at("rim") == "hit");
  BOOST_TEST(declared.at("mine/float").at("t_min") == 0.5);
}

BOOST_AUTO_TEST_CASE(trouble_of_a_subject_elsewhere_is_on_record) {
  HandMade made;
  Tally& tally = made.add("mine/float", 1, "far");
  turn(tally, Verdict::crashed, Claim::none, 7);
  tally.unasked = 13;
  Worst& worst = *tally.outcome(Verdict::crashed, Claim::none).worst;
  worst.answer = Answer::crashed(11);
  worst.repeats = false;
  const auto report = parsed(made);
  BOOST_TEST(report.at("audits").at(0).at("crashed") == 7);
  BOOST_TEST(report.at("audits").at(0).at("unasked") == 13);
  const auto finding = report.at("findings").at(0);
  BOOST_TEST(finding.at("signal") == "SIGSEGV");
  BOOST_TEST(finding.at("reproducible") == false);
  BOOST_TEST(finding.at("example").get<std::string>().ends_with(" crashed"));
}

BOOST_AUTO_TEST_CASE(the_number_of_threads_leaves_no_trace) {
  HandMade made;
  made.add("textbook/float", 1, "anywhere");
  const std::string one = write_json(made.run(), {});
  made.plan.threads = 7;
  BOOST_TEST(write_json(made.run(), {}) == one);
}

BOOST_AUTO_TEST_CASE(a_name_that_is_no_text_does_not_stop_the_report) {
  HandMade made;
  made.add("odd\xff/float", 1, "anywhere");
  BOOST_TEST(parsed(made).at("audits").size() == 1);
}

}  // namespace
}  // namespace rayaudit
