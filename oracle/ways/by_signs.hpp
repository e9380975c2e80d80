#pragma once

#include <CGAL/number_utils.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>

#include "oracle/environment.hpp"
#include "oracle/prepared.hpp"
#include "oracle/settle.hpp"
#include "oracle/ways.hpp"

/// A case answered in any exact number N by signs alone: first which root is hit, then between
/// which doubles it lies.
namespace rayaudit::oracle {

/// Answers every case: answer(question, t_exponent) the valid ones, whose t counts in units of
/// 2^t_exponent; the others are misses.
template <class A>
void answer_each(std::span<const Case> cases, std::span<Answer> answers, A&& answer) {
  require_plain_arithmetic();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool moderate = is_moderate(cases[i]);
    if (invalid(cases[i], moderate) != Invalid::no) {
      answers[i] = Answer::miss();
    } else if (moderate) {
      answers[i] = answer(cases[i], 0);
    } else {
      const Scaled scale = scaled(cases[i]);
      answers[i] = answer(scale.question, scale.t_exponent());
    }
  }
}

/// 2^exponent in N, which needs no exponents beyond those of double.
template <class N>
N power_of_two(int exponent) {
  N power(1);
  for (; exponent > 1000; exponent -= 1000) power = power * N(0x1p1000);
  for (; exponent < -1000; exponent += 1000) power = power * N(0x1p-1000);
  return power * N(std::ldexp(1.0, exponent));
}

/// The doubles in their order: 0 is the 0th, and an infinity follows the largest.
inline std::int64_t place(double x) {
  const auto size = std::bit_cast<std::int64_t>(std::fabs(x));
  return x < 0 ? -size : size;
}
inline double double_at(std::int64_t place) {
  return place < 0 ? -std::bit_cast<double>(-place) : std::bit_cast<double>(place);
}
constexpr auto infinite = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());

/// The first place that the root is not beyond, sought from a guess outwards. It is beyond what
/// comes before the infinities, and not beyond their last.
template <class B>
std::int64_t first_not_beyond(const B& is_beyond, std::int64_t guess) {
  constexpr std::int64_t far = std::int64_t{1} << 40;
  std::int64_t below = guess, above = guess, step = 1;
  if (is_beyond(guess))
    for (; is_beyond(above = step < far ? above + step : infinite); step *= 2) below = above;
  else
    for (; !is_beyond(below = step < far ? below - step : -infinite - 1); step *= 2) above = below;
  while (below + 1 < above) {
    const std::int64_t middle = std::midpoint(below, above);
    (is_beyond(middle) ? below : above) = middle;
  }
  return above;
}

/// How t is had from a root by signs: t = root 2^exponent, found from a guess. The root tells by
/// the sign of at(g) what side of the root of g it lies on.

/// The double nearest to t, ties to even; from 2^1024 - 2^970 on infinite. The better the guess,
/// the fewer signs it takes; two at least, which are hard ones.
struct Nearest {
  template <class N, class Root>
  double operator()(const Root& root, double guess, const N& unit) const {
    const auto number = [&](std::int64_t at) {
      if (at == infinite) return N(N(0x1p1023) + N(0x1p1023));
      if (at == -infinite) return N(N(-0x1p1023) - N(0x1p1023));
      return N(double_at(at));
    };
    // Does t round to a double behind this one?
    const auto is_beyond = [&](std::int64_t at) {
      if (at >= infinite || at < -infinite) return at < 0;
      const int side = root.at(Polynomial<N, 1>{{N(-(number(at) + number(at + 1))), twice(unit)}});
      return side > 0 || (side == 0 && at % 2 != 0);
    };
    return double_at(first_not_beyond(is_beyond, std::isnan(guess) ? 0 : place(guess)));
  }
};

/// The guess, if it is within 2^-40 |t|, as two signs tell that are mostly easy; else the nearest.
struct Near {
  template <class N, class Root>
  double operator()(const Root& root, double guess, const N& unit) const {
    const double slack = std::fabs(guess) * 0x1p-41;
    const auto side_of = [&](double t) { return root.at(Polynomial<N, 1>{{N(-t), unit}}); };
    const bool near = std::isfinite(guess + slack) && std::isfinite(guess - slack) &&
                      side_of(guess - slack) >= 0 && side_of(guess + slack) <= 0;
    return near ? guess : Nearest{}(root, guess, unit);
  }
};

/// About the root of a linear field.
template <class N>
double guess_of(const Polynomial<N, 1>& f, Which) {
  return -CGAL::to_double(f.c[0]) / CGAL::to_double(f.c[1]);
}
/// About a root of a quadratic field: with m = -(B + sign(B) sqrt(D)), D exact, the roots are m /
/// 2A and 2C / m.
template <class N>
double guess_of(const Polynomial<N, 2>& f, Which which) {
  const double c = CGAL::to_double(f.c[0]), b = CGAL::to_double(f.c[1]),
               a = CGAL::to_double(f.c[2]);
  const N d = squared(f.c[1]) - twice(twice(N(f.c[2] * f.c[0])));
  const double m = -(b + std::copysign(std::sqrt(CGAL::to_double(d)), b));
  const bool by_a = which == Which::twofold || (which == Which::smaller) == ((b >= 0) == (a > 0));
  return by_a ? m / (2 * a) : 2 * c / m;
}

/// Calls visit(root, guess) with a root of a field.
template <class N, int degree, class V>
auto with_root_of(const Polynomial<N, degree>& field, Which which, Signs<N>& sign, V&& visit) {
  if constexpr (degree == 2)
    if (which != Which::linear)
      return visit(QuadraticRoot<N>{field, sign(field.c[2]), which, sign}, guess_of(field, which));
  const Polynomial<N, 1> linear = {{field.c[0], field.c[1]}};
  return visit(LinearRoot<N>{field.c[0], field.c[1], sign(field.c[1]), sign},
               guess_of(linear, which));
}

/// The same with the root of a patch that an outline lists.
template <class S, class N, class P, class V>
auto with_root(const P& patch, const Outlined& root, Signs<N>& sign, V&& visit) {
  if constexpr (caps<S> != 0)
    if (root.patch != 0)
      return with_root_of(cap_field(patch, cap_of(root)), root.which, sign, visit);
  return with_root_of(patch.field, root.which, sign, visit);
}

/// The answer to a valid case.
template <class N, template <class> class S, class T>
Answer answer_in(const Ray<double>& ray, const S<double>& shape, Extent extent, int t_exponent,
                 const T& t_of) {
  const auto patch = along_ray<N>(ray, shape);
  Signs<N> sign;
  const Outline outline = settle<S<double>>(patch, Range<N>(ray), sign, extent, false);
  const Outlined* hit = outline.proper_hit();
  if (hit == nullptr) return Answer::miss();
  const auto t = [&](const auto& root, double guess) {
    return t_of(root, std::ldexp(guess, t_exponent), power_of_two<N>(t_exponent));
  };
  return Answer::hit(real(with_root<S<double>>(patch, *hit, sign, t)));
}

/// Answers every case in N by signs, t by one of the ways above.
template <class N, class T>
void answer_by_signs(std::span<const Case> cases, std::span<Answer> answers, const T& t_of) {
  answer_each(cases, answers, [&](const Case& question, int t_exponent) {
    return std::visit(
        [&](const auto& shape) {
          return answer_in<N>(question.ray, shape, question.extent, t_exponent, t_of);
        },
        question.shape);
  });
}

}  // namespace rayaudit::oracle
