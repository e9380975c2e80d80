#include <algorithm>

#include "oracle/fused.hpp"
#include "oracle/stages.hpp"

namespace rayaudit::oracle {
namespace {

[[gnu::always_inline]] inline Bounded linear_root(const Bounded& c0, const Bounded& c1) {
  return -c0 / c1;
}

/// The roots of C + B t + A t^2, the smaller first, D > 0: with m = -(B + sign(B) sqrt(D)) they are
/// m / 2A and 2C / m, neither of which cancels.
[[gnu::always_inline]] inline Values quadratic_roots(const Polynomial<Bounded, 2>& f) {
  const auto& [c, b, a] = f.c;
  const Bounded root = sqrt(discriminant(f));
  const bool positive = b.high >= 0;
  const Bounded m = positive ? -(b + root) : root - b;
  const Bounded by_a = m / twice(a), by_c = twice(c) / m;
  const bool smaller_by_a = positive == (a.high > 0);
  return smaller_by_a ? Values{by_a, by_c} : Values{by_c, by_a};
}

template <int degree>
[[gnu::always_inline]] inline Values roots(const Polynomial<Bounded, degree>& field, Which first) {
  if constexpr (degree == 2) {
    if (first == Which::smaller || first == Which::larger) return quadratic_roots(field);
    if (first == Which::twofold) return {-field.c[1] / twice(field.c[2])};
  }
  return {linear_root(field.c[0], field.c[1])};
}

template <class S>
[[gnu::always_inline]] inline Values roots(const Ray<double>& ray, const S& shape,
                                           const Outline& outline) {
  const auto patch = along_ray<Bounded>(ray, shape);
  if constexpr (caps<S> == 0) {
    return roots(patch.field, outline.listed[0].which);
  } else {
    Values all = roots(patch.field, outline.lateral);
    for (int i = 0; i < static_cast<int>(patch.side.size()); ++i)
      if (is_cap<S>(i)) all[2 + i] = linear_root(patch.side[i].c[0], patch.side[i].c[1]);
    return all;
  }
}

[[gnu::always_inline]] inline bool is_crossing(const Outlined& root) {
  return root.standing == Standing::acceptable;
}

}  // namespace

void values_by_bounds(std::span<const Case* const> cases, std::span<const Outline> outlines,
                      std::span<Values> values) {
  run_fused([&]() __attribute__((always_inline)) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const std::span listed(outlines[i].listed.data(), outlines[i].count);
      if (std::none_of(listed.begin(), listed.end(), is_crossing)) continue;
      with_shape(
          cases[i]->shape, [&](const auto& shape) __attribute__((always_inline)) {
            values[i] = roots(cases[i]->ray, shape, outlines[i]);
          });
    }
  });
}

}  // namespace rayaudit::oracle
