#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

using shell::contains;
using shell::Folder;
using shell::run;

namespace {

/// The program without its plugins, in bin.
const std::string alone =
    "mkdir bin; program=$(type rayaudit | grep -o \"'.*'\" | tr -d \"'\")\n"
    "ln \"$program\" bin 2>.ln || cp \"$program\" bin\n";
const std::string audit =
    "audit 'textbook+fast_math/float' --shape sphere --family anywhere --cases 2000";

}  // namespace

BOOST_AUTO_TEST_CASE(a_twin_is_audited_like_any_subject) {
  const auto ended = run("rayaudit " + audit + " --threads 4");
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "  textbook+fast_math/float     anywhere  "), ended);
  BOOST_TEST(contains(ended.out, "no flush to zero"));
}

BOOST_AUTO_TEST_CASE(a_plugin_is_found_in_a_library_folder_too_and_told_where_it_is_missing) {
  const Folder folder;
  const auto listed = folder.run(alone + "bin/rayaudit list subjects");
  BOOST_TEST(!contains(listed.out, "textbook+"), listed);
  BOOST_TEST(contains(listed.out,
                      "*+fast_math/*                       not here: rayaudit-fast_math.so, "
                      "compiled with -O3 -ffast-math, is not beside the program\n"),
             listed);
  BOOST_TEST(contains(listed.out, "*+native/*                          not here: rayaudit-native"));
  const std::string installed =
      "mkdir -p lib/rayaudit; : > lib/rayaudit/rayaudit-native.so; bin/rayaudit list subjects";
  BOOST_TEST(contains(folder.run(installed).out, "\ntextbook+native/double  "));
}

BOOST_AUTO_TEST_CASE(a_plugin_that_does_not_answer_is_told_and_is_a_finding) {
  const auto ended = run(alone + "echo text > bin/rayaudit-fast_math.so; bin/rayaudit " + audit);
  BOOST_TEST(ended.code == 1);
  BOOST_TEST(ended.out == "");
  BOOST_TEST(
      ended.err.starts_with("rayaudit: textbook+fast_math/float does not answer: its plugin "),
      ended);
  BOOST_TEST(contains(ended.err, "/bin/rayaudit-fast_math.so cannot be loaded: "), ended);
  BOOST_TEST(shell::line_count(ended.err) == 1);
}

BOOST_AUTO_TEST_CASE(the_command_that_serves_a_plugin_is_for_no_person) {
  BOOST_TEST(!contains(run("rayaudit --help").out, "serve"));
  BOOST_TEST(!contains(run("rayaudit").err, "serve"));
  BOOST_TEST(!contains(run("rayaudit serve").err, "serve-plugin"));
}
