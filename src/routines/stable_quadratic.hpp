#pragma once

#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/cone_nappe.hpp"
#include "routines/first_root.hpp"
#include "routines/stable_roots.hpp"

namespace rayaudit {

/// The quadratic of the shape with its roots by q = -(b + sign(b) sqrt(D)) / 2, which do not
/// cancel. The coefficients of cylinder and cone are told by cross products, |v x w|^2 for |v|^2
/// |w|^2 - (v.w)^2, so that a long thin shape and a ray almost along the axis keep their digits.
struct StableQuadratic {
  static constexpr std::string_view name = "stable_quadratic";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Vec3<N>& d = ray.direction;
    const Vec3<N> v = ray.origin - sphere.centre;
    const N a = dot(d, d);
    const N b = N(2) * dot(v, d);
    const N c = dot(v, v) - sphere.radius * sphere.radius;
    const std::optional<Roots<N>> roots = stable_roots<N>(a, b, c, b * b - N(4) * a * c);
    if (!roots) return {};
    return first_root(ray, *roots);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const Vec3<N> v = ray.origin - cylinder.base;
    const Vec3<N> w = cylinder.top - cylinder.base;
    const Vec3<N> dxw = cross(ray.direction, w), vxw = cross(v, w);
    const N ww = dot(w, w);
    const N a = dot(dxw, dxw);
    const N b = N(2) * dot(vxw, dxw);
    const N c = dot(vxw, vxw) - cylinder.radius * cylinder.radius * ww;
    const std::optional<Roots<N>> roots = stable_roots<N>(a, b, c, b * b - N(4) * a * c);
    if (!roots) return {};
    const N from = dot(v, w), slope = dot(ray.direction, w);
    return first_root(ray, *roots, [&](const N& t) {
      const N height = from + t * slope;
      return N(0) <= height && height <= ww;
    });
  }

  /// Seen from the apex, with w pointing to the base, the cone is |w|^2 |v x w|^2 = r^2 (v.w)^2.
  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const Vec3<N> v = ray.origin - cone.apex;
    const Vec3<N> w = cone.base - cone.apex;
    const Vec3<N> dxw = cross(ray.direction, w), vxw = cross(v, w);
    const N rr = cone.radius * cone.radius, ww = dot(w, w);
    const N vw = dot(v, w), dw = dot(ray.direction, w);
    const N a = ww * dot(dxw, dxw) - rr * dw * dw;
    const N b = N(2) * (ww * dot(vxw, dxw) - rr * vw * dw);
    const N c = ww * dot(vxw, vxw) - rr * vw * vw;
    const std::optional<Roots<N>> roots = stable_roots<N>(a, b, c, b * b - N(4) * a * c);
    if (!roots) return {};
    return first_on_nappe(a, *roots, {vw, dw, ww}, [&](const N& t) { return in_range(ray, t); });
  }
};

}  // namespace rayaudit
