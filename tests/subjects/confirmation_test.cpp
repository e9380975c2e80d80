#include "subjects/libraries/confirmation.hpp"

#include <unistd.h>

#include <boost/test/unit_test.hpp>
#include <filesystem>
#include <fstream>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

const std::string question = "sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 ";

/// Why a program does not confirm the answer of a line.
std::string why(const std::string& file, const std::string& text, const std::string& build,
                const std::string& answer) {
  const CaseLine read = read_case_line(question + answer);
  return why_unconfirmed({file, text, build}, read.question, *read.answer);
}

std::string of_script(const std::string& script, const std::string& answer) {
  return why("asks.sh", script, "sh FILE", answer);
}

}  // namespace

BOOST_AUTO_TEST_CASE(an_answer_is_printed_as_programs_print_it) {
  const auto shown = [](const std::string& answer) {
    return printed(*read_case_line(question + answer).answer);
  };
  BOOST_TEST(shown("hit 0x1.8p+0") == "hit 1.5");
  BOOST_TEST(shown("hit 0.1") == "hit 0.1");
  BOOST_TEST(shown("hit -inf") == "hit -inf");
  BOOST_TEST(shown("at 1 2.5 -0.25") == "at 1 2.5 -0.25");
  for (const std::string word : {"miss", "yes", "crashed", "timed_out"})
    BOOST_TEST(shown(word) == word);
}

BOOST_AUTO_TEST_CASE(a_program_confirms_that_says_the_answer_number_for_number) {
  BOOST_TEST(of_script("echo a library greets; echo hit 0.10000000000000001", "hit 0.1") == "");
  BOOST_TEST(of_script("echo at 1 2 3.0", "at 1 2 3") == "");
  BOOST_TEST(of_script("echo miss", "miss") == "");
  BOOST_TEST(of_script("echo hit nan", "hit nan") == "");
  BOOST_TEST(of_script("echo hit 0.1", "hit 0x1.99999ap-4") ==
             "it prints `hit 0.1`, and not `hit 0.10000000149011612`");
  BOOST_TEST(of_script("echo hit 1; echo miss", "hit 1") == "it prints `miss`, and not `hit 1`");
  BOOST_TEST(of_script("true", "miss") == "it prints ``, and not `miss`");
}

BOOST_AUTO_TEST_CASE(a_program_is_built_first_where_it_must_be) {
  const std::string text = "#include <cstdio>\nint main() { std::puts(\"miss\"); }\n";
  BOOST_TEST(why("asks.cpp", text, "c++ FILE -o PROGRAM", "miss") == "");
  const std::string absent =
      why("asks.cpp", "#include <no/such.h>\n", "c++ FILE -o PROGRAM", "miss");
  BOOST_TEST(absent.starts_with("it cannot be built: asks.cpp:1:"), absent);
  BOOST_TEST(absent.find("no/such.h") != absent.npos, absent);
}

BOOST_AUTO_TEST_CASE(a_crash_is_confirmed_by_one) {
  BOOST_TEST(of_script("kill -ABRT $$", "crashed") == "");
  BOOST_TEST(of_script("echo miss", "crashed") == "it does not crash");
  BOOST_TEST(of_script("kill -ABRT $$", "miss").starts_with("it fails"));
  const std::string text = "#include <cstdlib>\nint main() { std::abort(); }\n";
  BOOST_TEST(why("asks.cpp", text, "c++ FILE -o PROGRAM", "crashed") == "");
}

BOOST_AUTO_TEST_CASE(packages_are_those_beside_the_program_and_none_is_fetched) {
  const std::filesystem::path here =
      std::filesystem::temp_directory_path() / ("rayaudit-packages-" + std::to_string(getpid()));
  std::filesystem::create_directories(here / "npm/node_modules");
  std::ofstream(here / "npm/node_modules/planted") << "miss\n";
  const CaseLine read = read_case_line(question + "miss");
  const OutsideProgram asks = {"asks.sh", "cat node_modules/planted",
                               "npm install planted@1.0.0 && sh FILE"};
  BOOST_TEST(why_unconfirmed(asks, read.question, *read.answer, here / "npm") == "");
  std::filesystem::remove_all(here);
  const std::string absent = why_unconfirmed(asks, read.question, *read.answer, here / "npm");
  BOOST_TEST(absent.starts_with("it fails: cat: node_modules/planted: No such file"), absent);
}
