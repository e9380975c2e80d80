#include <algorithm>

#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"
#include "oracle/stages.hpp"

namespace rayaudit::oracle {
namespace {

using Exact = CGAL::Mpzf;

}  // namespace

template <>
inline Exact squared(const Exact& x) {
  return CGAL::square(x);
}

template <>
struct Signs<Exact> {
  bool unsure = false;

  int operator()(const Exact& x) const { return x.sign(); }
};

namespace {

Radical ratio(const Exact& numerator, const Exact& denominator) {
  return {.p = numerator, .q = denominator};
}

Radical linear_root(const Polynomial<Exact, 1>& f) { return ratio(-f.c[0], f.c[1]); }

/// The root of a quadratic that has it.
Radical quadratic_root(const Polynomial<Exact, 2>& f, Which which) {
  const auto& [c, b, a] = f.c;
  if (which == Which::twofold) return ratio(-b, twice(a));
  const int sign_a = a.sign();
  return {.p = -b,
          .d = squared(b) - twice(twice(a * c)),
          .q = twice(a),
          .e = which == Which::smaller ? -sign_a : sign_a};
}

template <int degree>
Radical root(const Polynomial<Exact, degree>& field, Which which) {
  if constexpr (degree == 2)
    if (which != Which::linear) return quadratic_root(field, which);
  return linear_root({{field.c[0], field.c[1]}});
}

/// The root that an outline lists.
template <class S, class P>
Radical root(const P& patch, const Outlined& outlined) {
  if constexpr (caps<S> != 0)
    if (outlined.patch != 0) return linear_root(cap_field(patch, cap_of(outlined)));
  return root(patch.field, outlined.which);
}

/// A stretch of the line, from first to last; empty until it is known not to be.
struct Stretch {
  bool empty = true;
  Radical first, last;
};

Radical start_of(const Range<Exact>& range) {
  return range.has_start ? ratio(range.start, 1) : Radical{.infinite = -1};
}
Radical end_of(const Range<Exact>& range) {
  return range.has_end ? ratio(range.end, 1) : Radical{.infinite = 1};
}

/// The order of two ratios with positive denominators.
bool less(const Radical& a, const Radical& b) { return (a.p * b.q - b.p * a.q).sign() < 0; }

/// The part of the range where all of these linear side conditions hold that count.
template <class S, std::size_t sides>
Stretch stretch(const std::array<Polynomial<Exact, 1>, sides>& side, const Range<Exact>& range,
                Extent extent) {
  bool has_first = range.has_start, has_last = range.has_end;
  Radical first = start_of(range), last = end_of(range);
  for (int i = 0; i < static_cast<int>(sides); ++i) {
    if (!counts<S>(i, extent)) continue;
    const auto& g = side[i];
    const int slope = g.c[1].sign();
    if (slope == 0 && g.c[0].sign() < 0) return {};
    if (slope > 0) {
      const Radical from = ratio(-g.c[0], g.c[1]);
      if (!has_first || less(first, from)) first = from;
      has_first = true;
    } else if (slope < 0) {
      const Radical to = ratio(g.c[0], -g.c[1]);
      if (!has_last || less(to, last)) last = to;
      has_last = true;
    }
  }
  return {.empty = has_first && has_last && less(last, first), .first = first, .last = last};
}

/// The part of the range where a quadratic side condition holds that opens downward.
Stretch stretch(const Polynomial<Exact, 2>& g, const Range<Exact>& range) {
  Signs<Exact> sign;
  const int sign_d = (squared(g.c[1]) - twice(twice(g.c[2] * g.c[0]))).sign();
  if (sign_d < 0) return {};
  const auto at = [&](Which which, const Exact& t) {
    return QuadraticRoot<Exact>{g, -1, which, sign}.at(Polynomial<Exact, 1>{{-t, 1}});
  };
  const Which smaller = sign_d == 0 ? Which::twofold : Which::smaller;
  const Which larger = sign_d == 0 ? Which::twofold : Which::larger;
  if (range.has_start && at(larger, range.start) < 0) return {};
  if (range.has_end && at(smaller, range.end) > 0) return {};
  const bool starts_inside = range.has_start && at(smaller, range.start) < 0;
  const bool ends_inside = range.has_end && at(larger, range.end) > 0;
  return {.empty = false,
          .first = starts_inside ? ratio(range.start, 1) : quadratic_root(g, smaller),
          .last = ends_inside ? ratio(range.end, 1) : quadratic_root(g, larger)};
}

template <class S>
Stretch stretch(const std::array<Polynomial<Exact, 2>, 1>& side, const Range<Exact>& range,
                Extent extent) {
  if (counts<S>(0, extent)) return stretch(side[0], range);
  return {.empty = false, .first = start_of(range), .last = end_of(range)};
}

/// The part of the range where a line lies in a patch.
template <class S, class P>
Stretch stretch(const P& patch, const Outline& outline, const Range<Exact>& range, Extent extent) {
  if constexpr (caps<S> != 0) {
    const auto& [c, b, a] = patch.field.c;
    if (outline.patch != 0) return stretch(Polynomial<Exact, 2>{{-c, -b, -a}}, range);
  }
  return stretch<S>(patch.side, range, extent);
}

template <template <class> class S>
ExactRoots roots_of(const Ray<double>& ray, const S<double>& shape, Extent extent, bool all) {
  const auto patch = along_ray<Exact>(ray, shape);
  const Range<Exact> range(ray);
  Signs<Exact> sign;
  const Outline outline = settle<S<double>, Exact>(patch, range, sign, extent, all);
  ExactRoots found;
  const auto vanishes = [](const Exact& x) { return x.sign() == 0; };
  found.constant =
      outline.within || std::all_of(patch.field.c.begin() + 1, patch.field.c.end(), vanishes);
  if (outline.within) {
    const Stretch inside = stretch<S<double>>(patch, outline, range, extent);
    if (!inside.empty && !all)
      found.listed[found.count++] = {
          {.kind = Kind::within, .patch = outline.patch}, inside.first, inside.last};
    return found;
  }
  for (const Outlined& outlined : std::span(outline.listed.data(), outline.count)) {
    if (!all && outlined.standing != Standing::acceptable) continue;
    const Radical t = outlined.kind == Kind::start ? ratio(range.start, 1)
                      : outlined.kind == Kind::end ? ratio(range.end, 1)
                                                   : root<S<double>>(patch, outlined);
    found.listed[found.count++] = {outlined, t, {}};
  }
  return found;
}

}  // namespace

Outline outline_exactly(const Case& question) {
  const auto outline = [&](const auto& shape) {
    Signs<Exact> sign;
    return settle<std::remove_cvref_t<decltype(shape)>, Exact>(
        along_ray<Exact>(question.ray, shape), Range<Exact>(question.ray), sign, question.extent,
        false);
  };
  return std::visit(outline, question.shape);
}

ExactRoots exact_roots(const Case& question, bool all) {
  const Scaled scale = is_moderate(question) ? Scaled{question} : scaled(question);
  const auto settled = [&](const auto& shape) {
    return roots_of(scale.question.ray, shape, question.extent, all);
  };
  ExactRoots found = std::visit(settled, scale.question.shape);
  for (ExactRoot& root : std::span(found.listed.data(), found.count)) {
    root.t.exponent = root.t_last.exponent = scale.t_exponent();
    if (root.outlined.kind != Kind::within) root.t_last = root.t;
  }
  return found;
}

}  // namespace rayaudit::oracle
