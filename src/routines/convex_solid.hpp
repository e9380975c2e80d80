#pragma once

#include <optional>

#include "routines/first_root.hpp"
#include "routines/stable_roots.hpp"

/// Where a line is inside a convex solid: it enters at the last of the parameters at which it
/// enters one of the parts that bound the solid, and leaves at the first at which it leaves one
/// (Cyrus & Beck, "Generalized Two- and Three-Dimensional Clipping", 1978; Kay & Kajiya, "Ray
/// Tracing Complex Scenes", 1986). No point is tested against a rim, so no ray slips through
/// between a cap and the lateral surface.
namespace rayaudit {

/// The stretch of a line that is inside.
template <class N>
struct Span {
  N enter, leave;
};

/// The side of a plane where above + t slope <= 0.
template <class N>
struct HalfSpace {
  N above, slope;

  N border() const { return -above / slope; }
};

template <class N>
std::optional<Span<N>> unless_empty(const Span<N>& span) {
  if (span.enter <= span.leave) return span;
  return {};
}

/// What of the span lies in the half-space.
template <class N>
std::optional<Span<N>> cut(Span<N> span, const HalfSpace<N>& half) {
  if (half.slope == N(0)) {
    if (half.above <= N(0)) return span;
    return {};
  }
  const N border = half.border();
  if (half.slope < N(0) && span.enter < border) span.enter = border;
  if (half.slope > N(0) && border < span.leave) span.leave = border;
  return unless_empty(span);
}

/// The first end of the span in the range of the ray: from inside, where it leaves.
template <class N>
std::optional<N> first_root(const Ray<N>& ray, const std::optional<Span<N>>& span) {
  if (!span) return {};
  return first_root(ray, Roots<N>{span->enter, span->leave});
}

/// From the smaller root to the larger.
template <class N>
Span<N> between(const Roots<N>& roots) {
  if (roots.one < roots.other) return {roots.one, roots.other};
  return {roots.other, roots.one};
}

/// The line inside a solid cylinder, whose endless one holds it where a t^2 + b t + c <= 0. A line
/// along the axis meets the caps alone.
template <class N>
std::optional<Span<N>> span_in_cylinder(const Quadratic<N>& lateral, const HalfSpace<N>& over_base,
                                        const HalfSpace<N>& under_top) {
  if (lateral.a == N(0)) {
    if (lateral.c > N(0) || under_top.slope == N(0)) return {};
    return between(Roots<N>{over_base.border(), under_top.border()});
  }
  const std::optional<Roots<N>> roots = stable_roots(lateral);
  if (!roots) return {};
  const std::optional<Span<N>> span = cut(between(*roots), over_base);
  if (!span) return {};
  return cut(*span, under_top);
}

/// The line inside a solid cone, whose two nappes hold it where a t^2 + b t + c <= 0; deep has the
/// sign of the depth below the apex at the line's point nearest to the axis.
///
/// Where a > 0 both roots lie on one nappe, and that point between them tells which: 2 a z - b z' =
/// 2 |w|^2 deep, for a depth z + t z', does not know the radius. Elsewhere each nappe is met once,
/// ours by the root that is nearer to the base, and what is inside ends at the base alone; along a
/// generator, where a = 0, there is but one root, ours if the line then runs on towards the base.
template <class N>
std::optional<Span<N>> span_in_cone(const Quadratic<N>& lateral, const N& deep,
                                    const HalfSpace<N>& over_base) {
  const std::optional<Roots<N>> roots = stable_roots(lateral);
  if (!roots) return {};
  const Span<N> both = between(*roots);
  if (lateral.a > N(0)) {
    if (!(deep > N(0))) return {};
    return cut(both, over_base);
  }
  const bool to_base = over_base.slope > N(0);
  if (lateral.a == N(0) && (lateral.b < N(0)) != to_base) return {};
  const N base = over_base.border();
  return unless_empty(to_base ? Span<N>{both.leave, base} : Span<N>{base, both.enter});
}

}  // namespace rayaudit
