#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/first_root.hpp"

namespace rayaudit {

/// The quadratic of the shape for a ray whose direction has length 1, as many renderers and their
/// tutorials have it: d.d is left out. Haines, "Essential Ray Tracing Algorithms", in Glassner,
/// ed., "An Introduction to Ray Tracing", 1989, sec. 2.2, the geometric solution. Of any other ray
/// the answer is wrong, and in floats a direction is hardly ever of length 1.
struct UnitDirection {
  static constexpr std::string_view name = "unit_direction";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    using std::sqrt;
    const Vec3<N> toward = sphere.centre - ray.origin;
    const N closest = dot(toward, ray.direction);
    const N half_chord_squared =
        sphere.radius * sphere.radius - (dot(toward, toward) - closest * closest);
    if (half_chord_squared < N(0)) return {};
    const N half_chord = sqrt(half_chord_squared);
    return first_root(ray, {closest - half_chord, closest + half_chord});
  }

  /// With the part of each vector along the axis taken away, a = 1 - (d.w)^2 / |w|^2.
  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    using std::sqrt;
    const Vec3<N> v = ray.origin - cylinder.base;
    const Vec3<N> w = cylinder.top - cylinder.base;
    const N ww = dot(w, w), vw = dot(v, w), dw = dot(ray.direction, w);
    const N a = N(1) - dw * dw / ww;
    const N half_b = dot(v, ray.direction) - vw * dw / ww;
    const N c = dot(v, v) - vw * vw / ww - cylinder.radius * cylinder.radius;
    if (a == N(0)) return {};
    const N discriminant = half_b * half_b - a * c;
    if (discriminant < N(0)) return {};
    const N root = sqrt(discriminant);
    return first_root(ray, {(-half_b - root) / a, (-half_b + root) / a}, [&](const N& t) {
      const N height = vw + t * dw;
      return N(0) <= height && height <= ww;
    });
  }
};

}  // namespace rayaudit
