#include <boost/test/unit_test.hpp>
#include <nlohmann/json.hpp>

#include "tests/cli/shell.hpp"

using nlohmann::json;
using shell::contains;
using shell::Folder;
using shell::refused;

namespace {

namespace fs = std::filesystem;

fs::path shipped(const std::string& file) { return fs::path(RAYAUDIT_DATA "/bounds") / file; }

/// An audit held to the rows, in a folder of its own.
shell::Ended held(const std::string& rows, const std::string& arguments = "") {
  const Folder folder;
  folder.write("rows.txt", rows);
  return folder.run("rayaudit audit --bounds rows.txt --cases 1000 " + arguments);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_shipped_bounds_hold) {
  for (const std::string file : {"robust.txt", "certified.txt"}) {
    const auto ended = shell::run("rayaudit audit --bounds '" + shipped(file).string() +
                                  "' --cases 1000 --report csv=/dev/null");
    BOOST_TEST(ended == shell::printed(""), file);
  }
}

BOOST_AUTO_TEST_CASE(the_shipped_bounds_break_where_they_are_made_too_strict) {
  const Folder folder;
  const auto ended = folder.run(
      "sed 's/max_forced [^ ]*/max_forced 0.01/' '" + shipped("robust.txt").string() +
      "' >strict.txt\n"
      "rayaudit audit --bounds strict.txt --cases 100 --report csv=/dev/null --family anywhere");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(contains(ended.err, "max_forced 0.01"));
}

BOOST_AUTO_TEST_CASE(a_bound_that_holds_is_silent) {
  const auto ended = held("textbook/double sphere anywhere wrong_t 0 max_ulp 1e12 observed\n");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "\nBounds: of 1 row, every limit is kept\n"));
  BOOST_TEST(contains(ended.out, "textbook/double"));
}

BOOST_AUTO_TEST_CASE(a_broken_bound_is_told_with_its_row_and_the_case) {
  const auto ended = held("# mine\ntextbook/float  sphere far  wrong_t 1000 max_ulp 4 observed\n");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(
      ended.err.starts_with("rayaudit: rows.txt:2: `textbook/float sphere far wrong_t 1000 max_ulp "
                            "4 observed` is broken by textbook/float on sphere, family far: "
                            "max_ulp is "),
      ended.err);
  BOOST_TEST(contains(ended.err, ", more than 4; cause: rounding: rayaudit explain --"));
  BOOST_TEST(shell::line_count(ended.err) == 1);
}

BOOST_AUTO_TEST_CASE(a_count_beyond_its_bound_is_told_of_how_many) {
  const auto ended = held("textbook/float sphere far false_hit 1 observed\n");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(contains(ended.err, " of 1,000 cases, more than 1; cause: flip at routines/"),
             ended.err);
}

BOOST_AUTO_TEST_CASE(the_explain_command_of_a_broken_bound_shows_it) {
  const Folder folder;
  folder.write("rows.txt", "textbook/float sphere far false_hit 0 observed\n");
  const auto ended = folder.run(
      "rayaudit audit --bounds rows.txt --cases 1000 2>why >/dev/null\n"
      "eval \"$(sed 's/.*: rayaudit explain/rayaudit explain/' why)\"");
  BOOST_TEST(contains(ended.out, "false_hit"), ended);
}

BOOST_AUTO_TEST_CASE(of_many_broken_bounds_ten_are_told_unless_all_are_asked_for) {
  const std::string rows = "textbook/* * * max_ulp 0 observed\n";
  const auto some = held(rows, "--report csv=/dev/null");
  BOOST_TEST(some.code == 1);
  BOOST_TEST(shell::line_count(some.err) == 11);
  BOOST_TEST(contains(some.err, " more limits are broken: --all-findings tells all\n"));
  const auto all = held(rows, "--report csv=/dev/null --all-findings");
  BOOST_TEST(all.code == 1);
  BOOST_TEST(shell::line_count(all.err) > 100);
  BOOST_TEST(!contains(all.err, "--all-findings"));
  const auto eleven = held(rows,
                           "--report csv=/dev/null textbook/float --shape disk,sphere "
                           "--family anywhere,grazing,far,length,unit,axis");
  BOOST_TEST(shell::line_count(eleven.err) >= 11, eleven);
}

BOOST_AUTO_TEST_CASE(only_what_the_rows_name_is_audited) {
  const std::string rows =
      "textbook/float sphere far max_ulp 1e30 observed\n"
      "textbook/* disk far max_ulp 1e30 observed\n";
  const auto count = [&](const std::string& arguments) {
    const auto ended = held(rows, "--report json " + arguments);
    BOOST_TEST(ended.code == 0);
    return json::parse(ended.out)["audits"].size();
  };
  BOOST_TEST(count("") == 4u);
  BOOST_TEST(count("--shape disk") == 3u);
  BOOST_TEST(count("'*/float'") == 2u);
  BOOST_TEST(count("textbook/float textbook/double --family far,rim --shape sphere") == 1u);
}

BOOST_AUTO_TEST_CASE(every_file_of_bounds_is_held) {
  const Folder folder;
  folder.write("a.txt", "textbook/float sphere far max_ulp 1e30 observed\n");
  folder.write("b.txt", "textbook/float disk far max_ulp 0 observed\n");
  const auto ended =
      folder.run("rayaudit audit --bounds a.txt --bounds b.txt --cases 1000 --report json");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(json::parse(ended.out)["audits"].size() == 2u);
  BOOST_TEST(contains(ended.err, "b.txt:1: "));
}

BOOST_AUTO_TEST_CASE(bounds_are_read_from_standard_input) {
  const auto ended = shell::run(
      "echo textbook/float disk far max_ulp 0 observed | rayaudit audit --bounds - --cases 100");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(contains(ended.err, "rayaudit: stdin:1: "));
}

BOOST_AUTO_TEST_CASE(a_bad_row_is_refused_with_its_place) {
  BOOST_TEST(held("\ntextbok/float sphere far wrong 0 observed\n") ==
             refused(2,
                     "rows.txt:2: subject `textbok/float` is not known; did you mean "
                     "`textbook/float`?"));
  BOOST_TEST(held("textbook/float sphere far max_ulp few observed\n") ==
             refused(2, "rows.txt:1: max_ulp must be a number, 0 or more, got `few`"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_refused) {
  BOOST_TEST(shell::run("rayaudit audit --bounds nowhere.txt") ==
             refused(2, "`nowhere.txt` cannot be read: No such file or directory"));
  BOOST_TEST(shell::run("rayaudit audit --bounds .") ==
             refused(2, "`.` cannot be read: Is a directory"));
}

BOOST_AUTO_TEST_CASE(where_nothing_is_held_the_exit_code_is_4) {
  BOOST_TEST(held("# nothing\n") == refused(4, "rows.txt has no row: nobody is held to anything"));
  const std::string row = "textbook/float sphere far wrong 0 observed\n";
  BOOST_TEST(held(row, "--shape disk") ==
             refused(4,
                     "nothing was held: no row of rows.txt is about a chosen subject, shape and "
                     "family"));
  const std::string nobody =
      "names no audit there is: no such subject answers such a shape that such a family draws";
  BOOST_TEST(held(row + "textbook/float sphere rim wrong 0 observed\n") ==
             refused(4, "rows.txt:2: `textbook/float sphere rim` " + nobody));
  BOOST_TEST(held("nobody/* sphere far wrong 0 observed\n") ==
             refused(4, "rows.txt:1: `nobody/* sphere far` " + nobody));
}

BOOST_AUTO_TEST_CASE(what_is_written_holds_on_the_same_run) {
  const Folder folder;
  const std::string audit = "rayaudit audit '*/float' 'closest_approach/*' --cases 100 --seed 3 ";
  const auto written = folder.run(audit + "--report csv=/dev/null --write-bounds rows.txt");
  BOOST_TEST(written == shell::printed(""));
  const std::string rows = folder.text("rows.txt");
  BOOST_TEST(rows.starts_with("# What rayaudit "));
  BOOST_TEST(contains(rows, " observed in 100 cases for each subject, shape and family, seed 3"));
  BOOST_TEST(contains(rows,
                      "\n#   rayaudit audit '*/float' 'closest_approach/*' --cases 100 --seed 3 "
                      "--report csv=/dev/null --write-bounds rows.txt\n"));
  BOOST_TEST(shell::line_count(rows) > 300);
  BOOST_TEST(!contains(rows, " proved\n"));
  const auto held = folder.run(audit + "--report csv=/dev/null --bounds rows.txt");
  BOOST_TEST(held == shell::printed(""));
  const auto cut = folder.run("sed -i 's/max_forced [^ ]*/max_forced 0/' rows.txt\n" + audit +
                              "--report csv=/dev/null --bounds rows.txt");
  BOOST_TEST(cut.code == 1);
}

BOOST_AUTO_TEST_CASE(bounds_written_to_standard_output_come_alone) {
  const std::string audit = "rayaudit audit textbook/float --shape disk --family far --cases 100 ";
  const auto alone = shell::run(audit + "--write-bounds -");
  BOOST_TEST(alone.code == 0);
  BOOST_TEST(alone.out.starts_with("# What rayaudit "));
  BOOST_TEST(shell::line_count(alone.out) == 4);
  BOOST_TEST(shell::run(audit + "--write-bounds - --report table") ==
             refused(2, "two reports to standard output: name a file, as in --report json=FILE"));
  BOOST_TEST(shell::run(audit + "--write-bounds a.json --report json=a.json") ==
             refused(2, "two reports to the file `a.json`"));
  BOOST_TEST(shell::run(audit + "--write-bounds ''") ==
             refused(2, "--write-bounds: expected a file"));
}

BOOST_AUTO_TEST_CASE(headroom_grants_more) {
  const std::string audit =
      "rayaudit audit closest_approach/float --shape sphere --family lattice --cases 5000 "
      "--write-bounds - ";
  const auto most = [&](const std::string& arguments) {
    const auto ended = shell::run(audit + arguments + " | sed -n 's/.*max_forced //p'");
    BOOST_TEST(ended.err == "");
    return std::stod(ended.out);
  };
  const double plain = most("");
  BOOST_TEST(plain > 0);
  BOOST_TEST(most("--headroom 4") > 3.5 * plain);
  BOOST_TEST(most("--headroom 4") < 4.5 * plain);
  BOOST_TEST(shell::run("rayaudit audit --headroom 2").code == 2);
}

BOOST_AUTO_TEST_CASE(thorough_looks_into_every_case) {
  const auto looked_into = [](const std::string& arguments) {
    const auto ended = shell::run(
        "rayaudit audit textbook/float --shape sphere --family anywhere --cases 1024 --report "
        "json " +
        arguments);
    const json audit = json::parse(ended.out)["audits"][0];
    return audit["certified"]["cases"].get<int>();
  };
  BOOST_TEST(looked_into("") == 32);
  BOOST_TEST(looked_into("--thorough") == 1024);
}
