#include "subjects/twins.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstdio>

#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "geometry/flattened.hpp"
#include "oracle/environment.hpp"
#include "tests/subjects/from_environment.hpp"

using namespace rayaudit;

namespace {

const std::vector<Subject>& twins() {
  static const std::vector<Subject> twins = twins_beside(from_environment("RAYAUDIT"));
  return twins;
}

const Subject& named(const std::vector<Subject>& subjects, const std::string& name) {
  const auto found = std::find_if(subjects.begin(), subjects.end(),
                                  [&](const Subject& subject) { return subject.name == name; });
  BOOST_TEST_REQUIRE((found != subjects.end()), name);
  return *found;
}
const Subject& twin(const std::string& name) { return named(twins(), name); }
const Subject& plain(const std::string& name) { return named(built_in_subjects(), name); }

/// `textbook/float` of `textbook+native/float`.
std::string plain_name(std::string name) {
  const std::size_t plus = name.find('+');
  return name.erase(plus, name.find('/') - plus);
}

std::vector<Case> drawn(const std::string& id, std::size_t shape, const Format& format,
                        std::size_t count) {
  const auto family = std::find_if(families().begin(), families().end(),
                                   [&](const Family& each) { return each.id == id; });
  std::vector<Case> cases(count);
  draw(*family, shape, format, {}, 5, 0, cases);
  return cases;
}

std::vector<Answer> answers(const Subject& subject, std::size_t shape,
                            const std::vector<Case>& cases) {
  std::vector<Answer> answers(cases.size());
  subject.answer[shape](cases, answers);
  return answers;
}

bool is_near(const Real& a, const Real& b, double size) {
  return std::fabs(a.high - b.high) <= size * 0x1p-20;
}

/// Are they the same but for rounding that no hard case has made worse?
bool agree(const Answer& a, const Answer& b) {
  if (a.form != b.form) return false;
  if (a.form == Answer::Form::hit) return is_near(a.t, b.t, std::fabs(b.t.high));
  if (a.form != Answer::Form::at) return true;
  const auto& [x, y, z] = b.point;
  const double size = std::hypot(x.high, y.high, z.high);
  return is_near(a.point.x, x, size) && is_near(a.point.y, y, size) && is_near(a.point.z, z, size);
}

/// In how many answers to hard cases do a subject and its twin differ?
std::ptrdiff_t differing(const std::string& twin_name) {
  const Subject &here = plain(plain_name(twin_name)), &there = twin(twin_name);
  std::ptrdiff_t count = 0;
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    const std::vector<Case> cases = drawn("grazing", shape, here.format, 500);
    const auto one = answers(here, shape, cases), other = answers(there, shape, cases);
    for (std::size_t i = 0; i < cases.size(); ++i) count += !(one[i] == other[i]);
  }
  return count;
}

}  // namespace

BOOST_AUTO_TEST_CASE(every_routine_has_its_twins_in_float_and_double_on_its_shapes) {
  std::vector<std::string> names, wanted;
  for (const Subject& subject : twins()) {
    names.push_back(subject.name);
    const Subject& same = plain(plain_name(subject.name));
    BOOST_TEST((subject.format == same.format), subject.name);
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      BOOST_TEST(subject.answers(shape) == same.answers(shape), subject.name);
      BOOST_TEST((subject.timed[shape] != nullptr) == same.answers(shape), subject.name);
    }
  }
  for (const std::string flags : {"+fast_math", "+native"})
    for (const Subject& subject : built_in_subjects())
      if (!subject.name.starts_with("certified/") && subject.format != long_double_format)
        wanted.push_back(std::string(subject.name).insert(subject.name.find('/'), flags));
  BOOST_TEST(names == wanted, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(every_twin_answers_every_shape_that_it_is_said_to) {
  for (const Subject& subject : twins())
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      if (!subject.answers(shape)) continue;
      const std::vector<Case> cases = drawn("anywhere", shape, subject.format, 3);
      BOOST_CHECK_NO_THROW(answers(subject, shape, cases));
    }
}

BOOST_AUTO_TEST_CASE(on_easy_cases_a_twin_differs_in_rounding_alone) {
  for (const Subject& subject : twins()) {
    if (subject.format != double_format) continue;
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      if (!subject.answers(shape)) continue;
      const std::vector<Case> cases = drawn("anywhere", shape, double_format, 500);
      const auto there = answers(subject, shape, cases);
      const auto here = answers(plain(plain_name(subject.name)), shape, cases);
      for (std::size_t i = 0; i < cases.size(); ++i)
        if (!agree(there[i], here[i])) BOOST_FAIL(subject.name << ": " << case_line(cases[i]));
    }
  }
}

BOOST_AUTO_TEST_CASE(on_hard_cases_the_flags_are_seen) {
  BOOST_TEST(differing("textbook+fast_math/double") > 0);
  BOOST_TEST(differing("textbook+fast_math/float") > 0);
  if (!has_fused()) return;
  BOOST_TEST(differing("textbook+native/double") > 0);
  BOOST_TEST(differing("textbook+native/float") > 0);
}

BOOST_AUTO_TEST_CASE(no_twin_flushes_subnormal_numbers_to_zero) {
  const std::string disk = "disk 0 0x1p-140 0 0 1 0 1 ray 0 0 0 0 1 0";
  const Case question = read_case_line(disk).question;
  for (const std::string name : {"textbook+fast_math/float", "textbook+native/float"})
    BOOST_TEST((answer_one(twin(name), question) == Answer::hit(real(0x1p-140f))), name);
}

BOOST_AUTO_TEST_CASE(our_own_arithmetic_stays_as_it_was) {
  for (const Subject& subject : twins())
    if (subject.name.starts_with("textbook"))
      answers(subject, 1, drawn("grazing", 1, subject.format, 20));
  BOOST_CHECK_NO_THROW(oracle::require_plain_arithmetic());
  volatile double least = 0x1p-1074;
  BOOST_TEST(least * 1.0 != 0);
}

BOOST_AUTO_TEST_CASE(a_plugin_shows_its_entry_and_nothing_else) {
  const std::filesystem::path folder =
      std::filesystem::path(from_environment("RAYAUDIT")).parent_path();
  for (const std::string flags : {"fast_math", "native"}) {
    const std::string plugin = (folder / ("rayaudit-" + flags + ".so")).string();
    std::FILE* const symbols = popen(("nm -D --defined-only '" + plugin + "'").c_str(), "r");
    std::string text(1000, '\0');
    text.resize(std::fread(text.data(), 1, text.size(), symbols));
    pclose(symbols);
    BOOST_TEST(text.ends_with(" T rayaudit_plugin_entry\n"), text);
    BOOST_TEST(std::count(text.begin(), text.end(), '\n') == 1, text);
  }
}
