#pragma once

#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/cone_nappe.hpp"
#include "routines/convex_solid.hpp"
#include "routines/first_root.hpp"
#include "routines/stable_roots.hpp"

namespace rayaudit {

/// The quadratic of the shape with its roots by q = -(b + sign(b) sqrt(D)) / 2, which do not
/// cancel. The coefficients of cylinder and cone are told by cross products, |v x w|^2 for |v|^2
/// |w|^2 - (v.w)^2, so that a long thin shape and a ray almost along the axis keep their digits. A
/// closed shape is met as a convex solid.
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
    const Vec3<N> v = ray.origin - cylinder.base, w = cylinder.top - cylinder.base;
    const std::optional<Roots<N>> roots = stable_roots(cylindric(ray, v, w, cylinder.radius));
    if (!roots) return {};
    const N from = dot(v, w), slope = dot(ray.direction, w), full = dot(w, w);
    return first_root(ray, *roots, [&](const N& t) {
      const N height = from + t * slope;
      return N(0) <= height && height <= full;
    });
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const Vec3<N> v = ray.origin - cone.apex, w = cone.base - cone.apex;
    const Quadratic<N> lateral = conic(ray, v, w, cone.radius);
    const std::optional<Roots<N>> roots = stable_roots(lateral);
    if (!roots) return {};
    const Depth<N> depth = {dot(v, w), dot(ray.direction, w), dot(w, w)};
    return first_on_nappe(lateral.a, *roots, depth, [&](const N& t) { return in_range(ray, t); });
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const CappedCylinder<N>& shape) const {
    const Vec3<N> v = ray.origin - shape.base, w = shape.top - shape.base;
    const N slope = dot(ray.direction, w);
    return first_root(ray,
                      span_in_cylinder<N>(cylindric(ray, v, w, shape.radius), {-dot(v, w), -slope},
                                          {dot(ray.origin - shape.top, w), slope}));
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const CappedCone<N>& shape) const {
    const Vec3<N> v = ray.origin - shape.apex, w = shape.base - shape.apex;
    const Vec3<N> dxw = cross(ray.direction, w), vxw = cross(v, w);
    const N slope = dot(ray.direction, w);
    const N deep = dot(v, w) * dot(dxw, dxw) - dot(vxw, dxw) * slope;
    return first_root(ray, span_in_cone<N>(conic(ray, v, w, shape.radius), deep,
                                           {dot(ray.origin - shape.base, w), slope}));
  }

 private:
  template <class N>
  static Quadratic<N> with_discriminant(const N& a, const N& b, const N& c) {
    return {a, b, c, b * b - N(4) * a * c};
  }

  template <class N>
  static Quadratic<N> cylindric(const Ray<N>& ray, const Vec3<N>& v, const Vec3<N>& w,
                                const N& radius) {
    const Vec3<N> dxw = cross(ray.direction, w), vxw = cross(v, w);
    return with_discriminant<N>(dot(dxw, dxw), N(2) * dot(vxw, dxw),
                                dot(vxw, vxw) - radius * radius * dot(w, w));
  }

  /// Seen from the apex, with w pointing to the base, the cone is |w|^2 |v x w|^2 = r^2 (v.w)^2.
  template <class N>
  static Quadratic<N> conic(const Ray<N>& ray, const Vec3<N>& v, const Vec3<N>& w,
                            const N& radius) {
    const Vec3<N> dxw = cross(ray.direction, w), vxw = cross(v, w);
    const N rr = radius * radius, ww = dot(w, w);
    const N vw = dot(v, w), dw = dot(ray.direction, w);
    return with_discriminant<N>(ww * dot(dxw, dxw) - rr * dw * dw,
                                N(2) * (ww * dot(vxw, dxw) - rr * vw * dw),
                                ww * dot(vxw, vxw) - rr * vw * vw);
  }
};

}  // namespace rayaudit
