#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::refused;
using shell::run;

namespace {

const std::string spheres = " --shape sphere --family anywhere,rim --cases 2000 ";

}  // namespace

BOOST_AUTO_TEST_CASE(a_program_that_knows_the_truth_has_no_finding_in_any_shape_or_family) {
  const auto ended =
      run("me=$(type rayaudit | grep -o \"'.*'\" | tr -d \"'\")\n"
          "rayaudit audit --program \"$me truth\" --format float --cases 500 --fail-on "
          "false_hit,false_miss,wrong_root,wrong_t,not_finite,crashed,timed_out,invalid_mishandled,"
          "max_ulp=0.5");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(contains(ended.out, "rayaudit/float"), ended);
  for (const std::string shape :
       {"disk", "sphere", "cylinder", "cone", "capped_cylinder", "capped_cone"})
    BOOST_TEST(contains(ended.out, shape), ended);
}

BOOST_AUTO_TEST_CASE(a_program_is_audited_alone_or_beside_named_subjects) {
  const std::string audit = "rayaudit audit --program \"sed 's/$/ miss/'\"" + spheres;
  const auto alone = run(audit);
  BOOST_TEST(alone.code == 0, alone);
  BOOST_TEST(contains(alone.out, "sed/double"), alone);
  BOOST_TEST(!contains(alone.out, "textbook"));
  const auto beside = run(audit + "textbook/double");
  BOOST_TEST(contains(beside.out, "sed/double"), beside);
  BOOST_TEST(contains(beside.out, "textbook/double"), beside);
  BOOST_TEST(run(audit + "--fail-on false_miss").code == 1);
}

BOOST_AUTO_TEST_CASE(the_format_says_what_the_cases_are_drawn_in) {
  // Six digits after the point hold every float.
  const std::string audit =
      "rayaudit audit --program \"sed -E '/\\.[0-9a-f]{7}/!s/$/ miss/'\"" + spheres;
  const auto in_double = run(audit);
  BOOST_TEST(in_double.code == 1, in_double);
  BOOST_TEST(contains(in_double.err, ": there is no answer after the case\n"), in_double);
  const auto in_float = run(audit + "--format float");
  BOOST_TEST(in_float.code == 0, in_float);
  BOOST_TEST(contains(in_float.out, "sed/float"), in_float);
  BOOST_TEST(run("rayaudit audit --program cat --format dobule") ==
             refused(2, "format `dobule` is not known; did you mean `double`?"));
}

BOOST_AUTO_TEST_CASE(crashes_and_hangs_are_findings_and_the_audit_goes_on) {
  // It dies of a negative zero, which axis has and anywhere has not.
  const Folder folder;
  folder.write("mine",
               "while read -r l; do case \"$l\" in *' -0x0p+0 '*) kill -SEGV $$;; esac; "
               "echo \"$l miss\"; done\n");
  const auto ended = folder.run(
      "rayaudit audit --program 'sh mine' --shape sphere --family axis,anywhere --cases 2000 "
      "--fail-on crashed");
  BOOST_TEST(ended.code == 1, ended);
  BOOST_TEST(contains(ended.out, "crashed"), ended);
  BOOST_TEST(contains(ended.out, "anywhere"), ended);
  BOOST_TEST(contains(ended.err, "rayaudit: --fail-on: sh/double on sphere, family axis: 4 of "),
             ended);
}

BOOST_AUTO_TEST_CASE(a_program_that_cannot_answer_is_told_before_all_else_and_leaves_no_report) {
  const Folder folder;
  const auto told = [&](const std::string& command, const std::string& more = "") {
    // So many cases would run for hours.
    const auto ended = folder.run(
        "rayaudit audit --cases 1e12 textbook/float --report json=a.json "
        "--write-bounds b.txt --program '" +
        command + "' " + more);
    BOOST_TEST(ended.out == "");
    BOOST_TEST(folder.files() == 0);
    return ended;
  };
  const auto nowhere = told("./nowhere --flag");
  BOOST_TEST(nowhere.code == 2);
  BOOST_TEST(contains(nowhere.err, "./nowhere: not found"), nowhere);
  BOOST_TEST(contains(nowhere.err,
                      "rayaudit: program `./nowhere --flag` cannot be started: there is no such "
                      "command (exit code 127 of the shell)\n"),
             nowhere);
  const auto echo = told("cat");
  BOOST_TEST(echo.code == 1);
  BOOST_TEST(
      echo.err.starts_with("rayaudit: cat/double does not answer: its program `cat` printed, "
                           "as line 1, `disk "),
      echo);
  BOOST_TEST(shell::line_count(echo.err) == 1);
  const auto sleeps = told("sleep 1000", "--patience 1");
  BOOST_TEST(sleeps.code == 1);
  BOOST_TEST(contains(sleeps.err, "said nothing for 1 s after 0 of 1 answers when asked `disk "),
             sleeps);
}

BOOST_AUTO_TEST_CASE(a_program_that_goes_wrong_midway_leaves_no_report) {
  const Folder folder;
  const auto ended = folder.run("rayaudit audit --program \"sed '500d; s/$/ miss/'\"" + spheres +
                                "--report json=a.json --write-bounds b.txt");
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(ended.out == "");
  BOOST_TEST(folder.files() == 0);
  BOOST_TEST(contains(ended.err, "as line 500, `sphere "), ended);
  BOOST_TEST(contains(ended.err, "that is case 501 of 2000 where it is the turn of case 500\n"));
}

BOOST_AUTO_TEST_CASE(what_goes_with_a_program_is_refused_without_one) {
  BOOST_TEST(run("rayaudit audit --program '  '") == refused(2, "--program: expected a command"));
  BOOST_TEST(run("rayaudit audit --format float").code == 2);
  BOOST_TEST(run("rayaudit audit --patience 5") ==
             refused(2, "--patience goes with --plugin or --program"));
}

BOOST_AUTO_TEST_CASE(a_program_ends_when_rayaudit_is_killed) {
  const Folder folder;
  const auto ended = folder.run(
      "\"$RAYAUDIT\" audit --shape sphere --patience 1000 --program "
      "'trap \"\" HUP INT PIPE TERM; echo $$ >group; sleep 1000' &\n"
      "lives() { { cat /proc/[0-9]*/stat 2>.gone || true; } | sed 's/.*) //' | "
      "grep \"^[^ZX] [0-9]* $(cat group) \" >.found; }\n"
      "until [ -s group ]; do sleep 0.05; done\n"
      "lives && echo lives; kill -KILL $!\n"
      "for i in $(seq 200); do lives || { echo gone; exit 0; }; sleep 0.05; done; echo lives on");
  BOOST_TEST(ended.out == "lives\ngone\n", ended);
}
