#pragma once

#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/cone_nappe.hpp"
#include "routines/first_root.hpp"
#include "routines/nearby.hpp"
#include "routines/stable_roots.hpp"

namespace rayaudit {

/// The discriminant from how near the line comes, r^2 - |perpendicular|^2, and not from b^2 - 4ac,
/// which loses the radius at a distance: Hearn & Baker, "Computer Graphics with OpenGL", and
/// Haines, Günther & Akenine-Möller, "Precision Improvements for Ray/Sphere Intersection", Ray
/// Tracing Gems, ch. 7, here for a direction of any length; for the cylinder, the distance between
/// line and axis as in Cychosz & Waggenspack, "Intersecting a Ray with a Cylinder", Graphics Gems
/// IV. Added to them: shape and ray are first brought near each other and to a size near 1.
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

  /// With m = d x w, the line passes the axis at the distance |f.m| / |m|.
  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    Nearby<N> line(ray, cylinder.base, cylinder.radius);
    const Axis<N> axis(cylinder.base, cylinder.top, line.length);
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const N rr = line.radius * line.radius, ww = dot(w, w);
    line.come_within(N(4) * (rr + ww * axis.length * axis.length));
    const Vec3<N> m = cross(d, w), fxw = cross(f, w);
    const N a = dot(m, m), fm = dot(f, m);
    if (a == N(0)) return {};
    const N gap = rr - fm * fm / a;
    const std::optional<Roots<N>> roots =
        stable_roots<N>(a, N(2) * dot(fxw, m), dot(fxw, fxw) - rr * ww, N(4) * ww * a * gap);
    if (!roots) return {};
    const N from = dot(f, w), slope = dot(d, w), full = ww * axis.length;
    const std::optional<N> t = first_root(*roots, [&](const N& root) {
      const N height = from + root * slope;
      return N(0) <= height && height <= full && in_range(ray, line.home(root));
    });
    if (!t) return {};
    return line.home(*t);
  }

  /// Seen from the apex, with w pointing to the base, b^2 - 4ac is 4 |w|^4 (r^2 |k x w|^2 -
  /// |w|^2 (k.w)^2), where k = f x d is the moment of the line about the apex (Lagrange's
  /// identity): |k.w| / |d x w| is its distance from the axis, and a line through the apex has k =
  /// 0.
  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    Nearby<N> line(ray, cone.apex, cone.radius);
    const Axis<N> axis(cone.apex, cone.base, line.length);
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const N ww = dot(w, w);
    line.come_within(N(4) * (line.radius * line.radius + ww * axis.length * axis.length));
    const N r = line.radius / axis.length, rr = r * r;
    const Vec3<N> dxw = cross(d, w), fxw = cross(f, w), k = cross(f, d), kxw = cross(k, w);
    const N dw = dot(d, w), fw = dot(f, w), kw = dot(k, w);
    const N a = ww * dot(dxw, dxw) - rr * dw * dw;
    const N b = N(2) * (ww * dot(fxw, dxw) - rr * fw * dw);
    const N c = ww * dot(fxw, fxw) - rr * fw * fw;
    const N gap = rr * dot(kxw, kxw) - ww * kw * kw;
    const std::optional<Roots<N>> roots = stable_roots<N>(a, b, c, N(4) * ww * ww * gap);
    if (!roots) return {};
    const Depth<N> depth = {fw, dw, ww * axis.length};
    const std::optional<N> t = first_on_nappe(
        a, *roots, depth, [&](const N& root) { return in_range(ray, line.home(root)); });
    if (!t) return {};
    return line.home(*t);
  }
};

}  // namespace rayaudit
