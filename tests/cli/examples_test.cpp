#include <boost/test/unit_test.hpp>

#include "tests/cli/shell.hpp"

// Each language is a test of ctest, skipped where the language is not here.

using boost::unit_test::precondition;
using shell::contains;
using shell::run;

namespace {

std::string example(const std::string& file) { return std::string(RAYAUDIT_EXAMPLES) + '/' + file; }

bool is_here(const std::string& program) {
  return run("command -v " + program + " >/dev/null").code == 0;
}

struct IsHere {
  std::string program;
  boost::test_tools::assertion_result operator()(boost::unit_test::test_unit_id) const {
    boost::test_tools::assertion_result here(is_here(program));
    if (!here) here.message() << program << " is not here";
    return here;
  }
};

/// The example is right where the textbook is, in an audit and in plain pipes, and knows spheres
/// only.
void try_example(const std::string& interpreter, const std::string& file) {
  const std::string command = interpreter + ' ' + example(file);
  const std::string sound =
      "--fail-on false_hit,false_miss,wrong_root,wrong_t,not_finite,max_ulp=1e5";
  const auto ended = run("rayaudit audit --program '" + command +
                         "' --shape sphere --family anywhere,inside,behind --cases 20k " + sound);
  BOOST_TEST(ended.code == 0, ended);
  BOOST_TEST(ended.err == "");
  BOOST_TEST(contains(ended.out, "  " + interpreter + "/double  "), ended);

  const auto piped = run("rayaudit draw --shape sphere --family anywhere --count 20k | " + command +
                         " | rayaudit judge " + sound);
  BOOST_TEST(piped.code == 0, piped);
  BOOST_TEST(contains(piped.out, "20,000 cases judged in double"), piped);

  const auto disks = run("rayaudit audit --program '" + command + "' --shape disk");
  BOOST_TEST(disks.code == 1);
  BOOST_TEST(contains(disks.err, file + " answers spheres only: --shape sphere\n"), disks);
  BOOST_TEST(contains(disks.err, "ended with exit code 1 after 0 of 1 answers when asked `disk"));
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_example_in_python_is_audited, *precondition(IsHere{"python3"})) {
  try_example("python3", "mine.py");
}

BOOST_AUTO_TEST_CASE(an_example_in_javascript_is_audited, *precondition(IsHere{"node"})) {
  try_example("node", "mine.mjs");
}
