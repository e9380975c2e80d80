#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/first_root.hpp"
#include "routines/frame.hpp"
#include "routines/quadratic_formula.hpp"

namespace rayaudit {

/// The reduction that exercises 5.2 and 5.3 of the handout ask for: the ray is carried to the space
/// where the shape is the unit one (centre or base centre 0, radius 1, axis or normal (0,1,0)) and
/// met there. The way there is affine, so t needs no way back.
struct UnitSpace {
  static constexpr std::string_view name = "unit_space";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    const Frame<N> frame = frame_along(disk.normal);
    const Ray<N> unit = carried(ray, frame, disk.centre, disk.radius, disk.radius);
    const Vec3<N>&o = unit.origin, &d = unit.direction;
    if (d.y == N(0)) return {};
    const N t = -o.y / d.y;
    if (!in_range(ray, t)) return {};
    const N x = o.x + t * d.x, z = o.z + t * d.z;
    if (x * x + z * z <= N(1)) return t;
    return {};
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Vec3<N> o = (ray.origin - sphere.centre) / sphere.radius;
    const Vec3<N> d = ray.direction / sphere.radius;
    const std::optional<Roots<N>> roots =
        quadratic_formula(dot(d, d), N(2) * dot(o, d), dot(o, o) - N(1));
    if (!roots) return {};
    return first_root(ray, *roots);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    using std::sqrt;
    const Vec3<N> w = cylinder.top - cylinder.base;
    const Ray<N> unit =
        carried(ray, frame_along(w), cylinder.base, cylinder.radius, sqrt(dot(w, w)));
    const Vec3<N>&o = unit.origin, &d = unit.direction;
    const N a = d.x * d.x + d.z * d.z;
    const N b = N(2) * (o.x * d.x + o.z * d.z);
    const N c = o.x * o.x + o.z * o.z - N(1);
    return first_of_height(unit, quadratic_formula(a, b, c));
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    using std::sqrt;
    const Vec3<N> w = cone.apex - cone.base;
    const Ray<N> unit = carried(ray, frame_along(w), cone.base, cone.radius, sqrt(dot(w, w)));
    const Vec3<N>&o = unit.origin, &d = unit.direction;
    const N below = N(1) - o.y;
    const N a = d.x * d.x + d.z * d.z - d.y * d.y;
    const N b = N(2) * (o.x * d.x + o.z * d.z + below * d.y);
    const N c = o.x * o.x + o.z * o.z - below * below;
    return first_of_height(unit, quadratic_formula(a, b, c));
  }

 private:
  /// The ray seen from the frame at an origin, in units of width along x and z and of height along
  /// y.
  template <class N>
  static Ray<N> carried(const Ray<N>& ray, const Frame<N>& frame, const Vec3<N>& origin,
                        const N& width, const N& height) {
    const auto turned = [&](const Vec3<N>& v) {
      return Vec3<N>{dot(v, frame.x) / width, dot(v, frame.y) / height, dot(v, frame.z) / width};
    };
    return {turned(ray.origin - origin), turned(ray.direction), ray.t_min, ray.t_max};
  }

  /// The first root at which the ray's y is from 0 to 1.
  template <class N>
  static std::optional<N> first_of_height(const Ray<N>& unit,
                                          const std::optional<Roots<N>>& roots) {
    if (!roots) return {};
    return first_root(unit, *roots, [&](const N& t) {
      const N y = unit.origin.y + t * unit.direction.y;
      return N(0) <= y && y <= N(1);
    });
  }
};

}  // namespace rayaudit
