#include "subjects/convention.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <string>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "rayaudit/case.h"
#include "subjects/flat_convention.hpp"

using namespace rayaudit;

namespace {

/// A case line as it is asked.
std::string asked(std::string_view line, const Convention& convention,
                  const Format& format = double_format) {
  return case_line(posed(read_case_line(line).question, convention, format));
}

std::string spelled(std::string_view line) { return case_line(read_case_line(line).question); }

Convention unit() { return {.unit_direction = true}; }

/// How a call refuses.
template <class Call>
std::string refusal(const Call& call) {
  try {
    call();
  } catch (const Error& why) {
    return why.what();
  }
  return "it is taken";
}

std::string refusal_of_flat(const rayaudit_convention& said) {
  return refusal([&] { from_flat(said); });
}

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

BOOST_AUTO_TEST_CASE(ranges_that_do_not_meet_are_refused) {
  const Convention late = {.t_min = 5, .t_max = 8};
  const auto beside = [&](double t_min, double t_max) {
    return refusal([&] { joined({.t_min = t_min, .t_max = t_max}, late); });
  };
  const std::string sentence =
      "--convention leaves, with what a subject declares itself, the empty range from ";
  BOOST_TEST(beside(0, 5) == sentence + "5 to 5 for t");
  BOOST_TEST(beside(9, 12) == sentence + "9 to 8 for t");
  BOOST_TEST(beside(0, 5.5) == "it is taken");
}

BOOST_AUTO_TEST_CASE(what_either_says_of_stand_opening_extent_and_segment_holds) {
  using Stand = Convention::Stand;
  using Opening = Convention::Opening;
  const Convention subject = {.extent = Extent::both_nappes,
                              .stand = Stand::upright_z,
                              .opening = Opening::cosine,
                              .segment = true};
  BOOST_TEST((joined({}, subject) == subject));
  BOOST_TEST((joined({.opening = Opening::angle}, subject).opening == Opening::angle));
  BOOST_TEST((joined({.stand = Stand::upright_y}, subject).stand == Stand::upright_y));
  BOOST_TEST((joined({.extent = Extent::unbounded}, subject).extent == Extent::unbounded));
  const Convention line = joined({.line = true}, subject);
  BOOST_TEST(line.line);
  BOOST_TEST(!line.segment);
  for (const Convention& each :
       {Convention{.extent = Extent::unbounded}, Convention{.stand = Stand::upright_y},
        Convention{.segment = true}})
    BOOST_TEST(poses(each));
}

BOOST_AUTO_TEST_CASE(what_contradicts_itself_together_is_refused) {
  const std::string sentence = "--convention leaves, with what a subject declares itself, ";
  const auto beside = [](const Convention& first, const Convention& second) {
    return refusal([&] { joined(first, second); });
  };
  BOOST_TEST(beside({.opening = Convention::Opening::angle}, {}) ==
             sentence + "an opening that is no radius, but no stand that is upright");
  BOOST_TEST(beside({.unit_direction = true}, {.segment = true}) ==
             sentence +
                 "a segment, whose direction is as long as it is, with a direction of "
                 "length 1");
}

BOOST_AUTO_TEST_CASE(each_word_in_plain_c_is_taken_for_its_own) {
  using oracle::Kind;
  using Stance = Convention::Stance;
  const std::pair<std::int32_t rayaudit_convention::*, Kind> touches[] = {
      {&rayaudit_convention::tangent, Kind::tangent}, {&rayaudit_convention::rim, Kind::rim},
      {&rayaudit_convention::apex, Kind::apex},       {&rayaudit_convention::start, Kind::start},
      {&rayaudit_convention::end, Kind::end},         {&rayaudit_convention::within, Kind::within}};
  BOOST_TEST((from_flat({}) == Convention{}));
  for (const auto& [field, kind] : touches) {
    rayaudit_convention said = {};
    Convention meant;
    said.*field = RAYAUDIT_IS_MISS, meant.of(kind) = Stance::miss;
    BOOST_TEST((from_flat(said) == meant), name(kind));
  }
  rayaudit_convention said = {};
  said.inside = RAYAUDIT_INSIDE_IS_START, said.line = 1, said.t_min = -2, said.t_max = 3;
  BOOST_TEST(
      (from_flat(said) ==
       Convention{.inside = Convention::Inside::start, .line = true, .t_min = -2, .t_max = 3}));
  said = {}, said.unit_direction = 1;
  BOOST_TEST((from_flat(said) == unit()));
}

BOOST_AUTO_TEST_CASE(extent_stand_opening_and_segment_in_plain_c_are_taken_for_their_own) {
  rayaudit_convention said = {};
  said.extent = RAYAUDIT_BOTH_NAPPES, said.stand = RAYAUDIT_UPRIGHT_Y;
  said.opening = RAYAUDIT_BY_COSINE, said.segment = 1;
  BOOST_TEST((from_flat(said) == Convention{.extent = Extent::both_nappes,
                                            .stand = Convention::Stand::upright_y,
                                            .opening = Convention::Opening::cosine,
                                            .segment = true}));
  said = {}, said.stand = RAYAUDIT_UPRIGHT_Z, said.opening = RAYAUDIT_BY_ANGLE;
  BOOST_TEST((from_flat(said) == Convention{.stand = Convention::Stand::upright_z,
                                            .opening = Convention::Opening::angle}));
  said = {}, said.opening = RAYAUDIT_BY_ANGLE;
  BOOST_TEST(refusal_of_flat(said) ==
             "its convention has an opening that is no radius, but no stand that is upright");
  said = {}, said.segment = said.line = 1;
  BOOST_TEST((from_flat(said) == Convention{.line = true, .segment = true}));
  said = {}, said.stand = 3;
  BOOST_TEST(refusal_of_flat(said) ==
             "its convention has 3 for stand, which is no rayaudit_stand (0, 1 or 2)");
  said = {}, said.opening = -1;
  BOOST_TEST(refusal_of_flat(said) ==
             "its convention has -1 for opening, which is no rayaudit_opening (0, 1 or 2)");
  said = {}, said.extent = 7;
  BOOST_TEST(refusal_of_flat(said) ==
             "its convention has 7 for extent, which is no rayaudit_extent (0, 1 or 2)");
}

BOOST_AUTO_TEST_CASE(what_no_word_in_plain_c_means_is_refused) {
  rayaudit_convention said = {};
  said.apex = 3;
  BOOST_TEST(refusal_of_flat(said) ==
             "its convention has 3 for apex, which is no rayaudit_stance (0, 1 or 2)");
  said = {}, said.inside = -1;
  BOOST_TEST(refusal_of_flat(said) ==
             "its convention has -1 for inside, which is no rayaudit_inside (0 to 3)");
  said = {}, said.t_min = said.t_max = 2;
  BOOST_TEST(refusal_of_flat(said) == "its convention has the empty range from 2 to 2 for t");
}

BOOST_AUTO_TEST_CASE(a_case_is_asked_in_the_numbers_of_the_format) {
  const std::string line = "cone 0 0 0.1 0 1 0 1 ray 0 0 -3 0 0 1e-60 range 0.3 nan";
  BOOST_TEST(case_line(asked(read_case_line(line).question, {}, double_format)) == spelled(line));
  BOOST_TEST(case_line(asked(read_case_line(line).question, {}, float_format)) ==
             spelled("cone 0 0 0x1.99999ap-4 0 1 0 1 ray 0 0 -3 0 0 0 range 0x1.333334p-2 nan"));
}

BOOST_AUTO_TEST_CASE(what_was_asked_so_already_is_asked_as_it_is) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> component;
  for (const Format& format : {float_format, double_format})
    for (int i = 0; i < 2000; ++i) {
      const Vec3<double> direction = {component(random), component(random), component(random)};
      const Case drawn = {{{0, 0, -3}, direction, 0.25, 9}, Sphere<double>{{0, 0, 0}, 1}};
      const Case once = asked(drawn, unit(), format);
      BOOST_TEST_REQUIRE((asked(once, unit(), format) == once), case_line(drawn));
    }
  // Longer by eight units in the last place, it is none of length 1.
  BOOST_TEST(
      case_line(asked(read_case_line("sphere 0 0 0 1 ray 0 0 -3 0 0 0x1.0000000000008p+0").question,
                      unit(), double_format)) == spelled("sphere 0 0 0 1 ray 0 0 -3 0 0 1"));
}
