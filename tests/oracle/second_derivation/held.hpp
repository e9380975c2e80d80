#pragma once

#include <boost/test/unit_test.hpp>
#include <random>

#include "tests/families/drawn.hpp"
#include "tests/oracle/closed.hpp"
#include "tests/oracle/second_derivation/derived.hpp"

/// The oracle held against a second derivation, on cases of every family.
namespace rayaudit::second {

using Derivation = Crossings (*)(const Case&);

/// |t - exact| <= 2^-63 |exact|, exactly.
inline bool is_close(const Real& t, const Number& exact) {
  const Rational q = rational(t), u = power_of_two(-63);
  const Rational nearer = q / (1 + u), farther = q / (1 - u);
  return q > 0 ? exact(nearer) >= 0 && exact(farther) <= 0
               : exact(nearer) <= 0 && exact(farther) >= 0;
}

/// Is the last bit of the significand 0, as of infinities and zeros?
template <class N>
bool is_even(N x) {
  if (x == 0 || std::isinf(x)) return true;
  const int last = spacing_exponent(real(x), format_of<N>);
  return std::fmod(std::ldexp(x, -last), N(2)) == 0;
}

/// Where x stands as a neighbour to round to: infinity one spacing beyond the largest number.
template <class N>
Rational place(N x) {
  if (!std::isinf(x)) return rational(real(x));
  const N largest = std::copysign(std::numeric_limits<N>::max(), x);
  return 2 * rational(real(largest)) - rational(real(std::nextafter(largest, N(0))));
}

/// Is x the number of N nearest to exact, ties to even, overflow to infinity?
template <class N>
bool is_nearest(N x, const Number& exact) {
  constexpr N infinity = std::numeric_limits<N>::infinity();
  const auto beyond_midpoint_to = [&](N end) {
    if (x == end) return false;
    const Rational midpoint = (place(x) + place(std::nextafter(x, end))) / 2;
    const int outward = exact(midpoint) * (end > 0 ? 1 : -1);
    return outward > 0 || (outward == 0 && !is_even(x));
  };
  return !beyond_midpoint_to(-infinity) && !beyond_midpoint_to(infinity);
}

inline bool agree(const oracle::Truth& truth, const Crossings& derived) {
  if (truth.invalid != oracle::Invalid::no || truth.count != derived.size()) return false;
  for (std::size_t i = 0; i < derived.size(); ++i) {
    const oracle::Crossing& crossing = truth.listed[i];
    if (crossing.kind != derived[i].kind || !is_close(crossing.t, derived[i].t)) return false;
    if (!is_close(crossing.t_last, derived[i].t_last)) return false;
  }
  return true;
}

template <class N>
bool rounded_right_in(const Case& question, const oracle::Truth& truth, const Crossings& derived) {
  for (std::size_t i = 0; i < derived.size(); ++i) {
    const oracle::Crossing& crossing = truth.listed[i];
    if (!is_nearest(oracle::rounded<N>(question, crossing), derived[i].t)) return false;
    if (!is_nearest(oracle::rounded_last<N>(question, crossing), derived[i].t_last)) return false;
  }
  return true;
}

inline bool rounded_right(const Case& question, const oracle::Truth& truth,
                          const Crossings& derived) {
  return rounded_right_in<float>(question, truth, derived) &&
         rounded_right_in<double>(question, truth, derived) &&
         rounded_right_in<long double>(question, truth, derived);
}

/// The same case on a range of its own: its ends lie at crossings of the whole line, exactly where
/// those are doubles, beside them, between them, anywhere.
inline Case with_range(Case question, std::mt19937_64& engine) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const Ray<double> given = question.ray;
  question.ray.t_min = -infinity;
  question.ray.t_max = infinity;
  std::vector<double> ends = {-infinity, infinity, 0, given.t_min, given.t_max};
  const oracle::Truth truth = oracle::truth(question);
  for (const oracle::Crossing& crossing : truth.crossings())
    for (const double t : {nearest<double>(crossing.t), nearest<double>(crossing.t_last)})
      for (const double end :
           {t, t, t, std::nextafter(t, -infinity), std::nextafter(t, infinity), t / 2, 2 * t, -t})
        ends.push_back(end);
  const auto pick = [&] { return ends[engine() % ends.size()]; };
  const double one = pick(), other = pick();
  if (one == other) return {given, question.shape};
  question.ray.t_min = std::min(one, other);
  question.ray.t_max = std::max(one, other);
  return question;
}

inline constexpr std::size_t capped_cylinder = 4, capped_cone = 5;
/// The open shape of which the cases of a shape are made.
constexpr std::size_t drawn_as(std::size_t shape) {
  return shape < capped_cylinder ? shape : shape - 2;
}

/// A small whole number.
inline double whole(std::mt19937_64& engine) { return static_cast<double>(engine() % 13) - 6; }
inline Vec3<double> whole_vector(std::mt19937_64& engine) {
  const double x = whole(engine), y = whole(engine), z = whole(engine);
  return {x, y, z};
}

/// A ray through the edge of a closed shape of small whole numbers, exactly: from outside in, out,
/// past it, along it or in the plane of its cap.
inline Case at_edge(bool cone, std::mt19937_64& engine) {
  struct Frame {
    Vec3<double> axis, across;
    double radius;
  };
  // The axis is orthogonal to the way across, whose length is whole.
  static const Frame frames[] = {{{0, 0, 2}, {3, 4, 0}, 5},
                                 {{1, -2, 2}, {2, 2, 1}, 3},
                                 {{2, 6, -3}, {6, -3, -2}, 7},
                                 {{0, 5, 0}, {4, 0, -3}, 5}};
  const auto& [axis, across, radius] = frames[engine() % std::size(frames)];
  const Vec3<double> base = whole_vector(engine), top = base + axis;
  const bool upper = !cone && engine() % 2 == 0;
  const Vec3<double> edge = (upper ? top : base) + across;
  const Vec3<double> along = cross(axis, across);
  const double kind = whole(engine);
  Vec3<double> d = kind < -2  ? whole_vector(engine)
                   : kind < 0 ? whole(engine) * across + whole(engine) * along
                   : kind < 2 ? whole(engine) * axis + whole(engine) * along
                              : whole(engine) * axis + whole(engine) * across;
  if (d == Vec3<double>{0, 0, 0}) d = axis;
  const Ray<double> ray = {edge - whole(engine) * d, d};
  if (cone) return {ray, CappedCone<double>{base, top, radius}};
  return {ray, CappedCylinder<double>{base, top, radius}};
}

/// The first cases of each family that draws the shape, in both formats, so many in all; every
/// third on a range of its own. Calls visit(family, question). Cases of closed shapes are those of
/// the open ones, and rays by their edges.
template <class V>
void each_case(std::size_t shape, std::size_t count, V&& visit) {
  const auto each = [&](auto&& draw_from) {
    each_drawing([&](const Family& family, std::size_t drawn_shape, const Format& format) {
      if (drawn_shape == drawn_as(shape) && family.id != "invalid") draw_from(family, format);
    });
  };
  std::size_t drawings = 0;
  each([&](const Family&, const Format&) { ++drawings; });
  const std::size_t share = (count + drawings - 1) / drawings;
  std::mt19937_64 engine(shape);
  const auto see = [&](std::string_view id, const Case& question) {
    visit(id, engine() % 3 == 0 ? with_range(question, engine) : question);
  };
  each([&](const Family& family, const Format& format) {
    for (Case question : drawn(family, drawn_as(shape), format, {}, 0, share)) {
      if (shape >= capped_cylinder) question.shape = closed(question.shape);
      see(family.id, question);
    }
  });
  if (shape < capped_cylinder) return;
  for (std::size_t i = 0; i < count / 4; ++i) see("edge", at_edge(shape == capped_cone, engine));
}

/// Holds the oracle's truth of so many cases of the shape, from every family, against the
/// derivation, and the rounded t of every fourth. Each of the kinds must have been met.
inline void hold(std::size_t shape, std::size_t count, Derivation derive,
                 std::initializer_list<oracle::Kind> kinds) {
  count /= one_in;
  std::size_t held = 0, wrong = 0;
  std::array<std::size_t, 7> seen = {};
  each_case(shape, count, [&](std::string_view id, const Case& question) {
    const oracle::Truth truth = oracle::truth(question);
    const Crossings derived = derive(question);
    const bool right = agree(truth, derived);
    const bool rounds = !right || held % 4 != 0 || rounded_right(question, truth, derived);
    for (const Crossing& crossing : derived) ++seen[static_cast<std::size_t>(crossing.kind)];
    ++held;
    if (right && rounds) return;
    if (++wrong <= 5)
      BOOST_ERROR(id << ": " << case_line(question) << "\n  oracle " << words(truth)
                     << (right ? " rounded wrong" : "") << "\n  derived " << words(derived));
  });
  BOOST_TEST(wrong == 0u);
  BOOST_TEST(held >= count);
  for (const oracle::Kind kind : kinds)
    BOOST_TEST(seen[static_cast<std::size_t>(kind)] > count / 200, name(kind));
}

}  // namespace rayaudit::second
