#include <algorithm>
#include <array>
#include <boost/test/unit_test.hpp>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/case_line.hpp"
#include "subjects/plugins.hpp"
#include "tests/subjects/from_environment.hpp"
#include "tests/subjects/processes.hpp"

using namespace rayaudit;
using namespace std::chrono_literals;

// The plugin of libraries from npm beside modules that do what a library should not.
namespace {

const std::vector<Subject>& subjects() {
  static const std::vector<Subject> all =
      plugin_subjects(from_environment("npm_plugin"), 2s, from_environment("RAYAUDIT"));
  return all;
}

const Subject& named(const std::string& name) {
  for (const Subject& subject : subjects())
    if (subject.name == name) return subject;
  throw std::runtime_error(name + " is not there");
}

bool is_there(const std::string& name) {
  return std::any_of(subjects().begin(), subjects().end(),
                     [&](const Subject& subject) { return subject.name == name; });
}

Answer answer_of(const Subject& subject, const std::string& line) {
  const Case question = read_case_line(line).question;
  Answer answer;
  subject.answer[question.shape.index()]({&question, 1}, {&answer, 1});
  return answer;
}

std::string answer(const std::string& subject, const std::string& line) {
  std::string words;
  write(words, answer_of(named(subject), line));
  return words;
}

const std::string easy = "sphere 0 0 0 1 ray -3 0 0 1 0 0",
                  hard = "sphere 0 0 0 1 ray 13 0 0 1 0 0";

/// What the program says of the planted plugin on standard error.
std::string complaints() {
  const std::string command = from_environment("RAYAUDIT") + " audit npm.right/double --plugin " +
                              from_environment("npm_plugin") +
                              " --shape disk --family anywhere --cases 1 2>&1 >/dev/null";
  FILE* const said = popen(command.c_str(), "r");
  std::string text;
  for (int letter; (letter = std::fgetc(said)) != EOF;) text += static_cast<char>(letter);
  pclose(said);
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(modules_answer_by_t_by_point_by_yes_or_not_at_all) {
  BOOST_TEST(answer("npm.right/double", "sphere 0 0 0 1 ray -3 0 0 2 0 0") == "hit 0x1.8p+0");
  BOOST_TEST(answer("npm.right/double", "sphere 7 0 0 5 ray -3 0 0 1 0 0") ==
             "at 0x1p+1 0x1.999999999999ap-4 -0x0p+0");
  BOOST_TEST(answer("npm.right/double", "disk 0 0 0 1 0 0 1 ray -3 0 0 1 0 0") == "yes");
  BOOST_TEST(answer("npm.right/double", "cone 0 0 0 0 1 0 1 ray -3 0 0 1 0 0") == "miss");
}

BOOST_AUTO_TEST_CASE(what_is_no_answer_is_garbage) {
  BOOST_TEST(answer("npm.right/double", "cylinder 0 0 0 0 1 0 1 ray -3 0 0 1 0 0") == "garbage");
}

BOOST_AUTO_TEST_CASE(a_module_tells_its_version_shapes_and_convention) {
  const Subject& right = named("npm.right/double");
  BOOST_TEST(right.about == "planted 1.5.0 (the adapter was written for 1.0.0), nothing");
  BOOST_TEST((right.format == double_format));
  const std::array answered = {true, true, true, true, false, false};
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    BOOST_TEST(right.answers(shape) == answered[shape]);
  Convention declared;
  declared.of(oracle::Kind::tangent) = Convention::Stance::hit;
  declared.inside = Convention::Inside::miss;
  declared.unit_direction = true;
  declared.t_min = 0;
  declared.stand = Convention::Stand::upright_y;
  declared.extent = Extent::unbounded;
  BOOST_TEST((right.convention == declared));
}

BOOST_AUTO_TEST_CASE(what_a_library_prints_is_no_answer) {
  BOOST_TEST(answer("npm.prints/double", easy) == "hit 0x1p+1");
}

BOOST_AUTO_TEST_CASE(a_library_that_throws_has_crashed_and_answers_again) {
  BOOST_TEST(answer("npm.throws/double", hard) == "crashed");
  BOOST_TEST(answer("npm.throws/double", easy) == "hit 0x1p+1");
}

BOOST_AUTO_TEST_CASE(a_library_that_hangs_is_ended_and_answers_again) {
  BOOST_TEST(answer("npm.hangs/double", hard) == "timed_out");
  BOOST_TEST(answer("npm.hangs/double", easy) == "hit 0x1p+1");
}

BOOST_AUTO_TEST_CASE(a_library_that_cannot_be_loaded_keeps_no_other_from_answering) {
  BOOST_TEST(answer("npm.unloadable/double", easy) == "crashed");
  BOOST_TEST(!is_there("npm.missing/double"));
  BOOST_TEST(!is_there("npm.throws_at_once/double"));
  const std::string said = complaints();
  BOOST_TEST(said.find("npm.missing: nowhere is not among the packages") != said.npos, said);
  BOOST_TEST(said.find("npm.throws_at_once: it throws before it is asked") != said.npos, said);
}

BOOST_AUTO_TEST_CASE(node_ends_with_the_process_that_asks_it) {
  const std::string words = "node " + from_environment("npm_folder") + "/main.mjs";
  const std::size_t before = processes_with(words).size();
  {
    const auto mine =
        plugin_subjects(from_environment("npm_plugin"), 2s, from_environment("RAYAUDIT"));
    answer_of(mine[0], easy);
    BOOST_TEST(processes_with(words).size() > before);
  }
  BOOST_TEST(comes_true([&] { return processes_with(words).size() == before; }));
}
