#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"
#include "oracle/stages.hpp"
#include "oracle/stretch.hpp"

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

Radical end_of(const Range<Exact>& range, bool first) {
  if (first) return range.has_start ? ratio(range.start, 1) : Radical{.infinite = -1};
  return range.has_end ? ratio(range.end, 1) : Radical{.infinite = 1};
}

/// An end of a stretch within a patch.
template <class S, class P>
Radical root(const P& patch, const Outline& outline, const StretchEnd& end) {
  if constexpr (caps<S> != 0)
    if (outline.patch != 0) return quadratic_root(edge_of_cap(patch.field), end.which);
  return root(patch.side[end.side], end.which);
}

template <template <class> class S>
ExactRoots roots_of(const Ray<double>& ray, const S<double>& shape, Extent extent, bool all) {
  const auto patch = along_ray<Exact>(ray, shape);
  const Range<Exact> range(ray);
  Signs<Exact> sign;
  const Outline outline = settle<S<double>>(patch, range, sign, extent, all);
  ExactRoots found;
  found.constant = outline.within || is_constant(patch.field, sign);
  if (outline.within) {
    const Stretch stretch = stretch_of<S<double>>(patch, outline, range, sign, extent);
    const auto of = [&](const StretchEnd& end, bool first) {
      return end.side < 0 ? end_of(range, first) : root<S<double>>(patch, outline, end);
    };
    if (!stretch.empty && !all)
      found.listed[found.count++] = {{.kind = Kind::within, .patch = outline.patch},
                                     of(stretch.first, true),
                                     of(stretch.last, false)};
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
    return settle<std::remove_cvref_t<decltype(shape)>>(along_ray<Exact>(question.ray, shape),
                                                        Range<Exact>(question.ray), sign,
                                                        question.extent, false);
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
