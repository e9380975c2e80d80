#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <deque>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/case_line.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

constexpr double none = Judgement::unmeasured, infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t sphere = 1, cone = 3;

const Quantity* quantity(std::string_view name) {
  return &*std::ranges::find(quantities(), name, &Quantity::name);
}

/// Climbs made by hand, in the family `grazing`.
struct HandMadeLadder {
  std::deque<Subject> subjects;
  LadderPlan plan = {.subjects = {},
                     .family = &*std::ranges::find(families(), "grazing", &Family::id),
                     .shapes = {sphere, cone},
                     .cases = 1024,
                     .seed = 7,
                     .bounds = {}};
  std::vector<Climb> climbs;

  /// A climb over the rungs from 1 to the most, each of 1,024 cases with the same errors.
  Climb& add(const std::string& name, const Format& format = float_format, int most = 3,
             std::size_t shape = sphere) {
    subjects.push_back({name, format, {}});
    Climb climb = {&subjects.back(), shape};
    climb.held_to = {yardstick(*plan.family)};
    for (int k = 1; k <= most; ++k)
      climb.rungs.push_back({k, 1024, 0, {1, 2, 4}, {3, 5, 6}, {7, 8, 9}, {10, 11, 12}, -3, 5});
    climb.slopes = {0.5, -0.001, 1.25};
    climbs.push_back(climb);
    return climbs.back();
  }

  LadderRun run() const {
    return {"1.2.3",
            plan,
            climbs,
            {"a compiler", "-O2", "a processor", false, false, "to nearest", 2},
            "rayaudit ladder"};
  }
  std::string table(const Look& look = {}) const { return write_ladder_table(run(), look); }
  nlohmann::json json() const { return nlohmann::json::parse(write_ladder_json(run(), {})); }
};

/// Breaks a climb at a difficulty by 40 false misses, where 0 are allowed.
void break_at(Climb& climb, int k) {
  const Bound bound = {climb.subject->name,           "sphere", "grazing",
                       {{quantity("false_miss"), 0}}, false,    "mine.txt:3"};
  const Worst worst = {17, 0, known_case(0.3), Answer::hit(real(4.5)), {}, {}};
  climb.held_to = {bound};
  climb.broken = {k, bound, bound.limits[0], 40, worst};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream from(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(from, line);) lines.push_back(line);
  return lines;
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != text.npos;
}

/// The first line that has the words in it.
std::string line_with(const std::string& text, const std::string& words) {
  for (const std::string& line : lines_of(text))
    if (contains(line, words)) return line;
  return "";
}

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream from(line);
  return {std::istream_iterator<std::string>(from), {}};
}

void check(const std::vector<std::string>& got, const std::vector<std::string>& wanted) {
  BOOST_TEST(got == wanted, boost::test_tools::per_element());
}

}  // namespace

BOOST_AUTO_TEST_CASE(a_row_tells_where_it_holds_to_its_slopes_and_the_largest_own_errors) {
  HandMadeLadder made;
  made.add("certified/float");
  const std::string table = made.table();
  check(words_of(line_with(table, "sphere  ")),
        {"sphere", "holds", "ulp", "own", "case", "k=1", "k=2", "k=3"});
  check(words_of(line_with(table, "  certified/float")),
        {"certified/float", "all", "3", "0.50", "0.00", "1.25", "9", "9", "9"});
  BOOST_TEST(!contains(table, "% wrong"));
  BOOST_TEST(contains(table, "1 of 1 climbs hold to the last k of their format\n"));
}

BOOST_AUTO_TEST_CASE(a_broken_climb_tells_the_last_rung_that_it_holds_to_and_its_wrong_answers) {
  HandMadeLadder made;
  made.add("textbook/float");
  break_at(made.climbs[0], 3);
  made.climbs[0].rungs[2].wrong = 512;
  made.add("handout/float");
  break_at(made.climbs[1], 1);
  const std::string table = made.table();
  BOOST_TEST(words_of(line_with(table, "  textbook/float")).at(1) == "2");
  BOOST_TEST(words_of(line_with(table, "  handout/float")).at(1) == "none");
  check(words_of(line_with(table, "% wrong")), {"%", "wrong", "-", "-", "50.0"});
  BOOST_TEST(contains(table, "0 of 2 climbs hold to the last k of their format\n"));
}

BOOST_AUTO_TEST_CASE(what_was_not_measured_is_a_dash) {
  HandMadeLadder made;
  Climb& climb = made.add("textbook/float");
  climb.slopes = {none, none, none};
  climb.rungs[1].own = {none, none, none};
  climb.rungs[2].own = {1, 1, infinity};
  check(words_of(line_with(made.table(), "  textbook/float")),
        {"textbook/float", "all", "3", "-", "-", "-", "9", "-", "inf"});
}

BOOST_AUTO_TEST_CASE(what_the_cases_are_like_is_told_of_each_format_by_who_hits_most) {
  HandMadeLadder made;
  for (Rung& rung : made.add("blind/float").rungs) rung.condition = {none, none, none};
  made.add("certified/float");
  const std::string table = made.table();
  check(words_of(line_with(table, "case in float, forced error")),
        {"case", "in", "float,", "forced", "error", "in", "ulps", "10", "10", "10"});
  check(words_of(line_with(table, "case in float, margin")),
        {"case", "in", "float,", "margin", "in", "u", "2^5", "2^5", "2^5"});
  BOOST_TEST(!contains(table, "case in double"));
  made.add("textbook/double_double", double_double_format);
  BOOST_TEST(contains(made.table(), "\n  case in double_double, margin in u "));
}

BOOST_AUTO_TEST_CASE(a_long_ladder_shows_its_ends_and_some_between_in_columns_that_fit_the_page) {
  HandMadeLadder made;
  made.add("closest_approach+fast_math/double", double_format, 64).rungs[9].wrong = 3;
  made.add("certified/float", float_format, 22);
  const std::string table = made.table({.everything = true});
  const auto heading = words_of(line_with(table, "sphere  "));
  BOOST_TEST(heading.size() == 5u + 9u);
  BOOST_TEST(heading.at(5) == "k=1");
  BOOST_TEST(std::ranges::count(heading, "k=22") == 1);
  BOOST_TEST(heading.back() == "k=64");
  // What the shorter ladder does not have is empty.
  BOOST_TEST(words_of(line_with(table, "  certified/float")).size() < 6u + 9u);
  for (const std::string& line : lines_of(table)) BOOST_TEST(line.size() <= 120u, line);
}

BOOST_AUTO_TEST_CASE(all_rows_stand_under_their_columns) {
  HandMadeLadder made;
  made.add("textbook/float").rungs[2].wrong = 1;
  const std::string table = made.table();
  const std::size_t width = line_with(table, "sphere  ").size();
  for (const char* words : {"  textbook/float", "% wrong", "forced error in ulps  ", "margin in u"})
    BOOST_TEST(line_with(table, words).size() == width, words);
}

BOOST_AUTO_TEST_CASE(each_shape_has_its_table) {
  HandMadeLadder made;
  made.add("certified/float");
  made.add("certified/double", double_format, 3, cone);
  const std::string table = made.table();
  const std::size_t of_sphere = table.find("\nsphere  "), of_cone = table.find("\ncone  ");
  BOOST_TEST(of_sphere < table.find("  certified/float"));
  BOOST_TEST(table.find("  certified/float") < of_cone);
  BOOST_TEST(of_cone < table.find("  certified/double"));
}

BOOST_AUTO_TEST_CASE(the_case_that_breaks_it_is_told_where_that_is_asked) {
  HandMadeLadder made;
  made.add("textbook/float");
  break_at(made.climbs[0], 2);
  BOOST_TEST(!contains(made.table(), "Where they break first"));
  std::string breaks = made.table({.everything = true});
  breaks = breaks.substr(breaks.find("Where they break first"));
  BOOST_TEST(contains(breaks,
                      "\n  textbook/float on sphere at k = 2: false_miss is 40, more than 0: "
                      "rayaudit explain "),
             breaks);
  std::string words;
  for (const std::string& word : words_of(breaks)) words += word + ' ';
  BOOST_TEST(contains(words, case_line(known_case(0.3))), words);
}

BOOST_AUTO_TEST_CASE(the_table_says_what_was_climbed_and_what_all_were_held_to) {
  HandMadeLadder made;
  made.add("certified/float");
  std::string table = made.table();
  std::ranges::replace(table, '\n', ' ');
  BOOST_TEST(
      table.starts_with("rayaudit 1.2.3: ladder of grazing (impact parameter r(1 +- 2^-k))"));
  BOOST_TEST(contains(table, "1,024 cases for each subject, shape and k; seed 7"));
  BOOST_TEST(contains(table, "max_own 64 wrong_margin 16"));
  made.add("textbook/float");
  break_at(made.climbs[1], 2);
  BOOST_TEST(!contains(made.table(), "max_own 64"));
}

BOOST_AUTO_TEST_CASE(json_has_the_keys_of_schema_1) {
  HandMadeLadder made;
  made.add("certified/float");
  const auto report = made.json();
  BOOST_TEST(report.at("schema") == 1);
  BOOST_TEST(report.at("report") == "ladder");
  BOOST_TEST(report.at("tool").at("version") == "1.2.3");
  BOOST_TEST(report.at("seed") == 7);
  BOOST_TEST(report.at("cases") == 1024);
  BOOST_TEST(report.at("command") == "rayaudit ladder");
  BOOST_TEST(report.at("environment").at("processor") == "a processor");
  BOOST_TEST(report.at("family").at("id") == "grazing");
  BOOST_TEST(report.at("family").at("about") == "impact parameter r(1 +- 2^-k)");
  BOOST_TEST(report.at("family").at("difficulty") == "radius off by 2^-k of it");
  const auto climb = report.at("climbs").at(0);
  BOOST_TEST(climb.at("subject") == "certified/float");
  BOOST_TEST(climb.at("format") == "float");
  BOOST_TEST(climb.at("shape") == "sphere");
  BOOST_TEST(climb.at("held_to") == "max_own 64 wrong_margin 16");
  BOOST_TEST(climb.at("least") == 1);
  BOOST_TEST(climb.at("most") == 3);
  BOOST_TEST(climb.at("holds_to") == 3);
  BOOST_TEST(climb.at("broken").is_null());
  BOOST_TEST(climb.at("slope").at("ulp") == 0.5);
  BOOST_TEST(climb.at("slope").at("own") == -0.001);
  BOOST_TEST(climb.at("slope").at("condition") == 1.25);
}

BOOST_AUTO_TEST_CASE(json_tells_every_rung) {
  HandMadeLadder made;
  made.add("certified/float");
  const auto rungs = made.json().at("climbs").at(0).at("rungs");
  BOOST_TEST(rungs.size() == 3u);
  const auto rung = rungs.at(1);
  BOOST_TEST(rung.at("k") == 2);
  BOOST_TEST(rung.at("cases") == 1024);
  BOOST_TEST(rung.at("wrong") == 0);
  const auto check_errors = [&](const char* key, double half, double most, double all) {
    BOOST_TEST(rung.at(key).at("p50") == half, key);
    BOOST_TEST(rung.at(key).at("p99") == most, key);
    BOOST_TEST(rung.at(key).at("max") == all, key);
  };
  check_errors("ulp", 1, 2, 4);
  check_errors("forced", 3, 5, 6);
  check_errors("own", 7, 8, 9);
  check_errors("condition", 10, 11, 12);
  BOOST_TEST(rung.at("margin").at("p10") == 0.125);
  BOOST_TEST(rung.at("margin").at("p50") == 32);
}

BOOST_AUTO_TEST_CASE(json_tells_what_broke_with_its_case) {
  HandMadeLadder made;
  made.add("textbook/float");
  break_at(made.climbs[0], 2);
  made.add("handout/float");
  break_at(made.climbs[1], 1);
  const auto climbs = made.json().at("climbs");
  BOOST_TEST(climbs.at(0).at("holds_to") == 1);
  BOOST_TEST(climbs.at(1).at("holds_to").is_null());
  const auto broken = climbs.at(0).at("broken");
  BOOST_TEST(broken.at("k") == 2);
  BOOST_TEST(broken.at("limit") == "false_miss");
  BOOST_TEST(broken.at("seen") == 40);
  BOOST_TEST(broken.at("most") == 0);
  const std::string line = broken.at("case");
  const CaseLine read = read_case_line(line);
  BOOST_TEST((read.question == known_case(0.3)), line);
  BOOST_TEST((read.answer == Answer::hit(real(4.5))), line);
}

BOOST_AUTO_TEST_CASE(numbers_that_json_lacks_are_words_or_null) {
  HandMadeLadder made;
  Climb& climb = made.add("textbook/float");
  climb.slopes.own = none;
  climb.rungs[0].ulps = {none, none, none};
  climb.rungs[0].own.all = infinity;
  climb.rungs[0].narrow_margin = climb.rungs[0].half_margin = {};
  const auto told = made.json().at("climbs").at(0);
  BOOST_TEST(told.at("slope").at("own").is_null());
  const auto rung = told.at("rungs").at(0);
  for (const char* key : {"p50", "p99", "max"}) BOOST_TEST(rung.at("ulp").at(key).is_null(), key);
  BOOST_TEST(rung.at("own").at("max") == "inf");
  for (const char* key : {"p10", "p50"}) BOOST_TEST(rung.at("margin").at(key).is_null(), key);
}

}  // namespace rayaudit
