#include "oracle/interval.hpp"

#include <algorithm>
#include <cmath>

#include "oracle/block.hpp"
#include "oracle/environment.hpp"
#include "oracle/fused.hpp"
#include "oracle/ways.hpp"

namespace rayaudit::oracle {

/// Plain doubles, that take their rounded signs for true.
template <>
struct Signs<double> {
  bool unsure = false;

  int operator()(double x) const { return (x > 0) - (x < 0); }
};

namespace {

/// The roots of C + B t + A t^2: with m = -(B + sign(B) sqrt(D)) they are m / 2A and 2C / m, where
/// nothing cancels. Of an interval B that holds both signs either will do.
template <class N>
N quadratic_root(const Polynomial<N, 2>& f, Which which, bool positive_a, bool positive_b) {
  using std::sqrt;
  const auto& [c, b, a] = f.c;
  if (which == Which::twofold) return -b / twice(a);
  const N root = sqrt(squared(b) - twice(twice(N(a * c))));
  const N m = positive_b ? -(b + root) : root - b;
  return (which == Which::smaller) == (positive_b == positive_a) ? m / twice(a) : twice(c) / m;
}

bool is_positive(double x) { return x >= 0; }
/// Is more of x positive than negative? What it decides is right either way.
bool is_positive(const Interval& x) { return x.sup() >= -x.inf(); }

template <class N, int degree>
N root(const Polynomial<N, degree>& field, Which which) {
  if constexpr (degree == 2)
    if (which != Which::linear)
      return quadratic_root(field, which, is_positive(field.c[2]), is_positive(field.c[1]));
  return -field.c[0] / field.c[1];
}

template <class S, class N, class P>
N root(const P& patch, const Outlined& listed) {
  if constexpr (caps<S> != 0)
    if (listed.patch != 0) return root(cap_field(patch, cap_of(listed)), listed.which);
  return root(patch.field, listed.which);
}

/// What a number says of a case: nothing sure, a miss, or a hit at t.
template <class N>
struct Said {
  bool unsure = false, hit = false;
  N t = 0;
};

template <class N, template <class> class S>
Said<N> said(const Ray<double>& ray, const S<double>& shape, Extent extent) {
  const auto patch = along_ray<N>(ray, shape);
  Signs<N> sign;
  const Outline outline = settle<S<double>>(patch, Range<N>(ray), sign, extent, false);
  if (outline.unsure) return {.unsure = true};
  const Outlined* hit = outline.proper_hit();
  if (hit == nullptr) return {};
  return {.hit = true, .t = root<S<double>, N>(patch, *hit)};
}

/// Alone under upward rounding, as the first stage of truth is: nothing in here but intervals, and
/// what leaves it leaves through memory.
[[gnu::noinline]] void say_rounding_upward(std::span<const Case* const> cases,
                                           std::span<Said<Interval>> all) {
  const Interval::Protector upward;
  for (std::size_t i = 0; i < cases.size(); ++i)
    with_shape(cases[i]->shape, [&](const auto& shape) {
      all[i] = said<Interval>(cases[i]->ray, shape, cases[i]->extent);
    });
}

/// Is every sign sure, and t known to 2^-8 of itself? Infinite ends compare false.
bool is_proved(const Said<Interval>& said) {
  const double low = said.t.inf(), high = said.t.sup();
  const double least = std::min(std::fabs(low), std::fabs(high));
  return !said.unsure && high - low <= least * 0x1p-8;
}

Answer answer(bool hit, double t, int t_exponent, std::uint8_t stage) {
  Answer said = hit ? Answer::hit(real(std::ldexp(t, t_exponent))) : Answer::miss();
  said.stage = stage;
  return said;
}

Answer guess(const Case& question, int t_exponent) {
  const auto guessed = [&](const auto& shape) {
    return said<double>(question.ray, shape, question.extent);
  };
  const Said<double> said = std::visit(guessed, question.shape);
  return answer(said.hit && !std::isnan(said.t), said.t, t_exponent, 2);
}

void answer_block(std::span<const Case> cases, std::span<Answer> answers) {
  Block in;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool moderate = is_moderate(cases[i]);
    answers[i] = Answer::miss();
    if (invalid(cases[i], moderate) == Invalid::no && !in.ask(cases[i], i, moderate))
      answers[i] = guess(cases[i], 0);
  }
  std::array<Said<Interval>, block> all;
  say_rounding_upward(in.cases(), all);
  for (std::size_t i = 0; i < in.count; ++i) {
    const auto& [unsure, hit, t] = all[i];
    const int exponent = in.t_exponent[i];
    answers[in.place[i]] = is_proved(all[i])
                               ? answer(hit, t.inf() + (t.sup() - t.inf()) / 2, exponent, 1)
                               : guess(*in.asked[i], exponent);
  }
}

}  // namespace

void answer_by_intervals(std::span<const Case> cases, std::span<Answer> answers) {
  require_plain_arithmetic();
  for (std::size_t i = 0; i < cases.size(); i += block) {
    const std::size_t size = std::min(block, cases.size() - i);
    answer_block(cases.subspan(i, size), answers.subspan(i, size));
  }
}

}  // namespace rayaudit::oracle
