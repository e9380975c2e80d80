#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::Folder;
using shell::refused;
using shell::run;

BOOST_AUTO_TEST_CASE(an_unknown_name_is_refused_with_the_nearest_known_one) {
  BOOST_TEST(run("rayaudit adit") ==
             refused(2, "command `adit` is not known; did you mean `audit`?"));
  BOOST_TEST(run("rayaudit audit --shap disk") ==
             refused(2, "option `--shap` is not known; did you mean `--shape`?"));
  BOOST_TEST(run("rayaudit audit textbok/float") ==
             refused(2, "subject `textbok/float` is not known; did you mean `textbook/float`?"));
  BOOST_TEST(run("rayaudit audit --shape shpere") ==
             refused(2, "shape `shpere` is not known; did you mean `sphere`?"));
  BOOST_TEST(run("rayaudit audit --family grasing") ==
             refused(2, "family `grasing` is not known; did you mean `grazing`?"));
  BOOST_TEST(run("rayaudit audit --report jsn") ==
             refused(2, "report `jsn` is not known; did you mean `json`?"));
  BOOST_TEST(run("rayaudit audit --fail-on fals_hit") ==
             refused(2, "--fail-on: verdict `fals_hit` is not known; did you mean `false_hit`?"));
  BOOST_TEST(run("rayaudit audit --convention tangnt=hit") ==
             refused(2, "kind of touch `tangnt` is not known; did you mean `tangent`?"));
  BOOST_TEST(run("rayaudit audit --convention tangent=hitt") ==
             refused(2, "stance `hitt` is not known; did you mean `hit`?"));
  BOOST_TEST(run("rayaudit judge --format dobule") ==
             refused(2, "format `dobule` is not known; did you mean `double`?"));
  BOOST_TEST(run("rayaudit list shape") ==
             refused(2, "list of `shape` is not known; did you mean `shapes`?"));
  BOOST_TEST(run("rayaudit explain --formt float miss") ==
             refused(2, "option `--formt` is not known; did you mean `--format`?"));
}

BOOST_AUTO_TEST_CASE(a_number_that_is_none_or_out_of_range_is_refused) {
  BOOST_TEST(run("rayaudit audit --cases 0") == refused(2, "--cases must be at least 1, got `0`"));
  BOOST_TEST(run("rayaudit audit --cases -5") ==
             refused(2, "--cases must be at least 1, got `-5`"));
  BOOST_TEST(run("rayaudit audit --cases many") ==
             refused(2, "--cases must be a whole number, got `many`"));
  BOOST_TEST(run("rayaudit audit --cases 1.5") ==
             refused(2, "--cases must be a whole number, got `1.5`"));
  BOOST_TEST(run("rayaudit audit --cases 1e") ==
             refused(2, "--cases must be a whole number, got `1e`"));
  BOOST_TEST(run("rayaudit audit --cases 99999999999999999999") ==
             refused(2, "--cases must be at most 1000000000000000, got `99999999999999999999`"));
  BOOST_TEST(run("rayaudit audit --cases 1e300") ==
             refused(2, "--cases must be at most 1000000000000000, got `1e300`"));
  BOOST_TEST(run("rayaudit audit --seed -1") == refused(2, "--seed must be at least 0, got `-1`"));
  BOOST_TEST(run("rayaudit audit --threads 0") ==
             refused(2, "--threads must be at least 1, got `0`"));
  BOOST_TEST(run("rayaudit audit --fail-on max_ulp=few") ==
             refused(2, "--fail-on: max_ulp must be a number of ulps, got `few`"));
  BOOST_TEST(run("rayaudit audit --difficulty 99 --family grazing") ==
             refused(2, "--difficulty 99 is not one of family `grazing` in float: 1 to 22"));
  BOOST_TEST(run("rayaudit audit --difficulty 3 --family tangent") ==
             refused(2, "--difficulty: no family chosen has a difficulty"));
}

BOOST_AUTO_TEST_CASE(an_incomplete_command_line_is_refused) {
  BOOST_TEST(run("rayaudit") ==
             refused(2,
                     "expected a command, one of audit, check, cost, ladder, scene, "
                     "explain, draw, truth, judge, diff, merge, list; "
                     "`rayaudit --help` tells more"));
  BOOST_TEST(run("rayaudit explain") ==
             refused(2, "explain: expected a case line or FILE:LINE; lines count from 1"));
  BOOST_TEST(run("rayaudit audit --cases").code == 2);
  BOOST_TEST(run("rayaudit draw --shape disk --count 3").err ==
             "rayaudit: draw: --family is required\n");
  BOOST_TEST(run("rayaudit audit --convention tangent") ==
             refused(2, "--convention: expected KIND=hit or KIND=miss, got `tangent`"));
  for (const std::string nothing : {"''", ",", ",,"}) {
    BOOST_TEST(run("rayaudit audit --fail-on " + nothing) ==
               refused(2, "--fail-on: expected a verdict, as in --fail-on false_hit"));
    BOOST_TEST(run("rayaudit audit --convention " + nothing) ==
               refused(2, "--convention: expected KIND=hit or KIND=miss, got `" +
                              (nothing == "''" ? "" : nothing) + "`"));
  }
}

BOOST_AUTO_TEST_CASE(a_convention_is_refused_where_it_has_no_such_word_or_contradicts_itself) {
  const auto refuses = [](const std::string& convention, const std::string& sentence) {
    const auto ended = run("rayaudit audit textbook/float --convention " + convention);
    BOOST_TEST(ended.code == 2, ended);
    BOOST_TEST(ended.err.starts_with("rayaudit: " + sentence), ended);
  };
  refuses("ray=segmnt", "kind of ray `segmnt` is not known; did you mean `segment`?");
  refuses("extent=endless", "extent `endless` is not known");
  refuses("stand=upright", "stand `upright` is not known; did you mean `upright_");
  refuses("opening=tangent", "opening `tangent` is not known");
  refuses("ray=segment,direction=unit", "--convention has a segment, whose direction is as long");
  refuses("opening=angle", "--convention leaves, with what a subject declares itself, an opening");
}

BOOST_AUTO_TEST_CASE(a_convention_without_any_t_is_refused) {
  const std::pair<std::string, std::string> ranges[] = {{"t_min=3,t_max=2", "3 to 2"},
                                                        {"t_max=2,rim=hit,t_min=2", "2 to 2"},
                                                        {"t_min=inf", "inf to inf"}};
  for (const auto& [range, told] : ranges)
    for (const std::string command : {"audit", "judge", "check found.txt", "explain found.txt:1"})
      BOOST_TEST(run("rayaudit " + command + " --convention " + range) ==
                 refused(2, "--convention has the empty range from " + told + " for t"));
}

BOOST_AUTO_TEST_CASE(a_family_that_does_not_draw_the_shape_draws_nothing) {
  BOOST_TEST(run("rayaudit draw --shape disk --family tangent --count 3") ==
             refused(2,
                     "family `tangent` does not draw the shape `disk`; it draws `sphere`, "
                     "`cylinder`, `cone`, `capped_cylinder`, `capped_cone`"));
  BOOST_TEST(run("rayaudit draw --shape cone --family tangent --count 3 --difficulty 2") ==
             refused(2, "family `tangent` has no difficulty"));
}

BOOST_AUTO_TEST_CASE(known_names_that_leave_no_audit_exit_with_4) {
  BOOST_TEST(run("rayaudit audit --shape disk --family tangent") ==
             refused(4,
                     "nothing to audit: no chosen subject answers a chosen shape that a chosen "
                     "family draws"));
  BOOST_TEST(run("rayaudit audit 'textbook/*' 'nobody/*'") ==
             refused(4, "no subject matches `nobody/*`"));
  BOOST_TEST(run("echo '# no case' | rayaudit judge") == refused(4, "stdin has no case to judge"));
}

BOOST_AUTO_TEST_CASE(a_malformed_line_is_refused_with_its_place_after_all_lines_before_it) {
  const Folder folder;
  folder.write("bad.txt",
               "sphere 0 0 0 1 ray 0 0 -3 0 0 1 miss\n"
               "# why not\n"
               "sphere 0 0 0 1 rya 0 0 -3 0 0 1 miss\n");
  const auto ended = folder.run("rayaudit truth bad.txt");
  BOOST_TEST(ended.code == 2);
  BOOST_TEST(ended.out == "sphere 0 0 0 1 ray 0 0 -3 0 0 1 hit 0x1p+1\n# why not\n");
  BOOST_TEST(ended.err ==
             "rayaudit: bad.txt:3: expected `ray` after the sphere's 4 numbers, got `rya`\n");
  BOOST_TEST(folder.run("rayaudit judge <bad.txt").code == 2);
  BOOST_TEST(folder.run("rayaudit judge <bad.txt").out.empty());
  BOOST_TEST(folder.run("rayaudit explain bad.txt:3").code == 2);
}

BOOST_AUTO_TEST_CASE(a_malformed_line_far_down_has_its_own_number) {
  const auto ended =
      run("{ rayaudit draw --shape cone --family anywhere --count 20k; echo sphere; echo disk; } "
          ">cases\n"
          "rayaudit truth cases | wc -l");
  BOOST_TEST(ended.out == "20000\n");
  BOOST_TEST(ended.err ==
             "rayaudit: cases:20001: sphere: expected centre x, got the end of the line\n");
}

BOOST_AUTO_TEST_CASE(a_number_that_overflows_is_refused) {
  const auto ended = run("echo sphere 0 0 0 1e999 ray 0 0 -3 0 0 1 | rayaudit truth");
  BOOST_TEST(ended == refused(2, "stdin:1: sphere: radius `1e999` overflows a double"));
}

BOOST_AUTO_TEST_CASE(a_line_without_an_answer_cannot_be_judged) {
  BOOST_TEST(
      run("echo sphere 0 0 0 1 ray 0 0 -3 0 0 1 | rayaudit judge") ==
      refused(2, "stdin:1: expected an answer after the case: `hit`, `at`, `yes` or `miss`"));
}

BOOST_AUTO_TEST_CASE(a_file_that_cannot_be_read_is_refused) {
  BOOST_TEST(run("rayaudit truth nowhere.txt") ==
             refused(2, "`nowhere.txt` cannot be read: No such file or directory"));
  BOOST_TEST(run("rayaudit judge /tmp") == refused(2, "`/tmp` cannot be read: Is a directory"));
  BOOST_TEST(run("rayaudit explain nowhere.txt:3") ==
             refused(2, "`nowhere.txt` cannot be read: No such file or directory"));
  BOOST_TEST(run("rayaudit explain /tmp:3") == refused(2, "`/tmp` cannot be read: Is a directory"));
  const Folder folder;
  folder.write("two.txt", "\nsphere 0 0 0 1 ray 0 0 -3 0 0 1\n");
  BOOST_TEST(folder.run("rayaudit explain two.txt:3") ==
             refused(2, "`two.txt` has no line 3, only 2"));
  BOOST_TEST(folder.run("rayaudit explain two.txt:1") == refused(2, "two.txt:1: no case here"));
  for (const std::string word : {"two.txt", "two.txt:0", "two.txt:", "two.txt:2x", "/tmp"})
    BOOST_TEST(folder.run("rayaudit explain " + word) ==
               refused(2, "explain: expected a case line or FILE:LINE, got `" + word +
                              "`; lines count from 1"));
}

BOOST_AUTO_TEST_CASE(a_report_that_cannot_be_written_is_refused_before_the_run) {
  // So many cases would run for hours.
  BOOST_TEST(
      run("rayaudit audit --cases 1e12 --report json=nowhere/report.json") ==
      refused(2, "report `nowhere/report.json` cannot be written: No such file or directory"));
  BOOST_TEST(run("rayaudit audit --cases 1e12 --report json=/tmp") ==
             refused(2, "report `/tmp` cannot be written: Is a directory"));
  BOOST_TEST(run("rayaudit audit --cases 1e12 --report json --report csv") ==
             refused(2, "two reports to standard output: name a file, as in --report json=FILE"));
  BOOST_TEST(run("rayaudit audit --cases 1e12 --report json=a --report csv=./a") ==
             refused(2, "two reports to the file `./a`"));
  BOOST_TEST(run("rayaudit audit --cases 1e12 --report json=") ==
             refused(2, "--report json=: expected a file after the `=`"));
  const std::string long_name(5000, 'a');
  BOOST_TEST(run("rayaudit audit --cases 1e12 --report json=/tmp/" + long_name) ==
             refused(2, "report `/tmp/" + long_name + "` cannot be written: File name too long"));
  BOOST_TEST(run("mkdir gone && cd gone && rmdir ../gone\n"
                 "rayaudit audit --cases 1e12 --report json=a.json") ==
             refused(2, "report `a.json` cannot be written: No such file or directory"));
  const Folder folder;
  folder.run("rayaudit audit --cases 1e12 --report json=fine.json --report csv=nowhere/report.csv");
  BOOST_TEST(folder.files() == 0);
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_told) {
  BOOST_TEST(run("rayaudit list >/dev/full") ==
             refused(2, "standard output cannot be written: No space left on device"));
}

BOOST_AUTO_TEST_CASE(a_report_beyond_the_largest_file_allowed_leaves_nothing) {
  const Folder folder;
  BOOST_TEST(folder.run("ulimit -f 1\n"
                        "rayaudit audit 'textbook/*' --cases 10 --report json=a.json") ==
             refused(2, "report `a.json` cannot be written: File too large"));
  BOOST_TEST(folder.files() == 0);
}

#ifndef RAYAUDIT_SANITIZED  // which takes more memory than any limit
BOOST_AUTO_TEST_CASE(a_line_that_memory_cannot_hold_is_told) {
  BOOST_TEST(run("(ulimit -v 400000; rayaudit truth) < <(head -c 600M /dev/zero)") ==
             refused(2, "there is not enough memory"));
}
#endif

BOOST_AUTO_TEST_CASE(what_cannot_be_printed_is_shown_as_a_number_and_long_words_are_cut) {
  BOOST_TEST(run("printf 'sphere 0 0 \\033[2J\\000 1' | rayaudit truth") ==
             refused(2, "stdin:1: sphere: expected centre z, got `\\x1b[2J\\x00`"));
  BOOST_TEST(run("rayaudit audit --cases " + std::string(100, 'x')) ==
             refused(2, "--cases must be a whole number, got `" + std::string(60, 'x') + "...`"));
}

BOOST_AUTO_TEST_CASE(a_reader_that_closes_its_pipe_early_ends_it_silently) {
  for (const std::string filter : {"", "| rayaudit truth"}) {
    const auto ended = run("rayaudit draw --shape sphere --family anywhere --count 1e12 " + filter +
                           " | head -n 1; echo ${PIPESTATUS[0]} >&2");
    BOOST_TEST(shell::line_count(ended.out) == 1);
    BOOST_TEST(ended.err == "141\n");
  }
  // Even where the caller has the signal ignored.
  const auto ended =
      run("trap '' PIPE; rayaudit draw --shape sphere --family anywhere --count 1e12 | head -n 1");
  BOOST_TEST(ended.code == 141);
  BOOST_TEST(ended.err == "");
}
