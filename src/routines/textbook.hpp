#pragma once

#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/first_root.hpp"
#include "routines/quadratic_formula.hpp"

namespace rayaudit {

/// The point o + t d put into the field of the shape as it stands in the world, and the quadratic
/// formula: what a textbook prints (Glassner, ed., "An Introduction to Ray Tracing", 1989, ch. 2).
struct Textbook {
  static constexpr std::string_view name = "textbook";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    std::optional<N> t = on_plane(ray, disk);
    if (!t) return {};
    const Vec3<N> p = ray.origin + *t * ray.direction;
    if (dot(p - disk.centre, p - disk.centre) <= disk.radius * disk.radius) return t;
    return {};
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Vec3<N>& d = ray.direction;
    const Vec3<N> v = ray.origin - sphere.centre;
    const N a = dot(d, d);
    const N b = N(2) * dot(v, d);
    const N c = dot(v, v) - sphere.radius * sphere.radius;
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots) return {};
    return first_root(ray, *roots);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const std::optional<Roots<N>> roots = on_lateral(ray, cylinder);
    if (!roots) return {};
    return first_root(ray, *roots, between(ray, cylinder.base, cylinder.top - cylinder.base));
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const std::optional<Roots<N>> roots = on_lateral(ray, cone);
    if (!roots) return {};
    return first_root(ray, *roots, between(ray, cone.base, cone.apex - cone.base));
  }

  /// The open shape, or a cap where that comes first.
  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const CappedCylinder<N>& shape) const {
    const auto& [base, top, radius] = shape;
    const Vec3<N> w = top - base;
    const std::optional<N> lateral = (*this)(ray, Cylinder<N>{base, top, radius});
    const std::optional<N> below = (*this)(ray, Disk<N>{base, w, radius});
    const std::optional<N> above = (*this)(ray, Disk<N>{top, w, radius});
    return nearer(lateral, nearer(below, above));
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const CappedCone<N>& shape) const {
    const auto& [base, apex, radius] = shape;
    const std::optional<N> lateral = (*this)(ray, Cone<N>{base, apex, radius});
    return nearer(lateral, (*this)(ray, Disk<N>{base, apex - base, radius}));
  }

  // The same without the conditions that give a shape its ends.

  /// Where the plane of a disk is met, in the range.
  template <class N>
  static std::optional<N> on_plane(const Ray<N>& ray, const Disk<N>& disk) {
    const N across = dot(ray.direction, disk.normal);
    if (across == N(0)) return {};
    const N t = dot(disk.centre - ray.origin, disk.normal) / across;
    if (!in_range(ray, t)) return {};
    return t;
  }

  /// Where the line meets the endless cylinder.
  template <class N>
  static std::optional<Roots<N>> on_lateral(const Ray<N>& ray, const Cylinder<N>& cylinder) {
    const Vec3<N>& d = ray.direction;
    const Vec3<N> v = ray.origin - cylinder.base;
    const Vec3<N> w = cylinder.top - cylinder.base;
    const N ww = dot(w, w), vw = dot(v, w), dw = dot(d, w);
    const N a = dot(d, d) * ww - dw * dw;
    const N b = N(2) * (dot(v, d) * ww - vw * dw);
    const N c = dot(v, v) * ww - vw * vw - cylinder.radius * cylinder.radius * ww;
    return quadratic_formula(a, b, c);
  }

  /// Where the line meets both nappes of the endless cone.
  template <class N>
  static std::optional<Roots<N>> on_lateral(const Ray<N>& ray, const Cone<N>& cone) {
    const Vec3<N>& d = ray.direction;
    const Vec3<N> v = ray.origin - cone.base;
    const Vec3<N> w = cone.apex - cone.base;
    const N ww = dot(w, w), vw = dot(v, w), dw = dot(d, w);
    const N h = ww - vw;
    const N rr = cone.radius * cone.radius;
    const N a = ww * (dot(d, d) * ww - dw * dw) - rr * dw * dw;
    const N b = N(2) * (ww * (dot(v, d) * ww - vw * dw) + rr * h * dw);
    const N c = ww * (dot(v, v) * ww - vw * vw) - rr * h * h;
    return quadratic_formula(a, b, c);
  }

 private:
  template <class N>
  static std::optional<N> nearer(const std::optional<N>& one, const std::optional<N>& other) {
    if (!one || (other && *other < *one)) return other;
    return one;
  }

  /// Does the point at t lie between the two planes square to the axis w, at its ends?
  template <class N>
  static auto between(const Ray<N>& ray, const Vec3<N>& base, const Vec3<N>& w) {
    return [&](const N& t) {
      const Vec3<N> p = ray.origin + t * ray.direction;
      const N height = dot(p - base, w);
      return N(0) <= height && height <= dot(w, w);
    };
  }
};

}  // namespace rayaudit
