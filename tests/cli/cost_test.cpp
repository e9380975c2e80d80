#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;
using shell::run;

namespace {

const std::string small = " --cases 64 --rounds 3 ";

/// The program beside a plugin that is none.
const std::string beside_garbage =
    "mkdir bin; program=$(type rayaudit | grep -o \"'.*'\" | tr -d \"'\")\n"
    "ln \"$program\" bin 2>.ln || cp \"$program\" bin\n"
    "echo text > bin/rayaudit-fast_math.so\n";

}  // namespace

BOOST_AUTO_TEST_CASE(a_small_run_tells_the_front_and_exits_with_0) {
  const auto ended = run("rayaudit cost 'textbook/*' --shape sphere --all-ways" + small);
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
  for (const char* heading : {"\nsphere, 16 families ", "\nsphere, the 10 easy families ",
                              "\nsphere, the 6 hard families "})
    BOOST_TEST(contains(ended.out, heading), ended);
  for (const char* name :
       {" textbook/float ", " textbook/long_double ", " textbook/double_double "})
    BOOST_TEST(contains(ended.out, name), ended);
  BOOST_TEST(!contains(ended.out, "certified/"));
  BOOST_TEST(!contains(ended.out, "sphere, family "));
  BOOST_TEST(!contains(ended.out, "disk, "));
}

BOOST_AUTO_TEST_CASE(every_subject_takes_part_and_not_only_those_of_an_audit) {
  const auto ended = run("rayaudit cost --shape disk --family anywhere --all-ways" + small);
  BOOST_TEST(ended.code == 0, ended);
  for (const char* name : {"textbook/float ", "certified/double ", "textbook/double_double ",
                           "textbook+fast_math/float ", "textbook+native/float ", "gmpq/double "})
    BOOST_TEST(contains(ended.out, name), name);
}

BOOST_AUTO_TEST_CASE(all_ways_and_each_family_are_told_where_asked) {
  const auto ended = run("rayaudit cost '*/float' --shape sphere --family anywhere,grazing" +
                         small + "--all-ways --each-family");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "\nsphere, 2 families "));
  BOOST_TEST(contains(ended.out, "\nsphere, family anywhere "));
  BOOST_TEST(contains(ended.out, "\nsphere, family grazing "));
  BOOST_TEST(contains(ended.out, "\n* "));
  BOOST_TEST(!contains(ended.out, "others are better than"));
}

BOOST_AUTO_TEST_CASE(invalid_cases_are_measured_only_where_they_are_named) {
  const std::string each = " textbook/float --shape sphere --each-family" + small;
  BOOST_TEST(!contains(run("rayaudit cost" + each).out, "family invalid"));
  BOOST_TEST(contains(run("rayaudit cost --family invalid" + each).out, "family invalid"));
}

BOOST_AUTO_TEST_CASE(verdicts_are_the_same_for_any_number_of_threads) {
  const auto wrong = [](const std::string& threads) {
    return run(
        "rayaudit cost '*/float' --shape sphere,cone --family grazing,far --cases 1500 "
        "--rounds 3 --report json --threads " +
        threads + " | grep -E '\"(subject|wrong|max_ulp|wrong_margin)\"'");
  };
  const auto one = wrong("1");
  BOOST_TEST(shell::line_count(one.out) > 50);
  BOOST_TEST((one == wrong("4")));
}

BOOST_AUTO_TEST_CASE(a_report_goes_to_its_file_and_to_standard_output_what_has_none) {
  const Folder folder;
  const auto ended = folder.run(
      "rayaudit cost textbook/float --family anywhere --report table --report json=cost.json" +
      small);
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.out.starts_with("rayaudit "), ended);
  BOOST_TEST(contains(folder.text("cost.json"), "\"report\": \"cost\""));
  BOOST_TEST(contains(folder.text("cost.json"), "\"cases\": 64"));
  BOOST_TEST(contains(folder.text("cost.json"), "\"rounds\": 3"));
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_refused_with_the_nearest_known_one) {
  BOOST_TEST(run("rayaudit cost textbok/float") ==
             refused(2, "subject `textbok/float` is not known; did you mean `textbook/float`?"));
  BOOST_TEST(run("rayaudit cost textbook/float128x").code == 2);
  BOOST_TEST(run("rayaudit cost --family grasing") ==
             refused(2, "family `grasing` is not known; did you mean `grazing`?"));
  BOOST_TEST(run("rayaudit cost --shape shpere") ==
             refused(2, "shape `shpere` is not known; did you mean `sphere`?"));
  BOOST_TEST(run("rayaudit cost --report jsn") ==
             refused(2, "report `jsn` is not known; did you mean `json`?"));
  BOOST_TEST(run("rayaudit cost --al-ways").code == 2);
}

BOOST_AUTO_TEST_CASE(a_program_is_refused_for_it_has_no_time_by_the_case) {
  for (const std::string more : {"", " --format float", " textbook/float", " --patience 1"})
    BOOST_TEST(run("rayaudit cost --program \"sed 's/$/ miss/'\"" + more) ==
               refused(2,
                       "cost: --program: what a program takes is mostly to be started and to read "
                       "and write text, so it has no time by the case; bring the routine as a "
                       "plugin (--plugin)"));
  const std::string help = run("rayaudit cost --help").out;
  BOOST_TEST(contains(help, "--plugin"));
  BOOST_TEST(!contains(help, "--program"));
}

BOOST_AUTO_TEST_CASE(a_number_out_of_range_is_refused) {
  BOOST_TEST(run("rayaudit cost --cases 0") == refused(2, "--cases must be at least 1, got `0`"));
  BOOST_TEST(run("rayaudit cost --rounds 2") == refused(2, "--rounds must be at least 3, got `2`"));
  BOOST_TEST(run("rayaudit cost --rounds 1e5") ==
             refused(2, "--rounds must be at most 10000, got `1e5`"));
  BOOST_TEST(run("rayaudit cost --threads 0") ==
             refused(2, "--threads must be at least 1, got `0`"));
  BOOST_TEST(run("rayaudit cost --seed -1") == refused(2, "--seed must be at least 0, got `-1`"));
}

BOOST_AUTO_TEST_CASE(a_report_that_cannot_be_written_is_refused_before_anything_is_measured) {
  // So many cases would be judged for hours.
  const Folder folder;
  BOOST_TEST(folder.run("rayaudit cost --cases 1e12 --report json=nowhere/cost.json") ==
             refused(2, "report `nowhere/cost.json` cannot be written: No such file or directory"));
  BOOST_TEST(folder.run("rayaudit cost --cases 1e12 --report json=fine.json --report table=/tmp") ==
             refused(2, "report `/tmp` cannot be written: Is a directory"));
  BOOST_TEST(folder.run("rayaudit cost --cases 1e12 --report json --report table") ==
             refused(2, "two reports to standard output: name a file, as in --report json=FILE"));
  BOOST_TEST(folder.files() == 0);
}

BOOST_AUTO_TEST_CASE(a_subject_that_is_not_here_is_refused_with_the_reason) {
  const std::string reason =
      "is not here: rayaudit-native.so, compiled with -O3 -march=native -ffp-contract=fast, is not "
      "beside the program";
  for (const std::string command : {"cost", "ladder", "audit"})
    for (const std::string asked : {"textbook+native/float", "*+native/*"})
      BOOST_TEST(run(beside_garbage + "bin/rayaudit " + command + " '" + asked + "'") ==
                 refused(2, "subject `" + asked + "` " + reason));
}

BOOST_AUTO_TEST_CASE(what_leaves_nothing_to_measure_exits_with_4) {
  BOOST_TEST(run("rayaudit cost 'nobody/*'") == refused(4, "no subject matches `nobody/*`"));
  BOOST_TEST(run("rayaudit cost --family 'none*'") == refused(4, "no family matches `none*`"));
  BOOST_TEST(run("rayaudit cost --shape disk --family tangent") ==
             refused(4,
                     "nothing to measure: no chosen subject answers a chosen shape that a chosen "
                     "family draws"));
}

BOOST_AUTO_TEST_CASE(a_plugin_that_is_broken_is_a_finding_and_the_others_are_measured) {
  const auto ended = run(beside_garbage +
                         "bin/rayaudit cost textbook/float textbook+fast_math/float --threads 2 "
                         "--shape sphere,disk --family "
                         "anywhere,grazing --all-ways --each-family" +
                         small);
  BOOST_TEST(ended.code == 1, ended);
  BOOST_TEST(ended.err.starts_with("rayaudit: textbook+fast_math/float does not answer: its "),
             ended);
  BOOST_TEST(shell::line_count(ended.err) == 1, ended);
  for (const char* heading : {"\nsphere, 2 families ", "\nsphere, family grazing ",
                              "\ndisk, 2 families ", "\ndisk, family grazing "})
    BOOST_TEST(contains(ended.out, heading), ended);
  BOOST_TEST(contains(ended.out, "\n* textbook/float "), ended);
  BOOST_TEST(!contains(ended.out, "  textbook+fast_math/float "), ended);
  BOOST_TEST(contains(ended.out, "\nNot measured: textbook+fast_math/float does not "), ended);
  BOOST_TEST(contains(ended.out, "\nNot measured: *+native/*: rayaudit-native.so, "), ended);
}

BOOST_AUTO_TEST_CASE(a_plugin_that_is_broken_alone_is_a_finding_and_no_mistake) {
  const auto ended = run(beside_garbage + "bin/rayaudit cost '*+fast_math/float' --shape sphere" +
                         small + "--report json");
  BOOST_TEST(ended.code == 1, ended);
  BOOST_TEST(shell::line_count(ended.err) > 3, ended);
  BOOST_TEST(contains(ended.out, "\"cells\": []"), ended);
}

BOOST_AUTO_TEST_CASE(
    an_audit_takes_subjects_that_are_asked_for_by_name_only_where_a_glob_means_them) {
  const std::string rest =
      " --shape sphere --family anywhere --cases 10 --report csv | cut -d, -f1";
  const std::string some = run("rayaudit audit 'textbook/*'" + rest).out;
  BOOST_TEST(contains(some, "textbook/long_double"));
  BOOST_TEST(!contains(some, "textbook/double_double"));
  BOOST_TEST(!contains(some, "textbook/float128"));
  BOOST_TEST(!contains(run("rayaudit audit" + rest).out, "textbook/double_double"));
  const std::string asked = run("rayaudit audit '*/double_double'" + rest).out;
  BOOST_TEST(contains(asked, "textbook/double_double"));
  BOOST_TEST(!contains(asked, "textbook/double\n"));
  BOOST_TEST(
      contains(run("rayaudit audit textbook/double_double" + rest).out, "textbook/double_d"));
#ifndef __clang__  // which has no quad precision
  BOOST_TEST(contains(run("rayaudit audit '*/float128'" + rest).out, "textbook/float128"));
#endif
}
