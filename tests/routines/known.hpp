#pragma once

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <concepts>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "geometry/case_line.hpp"
#include "geometry/ray.hpp"

/// Cases whose answers were computed by hand; lines that a sound routine answers without a
/// rounding, in any binary number, but for in_general_position.
namespace rayaudit::known {

using Lines = std::vector<std::string_view>;

inline const Lines from_outside = {
    "disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 -1 0 hit 2",
    "disk 1 2 3 0 0 4 2 ray 1 3 -1 0 0 2 hit 2",
    "disk 1 0 0 -2 0 0 4 ray 5 0 0 -2 1 0 hit 2",
    "sphere 0 0 0 1 ray -3 0 0 1 0 0 hit 2",
    "sphere 1 2 3 2 ray 1 2 -5 0 0 4 hit 1.5",
    "cylinder 0 0 0 0 1 0 1 ray -3 0.5 0 2 0 0 hit 1",
    "cylinder 0 0 -2 0 0 2 2 ray 0 8 1 0 -1 0 hit 6",
    "cylinder 0 0 0 0 4 0 1 ray -3 1 0 1 1 0 hit 2",
    "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 hit 2.5",
    "cone 0 0 0 0 2 0 2 ray -4 0.5 0 2 0 0 hit 1.25",
    "cone 0 0 0 2 0 0 1 ray 1 4 0 0 -1 0 hit 3.5",
    "capped_cylinder 0 0 0 0 1 0 1 ray -3 0.5 0 2 0 0 hit 1",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0.5 3 0 0 -1 0 hit 2",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0.5 -3 0.25 0 2 0 hit 1.5",
    "capped_cylinder 0 0 0 0 1 0 2 ray -3 3 0 1 -1 0 hit 2",
    "capped_cylinder 0 0 0 0 4 0 1 ray -3 1 0 1 1 0 hit 2",
    "capped_cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 hit 2.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 -3 0 0 1 0 hit 3",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 5 0 0 -1 0 hit 4.25",
    "capped_cone 0 0 0 0 4 0 2 ray -2 -2 0 2 4 0 hit 0.5",
};

inline const Lines passing_by = {
    "disk 0 0 0 0 1 0 1 ray 1.5 2 0 0 -1 0 miss",
    "sphere 0 0 0 1 ray -3 1.5 0 1 0 0 miss",
    "cylinder 0 0 0 0 1 0 1 ray -3 0.5 1.5 1 0 0 miss",
    "cone 0 0 0 0 1 0 1 ray -3 0.5 0.75 1 0 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray -3 0.5 1.5 1 0 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray 1.5 3 0 0 -1 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray -3 0.5 0.75 1 0 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 1.5 -3 0 0 1 0 miss",
};

inline const Lines from_inside = {
    "sphere 0 0 0 1 ray 0 0 0 2 0 0 hit 0.5",
    "sphere 1 0 0 2 ray 2 0 0 -1 0 0 hit 3",
    "cylinder 0 0 0 0 1 0 1 ray 0 0.5 0 0 0 -1 hit 1",
    "cylinder 0 0 0 0 1 0 4 ray 2 0.5 0 -1 0 0 hit 6",
    "cone 0 0 0 0 1 0 1 ray 0 0.5 0 1 0 0 hit 0.5",
    "cone 0 0 0 0 1 0 1 ray 0.25 0.5 0 -1 0 0 hit 0.75",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0 0.5 0 0 0 -1 hit 1",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0.5 0.25 0 0 1 0 hit 0.75",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0.5 0.25 0 0 -1 0 hit 0.25",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0 0.5 0 1 1 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0 0.5 0 1 0 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 0.5 0 0 -1 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 0.5 0 0 1 0 hit 0.25",
    "capped_cone 0 0 0 0 1 0 1 ray 0 0.5 0 1 -1 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0 0.25 0 1 1 0 hit 0.375",
};

inline const Lines behind = {
    "disk 0 0 0 0 1 0 1 ray 0 2 0 0 1 0 miss",
    "sphere 0 0 0 1 ray 3 0 0 1 0 0 miss",
    "cylinder 0 0 0 0 1 0 1 ray 3 0.5 0 1 0 0 miss",
    "cone 0 0 0 0 1 0 1 ray 3 0.5 0 1 0 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray 3 0.5 0 1 0 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0.5 3 0 0 1 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 3 0.5 0 1 0 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 -3 0 0 -1 0 miss",
};

inline const Lines clipped = {
    "cylinder 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0 miss",
    "cylinder 0 0 0 0 1 0 1 ray -3 -0.5 0 1 0 0 miss",
    "cylinder 0 0 0 0 2 0 1 ray -3 -3 0 1 1 0 hit 4",
    "cylinder 0 0 0 0 2 0 1 ray -3 5 0 1 -1 0 hit 4",
    "cone 0 0 0 0 1 0 1 ray -3 -0.5 0 1 0 0 miss",
    "cone 0 0 0 0 1 0 1 ray 0 -0.5 0 1 1 0 hit 0.75",
    "cone 0 0 0 0 1 0 1 ray 0.5 3 0 0 -1 0 range 2 8 hit 2.5",
    "cone 0 0 0 0 1 0 1 ray 1.5 3 0 0 -1 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray -3 -0.5 0 1 0 0 miss",
    "capped_cylinder 0 0 0 0 2 0 1 ray -3 -2.5 0 1 1 0 hit 2.5",
    "capped_cone 0 0 0 0 1 0 1 ray -3 -0.5 0 1 0 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 0 -0.5 0 1 1 0 hit 0.5",
};

inline const Lines parallel = {
    "disk 0 0 0 0 1 0 1 ray -3 1 0 1 0 0 miss",
    "disk 0 0 0 0 1 0 1 ray 0 -1 0 1 0 0 miss",
    "cylinder 0 0 0 0 1 0 1 ray 0.5 -1 0 0 1 0 miss",
    "cylinder 0 0 0 0 1 0 1 ray 2 -1 0 0 1 0 miss",
    "cylinder 0 0 0 1 2 2 3 ray 1 0.5 -1 1 2 2 miss",
    "cone 0 0 0 0 1 0 1 ray -1 1 0 1 -1 0 hit 0.5",
    "cone 0 0 0 0 1 0 1 ray 0 0 0 1 1 0 hit 0.5",
    "cone 0 0 0 0 1 0 1 ray 0 1 0.5 1 -1 0 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray 2 -1 0 0 1 0 miss",
    "capped_cylinder 0 0 0 1 2 2 3 ray 1 0.5 -1 1 2 2 hit 1",
    "capped_cone 0 0 0 0 1 0 1 ray -1 1 0 1 -1 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0 1 0.5 1 -1 0 miss",
};

inline const Lines one_nappe = {
    "cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0 miss",
    "cone 0 0 0 0 1 0 1 ray 0.25 5 0 0 -1 0 hit 4.25",
    "cone 0 0 0 0 1 0 1 ray 0.25 -3 0 0 1 0 hit 3.75",
    "cone 0 0 0 0 1 0 1 ray 0.25 1 0 0 1 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray -3 1.5 0 1 0 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 1 0 0 1 0 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 0 1.5 0 4 -1 0 miss",
};

inline const Lines through_the_apex = {
    "cone 0 0 0 0 1 0 1 ray 0 -1 0 0 1 0 hit 2",
    "cone 0 0 0 0 1 0 1 ray 0 3 0 0 -1 0 hit 2",
    "cone 0 0 0 0 1 0 1 ray -0.5 3 0 0.25 -1 0 hit 2",
    "capped_cone 0 0 0 0 1 0 1 ray 0 0.5 0 0 1 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray 0 3 0 0 -1 0 hit 2",
    "capped_cone 0 0 0 0 1 0 1 ray -0.5 3 0 0.25 -1 0 hit 2",
};

inline const Lines in_a_range = {
    "disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 -1 0 range 1.5 2.5 hit 2",
    "disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 -1 0 range 2 4 miss",
    "disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 -1 0 range 0 2 miss",
    "disk 0 0 0 0 1 0 1 ray 0.5 2 0 0 1 0 range -4 0 hit -2",
    "sphere 0 0 0 1 ray -3 0 0 1 0 0 range 1.5 2.5 hit 2",
    "sphere 0 0 0 1 ray -3 0 0 1 0 0 range 2.5 8 hit 4",
    "sphere 0 0 0 1 ray -3 0 0 1 0 0 range 0 1.5 miss",
    "sphere 0 0 0 1 ray -3 0 0 1 0 0 range 2 4 miss",
    "sphere 0 0 0 1 ray 3 0 0 1 0 0 range -8 0 hit -4",
    "cylinder 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 range 2.5 8 hit 4",
    "cylinder 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 range 2 4 miss",
    "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 range 2.75 8 hit 3.5",
    "cone 0 0 0 0 1 0 1 ray -3 0.5 0 1 0 0 range 2.5 3.5 miss",
    "cone 0 0 0 0 1 0 1 ray 0.25 5 0 0 -1 0 range 0 4 miss",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0 3 0 0 -1 0 range 2.5 8 hit 3",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0 3 0 0 -1 0 range 2 3 miss",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 5 0 0 -1 0 range 4.5 8 hit 5",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 5 0 0 -1 0 range 0 4 miss",
};

/// Through an edge of a closed shape: from outside inwards, from inside outwards.
inline const Lines edges = {
    "capped_cylinder 0 0 0 0 1 0 1 ray -3 -2 0 2 2 0 hit 1",
    "capped_cylinder 0 0 0 0 1 0 1 ray -2 2 0 1 -1 0 hit 1",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0 0.5 0 2 1 0 hit 0.5",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0 0.5 0 2 -1 0 hit 0.5",
    "capped_cone 0 0 0 0 1 0 1 ray -3 -1 0 2 1 0 hit 1",
    "capped_cone 0 0 0 0 1 0 1 ray 0 0.25 0 4 -1 0 hit 0.25",
};

inline const std::vector<Lines> all_exact = {
    from_outside, passing_by, from_inside,      behind,     clipped,
    parallel,     one_nappe,  through_the_apex, in_a_range, edges};

/// The unit shapes seen from the frame (1,2,2), (2,1,-2), (2,-2,1), its lengths 3; and triples 3,
/// 4, 5.
inline const Lines in_general_position = {
    "disk 0 0 0 2 1 -2 3 ray 6.5 4 -5 -2 -1 2 hit 3",
    "disk 10 20 30 -2 -1 2 3 ray 16.5 24 25 -2 -1 2 hit 3",
    "sphere 0 0 0 3 ray -3 -6 -6 1 2 2 hit 2",
    "sphere 10 20 30 3 ray 7 14 24 1 2 2 hit 2",
    "sphere 0 0 0 5 ray -8 3 0 1 0 0 hit 4",
    "sphere 0 0 0 5 ray 3 0 0 0 1 0 hit 4",
    "cylinder 0 0 0 2 1 -2 3 ray -2 -5.5 -7 1 2 2 hit 2",
    "cylinder 10 20 30 12 21 28 3 ray 8 14.5 23 1 2 2 hit 2",
    "cylinder 0 0 0 0 1 0 5 ray 3 0.5 0 0 0 1 hit 4",
    "cone 0 0 0 2 1 -2 3 ray -2 -5.5 -7 1 2 2 hit 2.5",
    "cone 10 20 30 12 21 28 3 ray 8 14.5 23 1 2 2 hit 2.5",
    "cone 0 0 0 0 2 0 10 ray 3 1 0 0 0 1 hit 4",
    "capped_cylinder 0 0 0 2 1 -2 3 ray 6.5 4 -5 -2 -1 2 hit 2",
    "capped_cylinder 0 0 0 2 1 -2 3 ray -2 -5.5 -7 1 2 2 hit 2",
    "capped_cone 0 0 0 2 1 -2 3 ray -5.5 -2 7 2 1 -2 hit 3",
    "capped_cone 10 20 30 12 21 28 3 ray 8 14.5 23 1 2 2 hit 2.5",
};

/// Calls visit(ray, shape) in the number N where the routine answers the shape.
template <class Routine, class N, class V>
void visit_in(const Case& question, const V& visit) {
  std::visit(
      [&](const auto& shape) {
        const Ray<N> ray = in<N>(question.ray);
        if constexpr (std::invocable<const Routine&, const Ray<N>&, decltype(in<N>(shape))>)
          visit(ray, in<N>(shape));
      },
      question.shape);
}

/// The t of the answer on a case line, none for a miss.
inline std::optional<double> known_t(const CaseLine& line) {
  if (line.answer->form == Answer::Form::miss) return {};
  return line.answer->t.high;
}

/// Does the routine answer each line in N as told, with a relative error of t of at most `off`?
template <class Routine, class N>
void answers_within(const Lines& lines, N off) {
  for (const std::string_view text : lines) {
    const CaseLine line = read_case_line(text);
    const std::optional<double> t = known_t(line);
    visit_in<Routine, N>(line.question, [&](const Ray<N>& ray, const auto& shape) {
      const std::optional<N> said = Routine()(ray, shape);
      BOOST_TEST_CONTEXT(text << " in " << format_of<N>.name) {
        BOOST_TEST(said.has_value() == t.has_value());
        if (said && t) BOOST_TEST(std::abs(*said - N(*t)) <= off * std::abs(N(*t)), "t " << *said);
      }
    });
  }
}

template <class Routine>
void answers(const Lines& lines) {
  answers_within<Routine, float>(lines, 0);
  answers_within<Routine, double>(lines, 0);
  answers_within<Routine, long double>(lines, 0);
}

/// In general position, where a few roundings are granted.
template <class Routine>
void answers_in_general_position() {
  const auto few = []<class N>(N) { return 16 * std::numeric_limits<N>::epsilon(); };
  answers_within<Routine, float>(in_general_position, few(0.0f));
  answers_within<Routine, double>(in_general_position, few(0.0));
  answers_within<Routine, long double>(in_general_position, few(0.0L));
}

/// In a world `scale` times as large, and with a direction `speed` times as long, t is
/// scale / speed times as large; powers of two change no digit of it.
template <class Routine>
void answers_at_scale(const Lines& lines, double scale, double speed) {
  for (const std::string_view text : lines) {
    const CaseLine line = read_case_line(text);
    const std::optional<double> t = known_t(line);
    Case question = line.question;
    each_number(question, [&](double& number) { number *= scale; });
    question.ray.direction = speed / scale * question.ray.direction;
    question.ray.t_min *= scale / speed;
    question.ray.t_max *= scale / speed;
    visit_in<Routine, float>(question, [&](const Ray<float>& ray, const auto& shape) {
      const std::optional<float> said = Routine()(ray, shape);
      BOOST_TEST_CONTEXT(case_line(question)) {
        BOOST_TEST(said.has_value() == t.has_value());
        if (said && t) BOOST_TEST(*said == float(*t * (scale / speed)));
      }
    });
  }
}

/// In float, where the square of every number leaves the format.
template <class Routine>
void answers_at_every_scale() {
  constexpr double tiny = 0x1p-100, huge = 0x1p100;
  constexpr std::pair<double, double> scale_and_speed[] = {{1, tiny},    {1, huge},    {tiny, 1},
                                                           {tiny, tiny}, {huge, huge}, {huge, 1}};
  for (const Lines& lines : all_exact)
    for (const auto& [scale, speed] : scale_and_speed)
      answers_at_scale<Routine>(lines, scale, speed);
}

}  // namespace rayaudit::known
