#define BOOST_TEST_MODULE convention
#include "subjects/convention.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <string>

#include "geometry/case_line.hpp"

using namespace rayaudit;

namespace {

/// A case line as it is asked.
std::string asked(std::string_view line, const Convention& convention,
                  const Format& format = double_format) {
  return case_line(posed(read_case_line(line).question, convention, format));
}

std::string spelled(std::string_view line) { return case_line(read_case_line(line).question); }

Convention unit() { return {.unit_direction = true}; }

}  // namespace

BOOST_AUTO_TEST_CASE(without_a_word_a_case_is_asked_as_it_is) {
  const std::string line = "sphere 0 0 0 1 ray 0 0 -3 0 3 4 range 1 2";
  BOOST_TEST(asked(line, {}) == spelled(line));
  BOOST_TEST(!poses({}));
  Convention touches;
  touches.of(oracle::Kind::rim) = Convention::Stance::hit;
  touches.inside = Convention::Inside::miss;
  BOOST_TEST(!poses(touches));
  BOOST_TEST(poses(unit()));
}

BOOST_AUTO_TEST_CASE(a_direction_is_normalised_and_the_range_with_it) {
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 0 4 range 0.5 2", unit()) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 2 8"));
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 3 4", unit()) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0x1.3333333333333p-1 0x1.999999999999ap-1"));
}

BOOST_AUTO_TEST_CASE(a_direction_is_normalised_in_the_format) {
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 3 4", unit(), float_format) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0x1.333334p-1 0x1.99999ap-1"));
}

BOOST_AUTO_TEST_CASE(squares_of_a_direction_neither_overflow_nor_underflow) {
  for (const char* size : {"1e300", "1e-300", "5e-324"})
    BOOST_TEST(asked(std::string("sphere 0 0 0 1 ray 0 0 -3 0 0 ") + size, unit()) ==
               spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1"));
}

BOOST_AUTO_TEST_CASE(a_direction_without_a_length_stays_as_it_is) {
  for (const char* line : {"sphere 0 0 0 1 ray 0 0 -3 0 0 0", "sphere 0 0 0 1 ray 0 0 -3 0 inf 1",
                           "sphere 0 0 0 1 ray 0 0 -3 nan 1 1"})
    BOOST_TEST(asked(line, unit()) == spelled(line));
}

BOOST_AUTO_TEST_CASE(a_line_goes_both_ways) {
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 1 2", {.line = true}) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range -inf inf"));
}

BOOST_AUTO_TEST_CASE(a_range_is_cut_to_what_the_subject_answers_in) {
  const Convention cut = {.t_min = 0.125, .t_max = 100};
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 0 1", cut) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0.125 100"));
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 1 2", cut) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 1 2"));
  BOOST_TEST(asked("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range nan 2", cut) ==
             spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range nan 2"));
}

BOOST_AUTO_TEST_CASE(what_is_stated_first_holds_and_ranges_meet) {
  Convention first = {.inside = Convention::Inside::miss, .t_min = 1, .t_max = 8};
  first.of(oracle::Kind::rim) = Convention::Stance::hit;
  Convention second = {
      .inside = Convention::Inside::start, .unit_direction = true, .t_min = 0, .t_max = 5};
  second.of(oracle::Kind::rim) = Convention::Stance::miss;
  second.of(oracle::Kind::tangent) = Convention::Stance::miss;
  const Convention both = joined(first, second);
  BOOST_TEST((both.of(oracle::Kind::rim) == Convention::Stance::hit));
  BOOST_TEST((both.of(oracle::Kind::tangent) == Convention::Stance::miss));
  BOOST_TEST((both.inside == Convention::Inside::miss));
  BOOST_TEST(both.unit_direction);
  BOOST_TEST(both.t_min == 1);
  BOOST_TEST(both.t_max == 5);
}
