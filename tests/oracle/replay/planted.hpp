#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/first_root.hpp"
#include "routines/quadratic_formula.hpp"

/// Routines that are sound but for one flaw each.
namespace rayaudit::planted {

/// The three coefficients of a sphere.
template <class N>
struct Coefficients {
  N a, b, c;
};
template <class N>
Coefficients<N> coefficients(const Ray<N>& ray, const Sphere<N>& sphere) {
  const Vec3<N> v = ray.origin - sphere.centre;
  return {dot(ray.direction, ray.direction), N(2) * dot(v, ray.direction),
          dot(v, v) - sphere.radius * sphere.radius};
}

/// b^2 - ac for b^2 - 4ac.
struct WrongFactor {
  static constexpr std::string_view name = "wrong_factor";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    using std::sqrt;
    const auto [a, b, c] = coefficients(ray, sphere);
    const N discriminant = b * b - a * c;
    if (discriminant < N(0)) return {};
    const N root = sqrt(discriminant);
    return first_root(ray, {(-b - root) / (N(2) * a), (-b + root) / (N(2) * a)});
  }
};

/// No test for a ray parallel to the plane.
struct NoParallelCheck {
  static constexpr std::string_view name = "no_parallel_check";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    const N t = dot(disk.centre - ray.origin, disk.normal) / dot(ray.direction, disk.normal);
    if (t < ray.t_min || t > ray.t_max) return {};
    const Vec3<N> v = ray.origin + t * ray.direction - disk.centre;
    if (dot(v, v) > disk.radius * disk.radius) return {};
    return t;
  }
};

/// The rim is left out: < for <=.
struct OpenRim {
  static constexpr std::string_view name = "open_rim";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    const N across = dot(ray.direction, disk.normal);
    if (across == N(0)) return {};
    const N t = dot(disk.centre - ray.origin, disk.normal) / across;
    const Vec3<N> v = ray.origin + t * ray.direction - disk.centre;
    if (in_range(ray, t) && dot(v, v) < disk.radius * disk.radius) return t;
    return {};
  }
};

/// The foot of the origin on the plane is found as if the normal had length 1.
struct UnitNormal {
  static constexpr std::string_view name = "unit_normal";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    const Vec3<N>&n = disk.normal, &d = ray.direction;
    const N across = dot(d, n);
    if (across == N(0)) return {};
    const Vec3<N> v = ray.origin - disk.centre;
    const Vec3<N> to_foot = -(dot(v, n) * n);
    const N along = dot(d, to_foot);
    if (along == N(0)) return {};
    const N t = dot(to_foot, to_foot) / along;
    const Vec3<N> p = v + t * d;
    if (in_range(ray, t) && dot(p, p) <= disk.radius * disk.radius) return t;
    return {};
  }
};

/// The far root is asked first.
struct FarRootFirst {
  static constexpr std::string_view name = "far_root_first";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const auto [a, b, c] = coefficients(ray, sphere);
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots) return {};
    if (in_range(ray, roots->other)) return roots->other;
    if (in_range(ray, roots->one)) return roots->one;
    return {};
  }
};

/// A cone whose mirrored nappe counts as far as the base.
struct BothNappes {
  static constexpr std::string_view name = "both_nappes";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const Vec3<N>& d = ray.direction;
    const Vec3<N> v = ray.origin - cone.apex, w = cone.base - cone.apex;
    const N ww = dot(w, w), vw = dot(v, w), dw = dot(d, w), rr = cone.radius * cone.radius;
    const N a = ww * (dot(d, d) * ww - dw * dw) - rr * dw * dw;
    const N b = N(2) * (ww * (dot(v, d) * ww - vw * dw) - rr * vw * dw);
    const N c = ww * (dot(v, v) * ww - vw * vw) - rr * vw * vw;
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots) return {};
    return first_root(ray, *roots, [&](const N& t) {
      const N depth = vw + t * dw;
      return depth * depth <= ww * ww;
    });
  }
};

/// The coefficients of a cylinder and the heights along it.
template <class N>
struct Sides {
  N a, b, c, from, slope, full;
};
template <class N>
Sides<N> sides(const Ray<N>& ray, const Cylinder<N>& cylinder) {
  const Vec3<N>& d = ray.direction;
  const Vec3<N> v = ray.origin - cylinder.base, w = cylinder.top - cylinder.base;
  const N ww = dot(w, w), vw = dot(v, w), dw = dot(d, w);
  return {dot(d, d) * ww - dw * dw,
          N(2) * (dot(v, d) * ww - vw * dw),
          dot(v, v) * ww - vw * vw - cylinder.radius * cylinder.radius * ww,
          vw,
          dw,
          ww};
}

/// Above the base or below the top, where it should be both.
struct OrForAnd {
  static constexpr std::string_view name = "or_for_and";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const auto [a, b, c, from, slope, full] = sides(ray, cylinder);
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots) return {};
    for (const N& t : {roots->one, roots->other}) {
      const N height = from + t * slope;
      if (in_range(ray, t) && (N(0) <= height || height <= full)) return t;
    }
    return {};
  }
};

/// q = -(b + sign(b) sqrt(D)) / 2 with sign(0) = 0.
struct SignOfZero {
  static constexpr std::string_view name = "sign_of_zero";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    using std::sqrt;
    const auto [a, b, c] = coefficients(ray, sphere);
    const N under = b * b - N(4) * a * c;
    if (under < N(0)) return {};
    const N sign = b > N(0) ? N(1) : b < N(0) ? N(-1) : N(0);
    const N q = -(b + sign * sqrt(under)) / N(2);
    if (q == N(0)) return first_root(ray, {q / a, q / a});
    return first_root(ray, {q / a, c / q});
  }
};

/// A hit at the world origin is taken for none.
struct Sentinel {
  static constexpr std::string_view name = "sentinel";

  template <class N>
  std::optional<Vec3<N>> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const auto [a, b, c] = coefficients(ray, sphere);
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    const std::optional<N> t = roots ? first_root(ray, *roots) : std::optional<N>();
    const Vec3<N> point = t ? ray.origin + *t * ray.direction : Vec3<N>{N(0), N(0), N(0)};
    if (point.x == N(0) && point.y == N(0) && point.z == N(0)) return {};
    return point;
  }
};

/// A discriminant below 1e-8, which grows with the square of the direction and of the radius,
/// counts as a miss.
struct Epsilon {
  static constexpr std::string_view name = "epsilon";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const auto [a, b, c] = coefficients(ray, sphere);
    if (b * b - N(4) * a * c < N(1e-8)) return {};
    return first_root(ray, *quadratic_formula(a, b, c));
  }
};

/// The school's discriminant, and all else from the nearest point.
struct CancellingDiscriminant {
  static constexpr std::string_view name = "cancelling_discriminant";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    using std::sqrt;
    const auto [a, b, c] = coefficients(ray, sphere);
    if (b * b - N(4) * a * c < N(0)) return {};
    const N nearest = -b / (N(2) * a);
    const Vec3<N> beside = ray.origin - sphere.centre + nearest * ray.direction;
    const N under = (sphere.radius * sphere.radius - dot(beside, beside)) / a;
    const N half = under < N(0) ? N(0) : sqrt(under);
    return first_root(ray, {nearest - half, nearest + half});
  }
};

/// The height is that of the point, whose coordinates are rounded where the cylinder stands.
struct RoundedPoint {
  static constexpr std::string_view name = "rounded_point";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const auto [a, b, c, from, slope, full] = sides(ray, cylinder);
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots) return {};
    const Vec3<N> w = cylinder.top - cylinder.base;
    return first_root(ray, *roots, [&](const N& t) {
      const Vec3<N> p = ray.origin + t * ray.direction;
      const N height = dot(p, w) - dot(cylinder.base, w);
      return N(0) <= height && height <= dot(w, w);
    });
  }
};

}  // namespace rayaudit::planted
