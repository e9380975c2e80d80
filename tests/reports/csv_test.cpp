#include <algorithm>
#include <boost/test/unit_test.hpp>

#include "tests/reports/hand_made.hpp"

namespace rayaudit {
namespace {

using Row = std::vector<std::string>;

/// Reads RFC 4180.
std::vector<Row> parsed(const std::string& text) {
  std::vector<Row> rows;
  Row row(1);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char letter = text[i];
    if (quoted && letter == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      row.back() += text[++i];
    } else if (letter == '"') {
      quoted = !quoted;
    } else if (!quoted && letter == ',') {
      row.emplace_back();
    } else if (!quoted && letter == '\n') {
      rows.push_back(std::move(row));
      row = Row(1);
    } else {
      row.back() += letter;
    }
  }
  return rows;
}

std::string at(const std::vector<Row>& rows, std::size_t row, const std::string& column) {
  const auto found = std::find(rows[0].begin(), rows[0].end(), column);
  BOOST_REQUIRE_MESSAGE(found != rows[0].end(), column);
  return rows[row][found - rows[0].begin()];
}

std::vector<Row> rows_of(const HandMade& made) { return parsed(write_csv(made.run(), {})); }

BOOST_AUTO_TEST_CASE(a_row_for_each_audit_has_a_field_for_each_column) {
  HandMade made;
  turn(made.add("textbook/float", 1, "grazing"), Verdict::false_miss, Claim::none, 7);
  made.add(0, "far").decided_by = {1, 2, 3, 40, 50};
  const auto rows = rows_of(made);
  BOOST_REQUIRE(rows.size() == 3);
  for (const Row& row : rows) BOOST_TEST(row.size() == rows[0].size());
  BOOST_TEST(at(rows, 1, "subject") == "textbook/float");
  BOOST_TEST(at(rows, 1, "shape") == "sphere");
  BOOST_TEST(at(rows, 1, "family") == "grazing");
  BOOST_TEST(at(rows, 1, "cases") == "100");
  BOOST_TEST(at(rows, 1, "false_miss") == "7");
  BOOST_TEST(at(rows, 1, "wrong_below_95") == "");
  BOOST_TEST(at(rows, 2, "shape") == "disk");
  BOOST_TEST(at(rows, 2, "wrong_below_95") == "0.03");
  BOOST_TEST(at(rows, 2, "decided_by_integers") == "40");
  BOOST_TEST(at(rows, 2, "decided_by_exact") == "50");
}

BOOST_AUTO_TEST_CASE(counts_stand_under_their_names) {
  HandMade made;
  Tally& tally = made.add("textbook/float", 1, "grazing");
  turn(tally, Verdict::wrong_root, Claim::declined, 3);
  tally.sides[static_cast<std::size_t>(Side::before)] = 4;
  tally.touches[static_cast<std::size_t>(oracle::Kind::within)] = {5, 6};
  tally.distance.add(8);
  const auto rows = rows_of(made);
  BOOST_TEST(at(rows, 1, "claim_declined") == "3");
  BOOST_TEST(at(rows, 1, "side_before") == "4");
  BOOST_TEST(at(rows, 1, "within_hit") == "5");
  BOOST_TEST(at(rows, 1, "within_miss") == "6");
  BOOST_TEST(at(rows, 1, "distance_max") == "8");
  BOOST_TEST(at(rows, 1, "ulp_max") == "");
}

BOOST_AUTO_TEST_CASE(names_with_commas_quotes_and_line_ends_come_back_whole) {
  HandMade made;
  made.add("a \"fine\", odd\nname", 1, "grazing");
  const auto rows = rows_of(made);
  BOOST_REQUIRE(rows.size() == 2);
  BOOST_TEST(at(rows, 1, "subject") == "a \"fine\", odd\nname");
  BOOST_TEST(at(rows, 1, "family") == "grazing");
}

}  // namespace
}  // namespace rayaudit
