#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::printed;
using shell::run;

BOOST_AUTO_TEST_CASE(truth_appends_crossings_and_the_first_hit_in_front_of_the_comment) {
  const Folder folder;
  folder.write("cases.txt",
               "# the unit sphere\n"
               "\n"
               "sphere 0 0 0 1 ray 0 0 -3 0 0 1 # through the middle\n"
               "sphere 0 0 0 1 ray 0 1 -3 0 0 1\n"
               "sphere 0 0 0 1 ray 0 3 -3 0 0 1#beside\n"
               "sphere 0 0 0 1 ray 0 0 -1 0 0 1\n"
               "disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0\n"
               "cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0\n"
               "sphere 0 0 0 -1 ray 0 0 -3 0 0 1 # inside out\n"
               "sphere 0 0 0 1 ray 0 0.5 -3 0 0 1");
  BOOST_TEST(folder.run("rayaudit truth cases.txt") ==
             printed("# the unit sphere\n"
                     "\n"
                     "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 0x1p+1 # through the middle\n"
                     "sphere 0 0 0 1 ray 0 1 -3 0 0 1 touch tangent 0x1.8p+1 miss\n"
                     "sphere 0 0 0 1 ray 0 3 -3 0 0 1 miss #beside\n"
                     "sphere 0 0 0 1 ray 0 0 -1 0 0 1 touch start 0x0p+0 hit 0x1p+1\n"
                     "disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0 touch within 0x1p+1 0x1p+2 miss\n"
                     "cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0 touch apex 0x1.8p+1 miss\n"
                     "sphere 0 0 0 -1 ray 0 0 -3 0 0 1 invalid radius # inside out\n"
                     "sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 hit 0x1.1126145e9ecd5p+1\n"));
  BOOST_TEST(folder.run("rayaudit truth <cases.txt") == folder.run("rayaudit truth cases.txt"));
}

BOOST_AUTO_TEST_CASE(truth_rounds_to_the_format_asked_for) {
  // (6 - sqrt(3)) / 2 = 2.13397459621556135...
  const std::string line = "sphere 0 0 0 1 ray 0 0.5 -3 0 0 1";
  const auto rounded = [&](const std::string& format) {
    return run("echo " + line + " | rayaudit truth --format " + format).out;
  };
  BOOST_TEST(rounded("float") == line + " hit 0x1.112614p+1\n");
  BOOST_TEST(rounded("double") == line + " hit 0x1.1126145e9ecd5p+1\n");
  BOOST_TEST(rounded("long_double") == line + " hit 0x1.1126145e9ecd5632p+1\n");
}

BOOST_AUTO_TEST_CASE(truth_takes_the_place_of_an_answer) {
  BOOST_TEST(run("echo 'sphere 0 0 0 1 ray 0 0 -3 0 0 1 miss # so it said' | rayaudit truth") ==
             printed("sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 0x1p+1 # so it said\n"));
  BOOST_TEST(run("echo 'sphere 0 0 0 1\tray 0 0 -3 0 0 1\tat 0 0 1' | rayaudit truth") ==
             printed("sphere 0 0 0 1\tray 0 0 -3 0 0 1 hit 0x1p+1\n"));
}

/// Cases with each kind of touch and an invalid one.
const std::string touched =
    "printf '%s\\n' 'sphere 0 0 0 1 ray 0 1 -3 0 0 1' 'disk 0 0 0 0 0 1 1 ray 1 0 -2 0 0 1' "
    "'cone 0 0 0 0 1 0 1 ray -3 1 0 1 0 0' 'sphere 0 0 0 1 ray 0 0 -1 0 0 1' "
    "'sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 2' 'disk 0 0 0 0 1 0 1 ray -3 0 0 1 0 0 # why' "
    "'sphere 0 0 0 -1 ray 0 0 -3 0 0 1' >cases\n";

BOOST_AUTO_TEST_CASE(truth_takes_the_place_of_a_truth) {
  const auto ended = run(touched + "rayaudit truth cases >once; rayaudit truth once | cmp - once");
  BOOST_TEST(ended == printed(""));
  for (const std::string kind : {"tangent", "rim", "apex", "start", "end", "within"})
    BOOST_TEST(contains(run(touched + "rayaudit truth cases").out, " touch " + kind + " 0x"));
}

BOOST_AUTO_TEST_CASE(what_truth_says_of_touches_and_invalid_cases_can_be_judged) {
  const auto verdicts =
      run(touched + "rayaudit truth cases | rayaudit judge --each | sed 's/.*# //'");
  BOOST_TEST(verdicts == printed("touch\ntouch\ntouch\nright 0 ulps\ntouch\ntouch\n"
                                 "invalid_handled\n"));
}

BOOST_AUTO_TEST_CASE(truth_answers_each_line_before_it_waits_for_the_next) {
  const auto ended =
      run("coproc rayaudit truth\n"
          "for y in 0 1 2; do\n"
          "  echo \"sphere 0 0 0 1 ray 0 $y -3 0 0 1\" >&${COPROC[1]}\n"
          "  read -r -t 20 line <&${COPROC[0]} && echo \"$line\"\n"
          "done");
  BOOST_TEST(ended.out ==
             "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 0x1p+1\n"
             "sphere 0 0 0 1 ray 0 1 -3 0 0 1 touch tangent 0x1.8p+1 miss\n"
             "sphere 0 0 0 1 ray 0 2 -3 0 0 1 miss\n");
}

BOOST_AUTO_TEST_CASE(many_lines_keep_their_order) {
  const auto ended =
      run("rayaudit draw --shape cone --family anywhere --count 50_000 | "
          "awk '{ print; if (NR % 1000 == 0) print \"# \" NR }' >cases.txt\n"
          "rayaudit truth cases.txt | sed -E 's/ (hit [^ ]+|miss)$//' | cmp - cases.txt");
  BOOST_TEST(ended == printed(""));
}

BOOST_AUTO_TEST_CASE(draw_writes_the_cases_of_a_seed) {
  const std::string draw = "rayaudit draw --shape sphere --family grazing --count 2500";
  const auto drawn = run(draw);
  BOOST_TEST(drawn.code == 0);
  BOOST_TEST(shell::line_count(drawn.out) == 2500);
  BOOST_TEST(run(draw + " --seed 1") == drawn);
  BOOST_TEST(run(draw + " --seed 2").out != drawn.out);
  BOOST_TEST(run(draw + " --difficulty 7").out != drawn.out);
  BOOST_TEST(
      drawn.out.starts_with(run("rayaudit draw --shape sphere --family grazing --count 1500").out));
}

BOOST_AUTO_TEST_CASE(draw_in_float_writes_floats_only) {
  const auto ended =
      run("rayaudit draw --shape cylinder --family anywhere --count 1k --format float | "
          "sed 's/$/ miss/' | rayaudit judge --format float");
  BOOST_TEST(contains(ended.out, "stdin: 1,000 cases judged in float\n"));
  BOOST_TEST(!contains(ended.out, "are no floats"));
}

BOOST_AUTO_TEST_CASE(what_draw_and_truth_say_is_judged_right) {
  const auto ended =
      run("rayaudit draw --shape sphere --family anywhere --count 1e4 | rayaudit truth | rayaudit "
          "judge");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "stdin: 10,000 cases judged in double\n"));
  BOOST_TEST(contains(ended.out, "  right                       10,000     100 %\n"));
  BOOST_TEST(contains(ended.out, "  0 of 10,000 wrong: < 0.03 % at 95 %\n"));
}

const std::string answers =
    "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 2\n"
    "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 4 # the far side\n"
    "# a comment\n"
    "sphere 0 0 0 1 ray 0 0 -3 0 0 1 miss\n"
    "sphere 0 0 0 1 ray 0 1 -3 0 0 1 yes\n"
    "sphere 0 0 0 1 ray 0 2 -3 0 0 1 at 0 0 1\n"
    "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 2.5\n"
    "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit nan\n";

BOOST_AUTO_TEST_CASE(judge_appends_each_verdict_where_asked) {
  const Folder folder;
  folder.write("answers.txt", answers);
  BOOST_TEST(folder.run("rayaudit judge --each answers.txt") ==
             printed("sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 2 # right 0 ulps\n"
                     "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 4 # the far side # wrong_root later\n"
                     "# a comment\n"
                     "sphere 0 0 0 1 ray 0 0 -3 0 0 1 miss # false_miss\n"
                     "sphere 0 0 0 1 ray 0 1 -3 0 0 1 yes # touch\n"
                     "sphere 0 0 0 1 ray 0 2 -3 0 0 1 at 0 0 1 # false_hit no_root\n"
                     "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 2.5 # wrong_t 1.1e15 ulps\n"
                     "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit nan # not_finite nan\n"));
}

BOOST_AUTO_TEST_CASE(judge_sums_up_and_shows_the_worst_of_each) {
  const Folder folder;
  folder.write("answers.txt", answers);
  const auto ended = folder.run("rayaudit judge answers.txt");
  BOOST_TEST(ended.code == 0);
  BOOST_TEST(
      ended.out.starts_with("answers.txt: 7 cases judged in double\n"
                            "  right                            1    14.3 %\n"
                            "  touch                            1    14.3 %\n"
                            "  false_hit                        1    14.3 %\n"));
  BOOST_TEST(contains(ended.out, "  touch tangent      taken in 1 of 1\n"));
  BOOST_TEST(contains(ended.out,
                      "\nwrong_root (later), line 2, margin 1.5e15 u:\n"
                      "  rayaudit explain 'sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 "
                      "-0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 hit 0x1p+2'\n"));
}

BOOST_AUTO_TEST_CASE(judge_holds_touches_to_a_declared_convention) {
  const std::string touch = "echo sphere 0 0 0 1 ray 0 1 -3 0 0 1 hit 3 | rayaudit judge --each ";
  BOOST_TEST(contains(run(touch).out, "# touch"));
  BOOST_TEST(contains(run(touch + "--convention tangent=hit,rim=miss").out, "# right"));
  BOOST_TEST(contains(run(touch + "--convention tangent=miss").out, "# false_hit"));
}

BOOST_AUTO_TEST_CASE(judge_says_where_cases_are_none_of_the_format) {
  const auto ended =
      run("echo sphere 0 0 0 0.1 ray 0 0 -3 0 0 1 miss | rayaudit judge --format float");
  BOOST_TEST(contains(ended.out, "  1 of them have numbers that are no floats"));
}

BOOST_AUTO_TEST_CASE(judge_fails_on_what_it_was_told_to) {
  const Folder folder;
  folder.write("answers.txt", answers);
  const auto judge = [&](const std::string& fail_on) {
    return folder.run("rayaudit judge answers.txt --fail-on " + fail_on);
  };
  BOOST_TEST(judge("invalid_mishandled").code == 0);
  BOOST_TEST(judge("false_miss,wrong_t").code == 1);
  BOOST_TEST(
      judge("false_miss,wrong_t").err ==
      "rayaudit: --fail-on: answers.txt:4: 1 of 7 cases false_miss: rayaudit explain 'sphere "
      "0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 -0x1.8p+1 0x0p+0 0x0p+0 0x1p+0 miss'\n");
  BOOST_TEST(judge("max_ulp=1e16").code == 0);
  BOOST_TEST(judge("max_ulp=4").code == 1);
  BOOST_TEST(
      contains(judge("max_ulp=4").err, "answers.txt:7: a t is off by 1.1e15 ulps, more than 4"));
}
