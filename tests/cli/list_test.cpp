#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::printed;
using shell::run;

BOOST_AUTO_TEST_CASE(shapes_are_listed_with_their_sentence) {
  BOOST_TEST(run("rayaudit list shapes") ==
             printed("disk             the flat disk, rim included\n"
                     "sphere           the surface of the ball\n"
                     "cylinder         the lateral surface only, open at both ends\n"
                     "cone             the lateral surface only, one nappe, from base rim to apex\n"
                     "capped_cylinder  lateral surface and caps, the surface of a solid\n"
                     "capped_cone      one nappe and its base, the surface of a solid\n"));
}

BOOST_AUTO_TEST_CASE(subjects_are_listed_with_the_shapes_that_they_answer) {
  const auto ended = run("rayaudit list subjects");
  BOOST_TEST(contains(ended.out, "\nhandout/double                      disk sphere\n"));
  BOOST_TEST(contains(ended.out,
                      "\ntextbook/long_double                disk sphere cylinder cone "
                      "capped_cylinder capped_cone\n"));
  BOOST_TEST(contains(ended.out,
                      "\nstable_quadratic+fast_math/double   sphere cylinder cone "
                      "capped_cylinder capped_cone      by name only\n"));
}

BOOST_AUTO_TEST_CASE(a_program_is_listed_first_in_its_format) {
  const std::string list = "rayaudit list subjects --program 'A=1 ./mine --flag'";
  BOOST_TEST(run(list + " --format float")
                 .out.starts_with("mine/float                          disk sphere cylinder cone "
                                  "capped_cylinder capped_cone\n"));
  BOOST_TEST(run(list).out.starts_with("mine/double "));
  BOOST_TEST(run("rayaudit list --format float").code == 2);
}

BOOST_AUTO_TEST_CASE(help_says_what_becomes_of_what_is_brought_along) {
  const auto told = [](const std::string& command, const std::string& use) {
    const auto help = run("rayaudit " + command + " --help | tr -s ' \\n' ' '").out;
    for (const std::string brought :
         {"a shared object that brings subjects (rayaudit/plugin.h); ",
          "a program that reads case lines and writes them with its answers; "})
      BOOST_TEST(contains(help, brought + use), help);
  };
  for (const std::string command : {"audit", "ladder"})
    told(command, "without names, only what is brought along is chosen");
  told("list", "what it brings is listed first");
  told("explain", "its answer is shown too, and --subject may name it");
  told("check", "without --subject, only what is brought along is checked");
  told("merge", "to be named again where the shards had it");
}

BOOST_AUTO_TEST_CASE(families_are_listed_with_shapes_strength_and_difficulty) {
  const auto ended = run("rayaudit list families");
  BOOST_TEST(contains(
      ended.out,
      "\ngrazing        near        disk sphere cylinder cone "
      "capped_cylinder capped_cone  impact parameter r(1 +- 2^-k); k 1 to 51 (float 22): "));
  BOOST_TEST(contains(
      ended.out,
      "\napex           degenerate  cone capped_cone                                     "));
  BOOST_TEST(ended.out.starts_with(
      "anywhere       anywhere    disk sphere cylinder cone capped_cylinder capped_cone  "));
}

BOOST_AUTO_TEST_CASE(a_plain_list_has_all_four_headings) {
  const auto list = [](const std::string& what) { return run("rayaudit list " + what).out; };
  BOOST_TEST(list("") == "shapes\n" + list("shapes") + "\nsubjects\n" + list("subjects") +
                             "\nfamilies\n" + list("families") + "\nreports\n" + list("reports"));
  for (const std::string report : {"table ", "json ", "csv ", "html "})
    BOOST_TEST(contains("\n" + list("reports"), "\n" + report));
}

BOOST_AUTO_TEST_CASE(help_has_examples_everywhere) {
  for (const std::string command : {"", "audit", "explain", "draw", "truth", "judge", "list"}) {
    const auto ended = run("rayaudit " + command + " --help");
    BOOST_TEST(ended.code == 0);
    BOOST_TEST(ended.err == "");
    BOOST_TEST(contains(ended.out, "Examples:\n  "), command);
    BOOST_TEST(contains(ended.out, "Usage: rayaudit " + command), ended.out);
  }
}

BOOST_AUTO_TEST_CASE(the_version_is_told) {
  BOOST_TEST(run("rayaudit --version").out.starts_with("rayaudit "));
  BOOST_TEST(shell::line_count(run("rayaudit --version").out) == 1);
}
