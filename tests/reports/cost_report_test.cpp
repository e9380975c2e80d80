#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <deque>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "reports/report.hpp"
#include "reports/steps.hpp"
#include "tests/audit/named.hpp"

namespace rayaudit {
namespace {

constexpr double none = Accuracy::unmeasured, infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t sphere = 1;
constexpr Look every_way = {.everything = true};

/// Costs on the sphere made by hand, of one easy family and one hard one.
struct HandMadeCost {
  std::deque<Subject> subjects;
  CostPlan plan = {{}, {family_of("anywhere"), family_of("grazing")}, {sphere}, 4096, 7, 3, 1};
  Cost cost = {{1.5, 2.25, 2.75},
               {{sphere, Scope::all, nullptr, {}},
                {sphere, Scope::easy, nullptr, {}},
                {sphere, Scope::hard, nullptr, {}},
                {sphere, Scope::family, family_of("anywhere"), {}},
                {sphere, Scope::family, family_of("grazing"), {}}},
               {}};

  /// A way that takes so long on easy cases and on hard ones, and is wrong so often of a million.
  void add(const std::string& name, double easy, double hard, std::uint64_t wrong,
           double error = 1) {
    subjects.push_back({name, double_format, {}});
    for (Cell& cell : cost.cells) {
      const bool is_easy = cell.scope == Scope::easy || cell.family == family_of("anywhere");
      const double at = cell.scope == Scope::all ? (easy + hard) / 2 : is_easy ? easy : hard;
      Way way = {&subjects.back(), {0.99 * at, at, 1.01 * at}, {}, 1024, {}};
      way.nanoseconds = spread(way.rounds);
      way.accuracy.cases = 1'000'000;
      way.accuracy.wrong = wrong;
      way.accuracy.verdicts[static_cast<std::size_t>(Verdict::false_miss)] = wrong;
      way.accuracy.ulps = way.accuracy.error = way.accuracy.forced = error;
      if (wrong > 0) way.accuracy.wrong_margin = 12;
      cell.ways.push_back(way);
      mark_front(cell.ways);
    }
  }

  CostRun run() const {
    return {"1.2.3",
            plan,
            cost,
            {"a compiler", "-O2", "a processor", false, false, "to nearest", 2},
            "rayaudit cost"};
  }
  std::string table(const Look& look = {}) const { return write_cost_table(run(), look); }
  nlohmann::json json() const { return nlohmann::json::parse(write_cost_json(run(), {})); }
};

HandMadeCost three_ways() {
  HandMadeCost made;
  made.add("textbook/float", 10, 11, 3120, 4e6);
  made.add("certified/float", 14, 14.1, 0, 0.5);
  made.add("slow/double", 99, 198, 17);
  return made;
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

/// The line of a subject in the table of a heading; empty where it has none.
std::string row(const std::string& table, const std::string& heading, const std::string& subject) {
  bool is_here = false;
  for (const std::string& line : lines_of(table)) {
    if (line.starts_with("sphere, ")) is_here = line.starts_with(heading);
    const std::size_t name = line.find_first_not_of(" *");
    if (is_here && name != line.npos && line.substr(name).starts_with(subject + ' ')) return line;
  }
  return "";
}

std::string last_word(const std::string& line) { return line.substr(line.rfind(' ') + 1); }

Step step_between(const Way& from, const Way& to) { return {&from, &to, {1.35, 1.4, 1.46}}; }

}  // namespace

BOOST_AUTO_TEST_CASE(none_wrong_is_told_with_the_most_that_there_may_be) {
  const auto told_of = [](std::uint64_t cases, std::uint64_t wrong) {
    Accuracy accuracy;
    accuracy.cases = cases;
    accuracy.wrong = wrong;
    return per_million(accuracy);
  };
  BOOST_TEST(told_of(4096, 0) == "0, < 732");
  BOOST_TEST(told_of(64, 0) == "0, < 46,875");
  BOOST_TEST(told_of(10'000'000, 0) == "0, < 0.3");
  BOOST_TEST(told_of(1'000'000, 3120) == "3,120");
  BOOST_TEST(told_of(100, 100) == "1,000,000");
  BOOST_TEST(told_of(10'000'000, 1) == "< 1");
}

BOOST_AUTO_TEST_CASE(a_step_to_fewer_wrong_answers_names_the_verdict_that_it_mends_most) {
  HandMadeCost made = three_ways();
  Way from = made.cost.cells[0].ways[0];
  const Way& to = made.cost.cells[0].ways[1];
  BOOST_TEST(told(step_between(from, to)) ==
             "from textbook/float to certified/float: 1.4 times the time (1.35 to 1.46), wrong "
             "3,120 to 0 per million (false misses 3,120 to 0)");
  from.accuracy.verdicts = {};
  const auto turn_all_to = [&](Verdict verdict) -> const Way& {
    from.accuracy.verdicts = {};
    from.accuracy.verdicts[static_cast<std::size_t>(verdict)] = 3120;
    return from;
  };
  BOOST_TEST(
      contains(told(step_between(turn_all_to(Verdict::false_hit), to)), "(false hits 3,120 to 0)"));
  BOOST_TEST(contains(told(step_between(turn_all_to(Verdict::wrong_root), to)),
                      "(wrong roots 3,120 to 0)"));
  BOOST_TEST(
      contains(told(step_between(turn_all_to(Verdict::wrong_t), to)), "(wrong t 3,120 to 0)"));
  BOOST_TEST(contains(told(step_between(turn_all_to(Verdict::not_finite), to)),
                      "(t that are not finite 3,120 to 0)"));
  BOOST_TEST(contains(told(step_between(turn_all_to(Verdict::invalid_mishandled), to)),
                      "(invalid cases mishandled 3,120 to 0)"));
}

BOOST_AUTO_TEST_CASE(a_step_between_ways_as_often_wrong_tells_the_worst_errors) {
  HandMadeCost made;
  made.add("textbook/double", 10, 10, 5, 3.2e-4);
  made.add("oracle/double", 20, 20, 5, 9.3e-10);
  Way from = made.cost.cells[0].ways[0];
  const Way& to = made.cost.cells[0].ways[1];
  BOOST_TEST(told(step_between(from, to)) ==
             "from textbook/double to oracle/double: 1.4 times the time (1.35 to 1.46), worst "
             "error 3.2e-4 to 9.3e-10 units of float");
  from.accuracy.bare = 1;
  BOOST_TEST(told(step_between(from, to)).ends_with("(1.35 to 1.46), and t is told"));
}

BOOST_AUTO_TEST_CASE(the_table_tells_the_front_the_fastest_first_and_its_steps) {
  const std::string table = three_ways().table();
  const std::string fast = row(table, "sphere, 2 families", "textbook/float");
  const std::string right = row(table, "sphere, 2 families", "certified/float");
  BOOST_TEST(contains(fast, " 10.5 "), fast);
  BOOST_TEST(contains(fast, " 10.4-10.6 "), fast);
  BOOST_TEST(contains(fast, " 3,120 "), fast);
  BOOST_TEST(contains(fast, " 12 "), fast);
  BOOST_TEST(contains(fast, " 4.0e6 "), fast);
  BOOST_TEST(contains(right, " 0, < 3 "), right);
  BOOST_TEST(table.find(fast) < table.find(right));
  BOOST_TEST(row(table, "sphere, 2 families", "slow/double") == "");
  BOOST_TEST(contains(table, "    and 1 way that others are better than\n"));
  BOOST_TEST(contains(table, "\n    from textbook/float to certified/float: 1.34 times the time"));
}

BOOST_AUTO_TEST_CASE(every_way_is_told_where_that_is_asked_and_the_front_marked) {
  const std::string table = three_ways().table(every_way);
  BOOST_TEST(row(table, "sphere, 2 families", "textbook/float").starts_with("* "));
  BOOST_TEST(row(table, "sphere, 2 families", "certified/float").starts_with("* "));
  BOOST_TEST(row(table, "sphere, 2 families", "slow/double").starts_with("  slow/double"));
  BOOST_TEST(!contains(table, "others are better than"));
}

BOOST_AUTO_TEST_CASE(hard_cases_have_a_price_only_where_they_can_be_told_from_easy_ones) {
  const std::string table = three_ways().table(every_way);
  BOOST_TEST(last_word(row(table, "sphere, 2 families", "slow/double")) == "2");
  BOOST_TEST(last_word(row(table, "sphere, 2 families", "certified/float")) == "-");
  // 10 and 11: no more than ten per cent apart.
  BOOST_TEST(last_word(row(table, "sphere, 2 families", "textbook/float")) == "-");
  for (const char* part : {"sphere, the 1 easy family ", "sphere, the 1 hard family "})
    BOOST_TEST(last_word(row(table, part, "slow/double")) == "-");
  HandMadeCost cheaper;
  cheaper.add("cheaper/double", 20, 10, 0);
  BOOST_TEST(last_word(row(cheaper.table(), "sphere, 2 families", "cheaper/double")) == "0.5");
}

BOOST_AUTO_TEST_CASE(each_family_has_a_table_where_that_is_asked_or_it_is_the_only_one) {
  HandMadeCost made = three_ways();
  BOOST_TEST(!contains(made.table(), "sphere, family grazing"));
  const std::string each = made.table({.families = true});
  for (const char* heading :
       {"sphere, 2 families ", "sphere, family anywhere ", "sphere, family grazing "})
    BOOST_TEST(contains(each, heading), each);
  made.plan.families = {family_of("grazing")};
  made.cost.cells = {made.cost.cells[0], made.cost.cells[2], made.cost.cells[4]};
  const std::string only = made.table();
  BOOST_TEST(contains(only, "sphere, family grazing "));
  BOOST_TEST(!contains(only, "sphere, 1 family"));
}

BOOST_AUTO_TEST_CASE(a_count_of_less_than_one_in_a_million_is_no_0) {
  HandMadeCost made;
  made.add("textbook/float", 10, 11, 1);
  for (Way& way : made.cost.cells[0].ways) way.accuracy.cases = 10'000'000;
  const std::string line = row(made.table(), "sphere, 2 families", "textbook/float");
  // Wrong, and of these false misses.
  BOOST_TEST(std::ranges::count(line, '<') == 2, line);
}

BOOST_AUTO_TEST_CASE(where_all_are_wrong_alike_that_is_told_in_a_word) {
  HandMadeCost made;
  made.add("handout/float", 10, 11, 1'000'000);
  const std::string line = row(made.table(), "sphere, 2 families", "handout/float");
  BOOST_TEST(contains(line, " 1,000,000 "), line);
  BOOST_TEST(contains(line, " all "), line);
}

BOOST_AUTO_TEST_CASE(no_line_is_wider_than_the_page_and_columns_stay_in_line) {
  HandMadeCost made = three_ways();
  made.add("closest_approach+fast_math/double", 54'321, 65'432, 0, infinity);
  made.add("stable_quadratic+fast_math/double", 1.23, 1, 999'999, 9.9e-12);
  for (Cell& cell : made.cost.cells) {
    Accuracy& accuracy = cell.ways.back().accuracy;
    accuracy.wrong_margin = accuracy.ulps = accuracy.forced = 1.2e15;
  }
  made.cost.untimed = {{&made.subjects[0], std::string(300, 'x') + " and more"}};
  std::size_t width = 0;
  for (const std::string& line : lines_of(made.table({.everything = true, .families = true}))) {
    if (!contains(line, "xxx")) BOOST_TEST(line.size() <= 120u, line);
    if (line.starts_with("sphere, ")) width = line.size();
    if (line.starts_with("  closest") || line.starts_with("* stable")) {
      BOOST_TEST(line.size() == width, line);
      std::istringstream words(line.substr(2));
      const auto count = std::distance(std::istream_iterator<std::string>(words), {});
      BOOST_TEST(count == (contains(line, "0, <") ? 13 : 11), line);
    }
  }
  BOOST_TEST(width > 0u);
}

BOOST_AUTO_TEST_CASE(colour_takes_no_room) {
  const HandMadeCost made = three_ways();
  std::string coloured = made.table({.colour = true, .everything = true});
  BOOST_TEST(contains(coloured, "\x1b["));
  for (std::size_t from; (from = coloured.find('\x1b')) != coloured.npos;)
    coloured.erase(from, coloured.find('m', from) - from + 1);
  BOOST_TEST(coloured == made.table(every_way));
}

BOOST_AUTO_TEST_CASE(what_could_not_be_timed_is_told_with_its_reason) {
  HandMadeCost made = three_ways();
  made.cost.untimed = {{&made.subjects[2], "slow/double broke off"}};
  BOOST_TEST(contains(made.table(), "\nNot measured: slow/double broke off\n"));
  const auto absent = made.json().at("absent");
  BOOST_TEST(absent.back().at("subjects") == "slow/double");
  BOOST_TEST(absent.back().at("why") == "slow/double broke off");
}

BOOST_AUTO_TEST_CASE(the_table_says_what_was_measured_and_where) {
  std::string table = three_ways().table();
  std::ranges::replace(table, '\n', ' ');
  BOOST_TEST(table.starts_with("rayaudit 1.2.3: what being right costs; 4,096 cases for each way"));
  BOOST_TEST(contains(table, "3 rounds of 1,024 of them; of dear ways fewer; seed 7"));
  BOOST_TEST(contains(table, "; up to 2.25 of them are spent on reading a case and writing"));
  BOOST_TEST(contains(table, "a compiler with -O2; a processor"));
}

BOOST_AUTO_TEST_CASE(json_has_the_keys_of_schema_1) {
  const auto report = three_ways().json();
  BOOST_TEST(report.at("schema") == 1);
  BOOST_TEST(report.at("report") == "cost");
  BOOST_TEST(report.at("tool").at("version") == "1.2.3");
  BOOST_TEST(report.at("seed") == 7);
  BOOST_TEST(report.at("cases") == 4096);
  BOOST_TEST(report.at("rounds") == 3);
  BOOST_TEST(report.at("timed_cases") == 1024);
  BOOST_TEST(report.at("apart") == 0.1);
  BOOST_TEST(report.at("command") == "rayaudit cost");
  BOOST_TEST(report.at("idle_ns").at(0) == 1.5);
  BOOST_TEST(report.at("idle_ns").at(1) == 2.25);
  BOOST_TEST(report.at("idle_ns").at(2) == 2.75);
  BOOST_TEST(report.at("environment").at("processor") == "a processor");
  BOOST_TEST(report.at("absent").is_array());
  BOOST_TEST(report.at("cells").size() == 5u);
  BOOST_TEST(report.at("prices").size() == 3u);
}

BOOST_AUTO_TEST_CASE(json_tells_every_way_of_every_cell) {
  const auto cells = three_ways().json().at("cells");
  const std::vector<std::string> groups = {"all", "easy", "hard", "family", "family"};
  for (std::size_t i = 0; i < 5; ++i) {
    BOOST_TEST(cells.at(i).at("shape") == "sphere");
    BOOST_TEST(cells.at(i).at("group") == groups[i]);
    BOOST_TEST(cells.at(i).at("ways").size() == 3u);
    BOOST_TEST(cells.at(i).at("family").is_null() == (i < 3));
  }
  BOOST_TEST(cells.at(4).at("family") == "grazing");
  const auto way = cells.at(1).at("ways").at(0);
  BOOST_TEST(way.at("subject") == "textbook/float");
  BOOST_TEST(way.at("format") == "double");
  BOOST_TEST(way.at("ns").at(1) == 10);
  BOOST_TEST(way.at("ns").at(0) < 10);
  BOOST_TEST(way.at("ns").at(2) > 10);
  BOOST_TEST(way.at("timed") == 1024);
  BOOST_TEST(way.at("cases") == 1'000'000);
  BOOST_TEST(way.at("wrong") == 3120);
  BOOST_TEST(way.at("wrong_per_million") == 3120);
  BOOST_TEST(way.at("per_million").at("false_miss") == 3120);
  BOOST_TEST(way.at("per_million").at("wrong_t") == 0);
  BOOST_TEST(!way.at("per_million").contains("right"));
  BOOST_TEST(way.at("wrong_margin") == 12);
  for (const char* key : {"max_ulp", "max_forced", "error"}) BOOST_TEST(way.at(key) == 4e6, key);
  BOOST_TEST(way.at("front") == true);
  BOOST_TEST(cells.at(1).at("ways").at(2).at("front") == false);
}

BOOST_AUTO_TEST_CASE(json_tells_steps_and_prices_with_their_spread) {
  const auto report = three_ways().json();
  const auto steps = report.at("cells").at(1).at("steps");
  BOOST_TEST(steps.size() == 1u);
  BOOST_TEST(steps.at(0).at("from") == "textbook/float");
  BOOST_TEST(steps.at(0).at("to") == "certified/float");
  BOOST_TEST(steps.at(0).at("times").at(1) == 1.4);
  BOOST_TEST(std::string(steps.at(0).at("text")).starts_with("from textbook/float to certified/"));
  const auto price = report.at("prices").at(2);
  BOOST_TEST(price.at("shape") == "sphere");
  BOOST_TEST(price.at("subject") == "slow/double");
  BOOST_TEST(price.at("easy").at(1) == 99);
  BOOST_TEST(price.at("hard").at(1) == 198);
  BOOST_TEST(price.at("times").at(1) == 2);
}

BOOST_AUTO_TEST_CASE(numbers_that_json_lacks_are_words_or_null) {
  HandMadeCost made;
  made.add("textbook/float", 10, 11, 0, infinity);
  made.add("handout/float", 10, 11, 0, none);
  const auto ways = made.json().at("cells").at(0).at("ways");
  BOOST_TEST(ways.at(0).at("wrong_margin").is_null());
  BOOST_TEST(ways.at(0).at("error") == "inf");
  for (const char* key : {"max_ulp", "max_forced", "error"})
    BOOST_TEST(ways.at(1).at(key).is_null(), key);
}

}  // namespace rayaudit
