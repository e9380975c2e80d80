#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;
using shell::run;

BOOST_AUTO_TEST_CASE(a_small_run_tells_who_holds_and_exits_with_0) {
  const auto ended = run("rayaudit ladder 'certified/*' --shape sphere --cases 64");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, ": ladder of grazing "), ended);
  BOOST_TEST(contains(ended.out, "\nsphere  "), ended);
  BOOST_TEST(contains(ended.out, "\n  certified/float              all 22 "), ended);
  BOOST_TEST(contains(ended.out, "\n  certified/double             all 51 "), ended);
  BOOST_TEST(contains(ended.out, "\n2 of 2 climbs hold to the last k of their format\n"), ended);
}

BOOST_AUTO_TEST_CASE(who_breaks_no_bound_of_a_file_is_no_finding_and_its_case_is_told_where_asked) {
  const std::string line = "rayaudit ladder textbook/float --family far --shape sphere --cases 64";
  const auto ended = run(line);
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "\n0 of 1 climbs hold to the last k of their format\n"), ended);
  BOOST_TEST(!contains(ended.out, "rayaudit explain"));
  BOOST_TEST(contains(run(line + " --breaks").out, "\n  textbook/float on sphere at k = "));
}

BOOST_AUTO_TEST_CASE(a_ladder_is_the_same_for_any_number_of_threads) {
  const auto written = [](const std::string& threads) {
    return run(
        "rayaudit ladder '*/float' --family far --shape sphere,disk --cases 100 --report "
        "json --threads " +
        threads + " | grep -v '\"command\"'");
  };
  const auto one = written("1");
  BOOST_TEST(one.code == 0, one);
  BOOST_TEST((one == written("4")));
}

BOOST_AUTO_TEST_CASE(a_report_goes_to_its_file) {
  const Folder folder;
  const auto ended = folder.run(
      "rayaudit ladder certified/float --family far --shape disk --cases 8 --report json=far.json");
  BOOST_TEST(ended == shell::printed(""));
  BOOST_TEST(contains(folder.text("far.json"), "\"report\": \"ladder\""));
}

BOOST_AUTO_TEST_CASE(a_family_without_difficulty_is_refused_with_those_that_have_one) {
  BOOST_TEST(run("rayaudit ladder --family tangent") ==
             refused(2,
                     "family `tangent` has no difficulty to rise; those that have: grazing, "
                     "tangent-near, rim-near, apex-near, parallel-near, within-near, surface-near, "
                     "far, placement, slender, flat, length, scale"));
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_refused_with_the_nearest_known_one) {
  BOOST_TEST(run("rayaudit ladder --family grasing") ==
             refused(2, "family `grasing` is not known; did you mean `grazing`?"));
  BOOST_TEST(run("rayaudit ladder textbok/float") ==
             refused(2, "subject `textbok/float` is not known; did you mean `textbook/float`?"));
  BOOST_TEST(run("rayaudit ladder --shape shpere") ==
             refused(2, "shape `shpere` is not known; did you mean `sphere`?"));
  BOOST_TEST(run("rayaudit ladder --report tabel") ==
             refused(2, "report `tabel` is not known; did you mean `table`?"));
}

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused) {
  BOOST_TEST(run("rayaudit ladder --cases 0") == refused(2, "--cases must be at least 1, got `0`"));
  BOOST_TEST(run("rayaudit ladder --threads 0") ==
             refused(2, "--threads must be at least 1, got `0`"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_written_or_read_is_refused_before_the_climb) {
  // So many cases would be judged for hours.
  const Folder folder;
  BOOST_TEST(folder.run("rayaudit ladder --cases 1e12 --report json=nowhere/far.json") ==
             refused(2, "report `nowhere/far.json` cannot be written: No such file or directory"));
  BOOST_TEST(folder.run("rayaudit ladder --cases 1e12 --bounds nowhere.txt") ==
             refused(2, "`nowhere.txt` cannot be read: No such file or directory"));
  folder.write("bounds.txt", "certified/float sphere far max_upl 1 observed\n");
  BOOST_TEST(folder.run("rayaudit ladder --cases 1e12 --bounds bounds.txt") ==
             refused(2, "bounds.txt:1: limit `max_upl` is not known; did you mean `max_ulp`?"));
}

BOOST_AUTO_TEST_CASE(what_leaves_nothing_to_climb_exits_with_4) {
  BOOST_TEST(run("rayaudit ladder 'nobody/*'") == refused(4, "no subject matches `nobody/*`"));
  BOOST_TEST(run("rayaudit ladder --family slender --shape sphere") ==
             refused(4,
                     "nothing to climb: no chosen subject answers a chosen shape that family "
                     "slender draws"));
}

BOOST_AUTO_TEST_CASE(a_bound_that_is_broken_is_a_finding_and_told_with_its_case) {
  const Folder folder;
  folder.write("bounds.txt",
               "certified/* sphere far wrong 0 observed\n"
               "textbook/float sphere far max_own 0.25 observed\n");
  const auto ended = folder.run(
      "rayaudit ladder textbook/float certified/float handout/float --family far --shape sphere "
      "--cases 64 --bounds bounds.txt");
  BOOST_TEST(ended.code == 1, ended);
  BOOST_TEST(ended.err.starts_with(
                 "rayaudit: bounds.txt:2: `textbook/float sphere far max_own 0.25 observed` is "
                 "broken by textbook/float on sphere, family far at k = 1: max_own is "),
             ended);
  BOOST_TEST(contains(ended.err, ", more than 0.25: rayaudit explain "), ended);
  // Who breaks the yardstick alone is no finding.
  BOOST_TEST(shell::line_count(ended.err) == 1, ended);
  BOOST_TEST(contains(ended.out, "\nsphere  "), ended);
  const std::string explain = ended.err.substr(ended.err.rfind("rayaudit explain "));
  BOOST_TEST(folder.run(explain).code <= 1);
}

BOOST_AUTO_TEST_CASE(a_bound_that_is_held_is_no_finding) {
  const Folder folder;
  folder.write("bounds.txt", "certified/* sphere far wrong 0 observed\n");
  const auto ended = folder.run(
      "rayaudit ladder 'certified/*' --family far --shape sphere --cases 64 --bounds bounds.txt");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
}

BOOST_AUTO_TEST_CASE(subjects_asked_for_by_name_only_climb_too) {
  const auto ended = run("rayaudit ladder '*/double_double' --family far --shape sphere --cases 8");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "\n  textbook/double_double "), ended);
}
