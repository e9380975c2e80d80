#pragma once

#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/cone_nappe.hpp"
#include "routines/convex_solid.hpp"
#include "routines/first_root.hpp"
#include "routines/nearby.hpp"
#include "routines/stable_roots.hpp"

namespace rayaudit {

/// The discriminant from how near the line comes, r^2 - |perpendicular|^2, and not from b^2 - 4ac,
/// which loses the radius at a distance: Hearn & Baker, "Computer Graphics with OpenGL", and
/// Haines, Günther & Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray
/// Tracing Gems, ch. 7, here for a direction of any length; for the cylinder, the distance between
/// line and axis as in Cychosz & Waggenspack, "Intersecting a Ray with a Cylinder", Graphics Gems
/// IV. Added to them: shape and ray are first brought near each other and to a size near 1. A
/// closed shape is met as a convex solid.
struct ClosestApproach {
  static constexpr std::string_view name = "closest_approach";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Nearby<N> line(ray, sphere.centre, sphere.radius);
    const Vec3<N>&f = line.from, &d = line.direction;
    const N a = dot(d, d), fd = dot(f, d), rr = line.radius * line.radius;
    const Vec3<N> perpendicular = f - (fd / a) * d;
    const N gap = rr - dot(perpendicular, perpendicular);
    const std::optional<Roots<N>> roots =
        stable_roots<N>(a, N(2) * fd, dot(f, f) - rr, N(4) * a * gap);
    if (!roots) return {};
    return first_root(ray, {line.home(roots->one), line.home(roots->other)});
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    Nearby<N> line(ray, cylinder.base, cylinder.radius);
    const Axis<N> axis(cylinder.base, cylinder.top, line.length);
    line.come_within(reach_squared(line, axis));
    const Quadratic<N> lateral = cylindric(line, axis.along);
    if (lateral.a == N(0)) return {};
    const std::optional<Roots<N>> roots = stable_roots(lateral);
    if (!roots) return {};
    const Vec3<N>& w = axis.along;
    const N from = dot(line.from, w), slope = dot(line.direction, w);
    const N full = dot(w, w) * axis.length;
    const std::optional<N> t = first_root(*roots, [&](const N& root) {
      const N height = from + root * slope;
      return N(0) <= height && height <= full && in_range(ray, line.home(root));
    });
    if (!t) return {};
    return line.home(*t);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    Nearby<N> line(ray, cone.apex, cone.radius);
    const Axis<N> axis(cone.apex, cone.base, line.length);
    line.come_within(reach_squared(line, axis));
    const Vec3<N>& w = axis.along;
    const Quadratic<N> lateral = conic(line, axis);
    const std::optional<Roots<N>> roots = stable_roots(lateral);
    if (!roots) return {};
    const Depth<N> depth = {dot(line.from, w), dot(line.direction, w), dot(w, w) * axis.length};
    const std::optional<N> t = first_on_nappe(
        lateral.a, *roots, depth, [&](const N& root) { return in_range(ray, line.home(root)); });
    if (!t) return {};
    return line.home(*t);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const CappedCylinder<N>& shape) const {
    Nearby<N> line(ray, shape.base, shape.radius);
    const Axis<N> axis(shape.base, shape.top, line.length);
    line.come_within(reach_squared(line, axis));
    const Vec3<N>& w = axis.along;
    const N slope = dot(line.direction, w);
    return first_at_home(ray, line,
                         span_in_cylinder<N>(cylindric(line, w), {-dot(line.from, w), -slope},
                                             {dot(line.from_point(ray, shape.top), w), slope}));
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const CappedCone<N>& shape) const {
    Nearby<N> line(ray, shape.apex, shape.radius);
    const Axis<N> axis(shape.apex, shape.base, line.length);
    line.come_within(reach_squared(line, axis));
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const Vec3<N> dxw = cross(d, w), fxw = cross(f, w);
    const N slope = dot(d, w), deep = dot(f, w) * dot(dxw, dxw) - dot(fxw, dxw) * slope;
    return first_at_home(ray, line,
                         span_in_cone<N>(conic(line, axis), deep,
                                         {dot(line.from_point(ray, shape.base), w), slope}));
  }

 private:
  /// Twice as far as any point of the shape is from the end that it is seen from, squared.
  template <class N>
  static N reach_squared(const Nearby<N>& line, const Axis<N>& axis) {
    const N rr = line.radius * line.radius, ww = dot(axis.along, axis.along);
    return N(4) * (rr + ww * axis.length * axis.length);
  }

  /// With m = d x w, the line passes the axis at the distance |f.m| / |m|.
  template <class N>
  static Quadratic<N> cylindric(const Nearby<N>& line, const Vec3<N>& w) {
    const Vec3<N>&f = line.from, &d = line.direction;
    const N rr = line.radius * line.radius, ww = dot(w, w);
    const Vec3<N> m = cross(d, w), fxw = cross(f, w);
    const N a = dot(m, m), fm = dot(f, m), c = dot(fxw, fxw) - rr * ww;
    if (a == N(0)) return {a, N(0), c, N(0)};
    const N gap = rr - fm * fm / a;
    return {a, N(2) * dot(fxw, m), c, N(4) * ww * a * gap};
  }

  /// Seen from the apex, with w pointing to the base, b^2 - 4ac is 4 |w|^4 (r^2 |k x w|^2 -
  /// |w|^2 (k.w)^2), where k = f x d is the moment of the line about the apex (Lagrange's
  /// identity): |k.w| / |d x w| is its distance from the axis, and a line through the apex has k =
  /// 0.
  template <class N>
  static Quadratic<N> conic(const Nearby<N>& line, const Axis<N>& axis) {
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const N ww = dot(w, w), r = line.radius / axis.length, rr = r * r;
    const Vec3<N> dxw = cross(d, w), fxw = cross(f, w), k = cross(f, d), kxw = cross(k, w);
    const N dw = dot(d, w), fw = dot(f, w), kw = dot(k, w);
    const N a = ww * dot(dxw, dxw) - rr * dw * dw;
    const N b = N(2) * (ww * dot(fxw, dxw) - rr * fw * dw);
    const N c = ww * dot(fxw, fxw) - rr * fw * fw;
    const N gap = rr * dot(kxw, kxw) - ww * kw * kw;
    return {a, b, c, N(4) * ww * ww * gap};
  }

  /// The first end of the span in the range of the ray: from inside, where it leaves.
  template <class N>
  static std::optional<N> first_at_home(const Ray<N>& ray, const Nearby<N>& line,
                                        const std::optional<Span<N>>& span) {
    if (!span) return {};
    return first_root(ray, Roots<N>{line.home(span->enter), line.home(span->leave)});
  }
};

}  // namespace rayaudit
