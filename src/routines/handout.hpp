#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "geometry/ray.hpp"
#include "geometry/shapes.hpp"

namespace rayaudit {

/// The solutions 5.1 (disk) and 5.2 (sphere) of the course handout that this project comes from,
/// exactly as printed, slips included. The handout knows no range: its t is held against 0 only.
struct Handout {
  static constexpr std::string_view name = "handout";

  /// intersecaDisco(o, d, c, r, n). Its first line, `if (d < 0)` on a vector, means nothing and is
  /// left out; `||v||` is the root of v.v.
  template <class N>
  bool operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    using std::sqrt;
    const Vec3<N>&o = ray.origin, &d = ray.direction, &c = disk.centre, &n = disk.normal;
    const N t = (-n.x * o.x + n.x * c.x - n.y * o.y + n.y * c.y - n.z * o.z + n.z * c.z) /
                (n.x * d.x + n.y * d.y + n.z * d.z);
    if (t < N(0)) return false;
    const Vec3<N> pt = o + t * d;
    if (sqrt(dot(pt - c, pt - c)) > disk.radius) return false;
    return true;
  }

  /// Any sphere, by the reduction that exercise 5.2 asks for: the ray is carried to where the
  /// sphere is the unit one and the tuple that comes back is carried home, where it is a miss if it
  /// is (0,0,0), as the signature promises.
  template <class N>
  std::optional<Vec3<N>> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Vec3<N> tuple = intersection_with_unit_sphere(
        (ray.origin - sphere.centre) / sphere.radius, ray.direction / sphere.radius);
    const Vec3<N> point = sphere.centre + sphere.radius * tuple;
    if (point.x == N(0) && point.y == N(0) && point.z == N(0)) return {};
    return point;
  }

 private:
  /// `intersecciónEsferaUnidad(o, d)`. The printed `o . d^2` is (o.d)^2, `||d||^2` is d.d, a
  /// Tupla3f is a Vec3.
  template <class N>
  static Vec3<N> intersection_with_unit_sphere(const Vec3<N>& o, const Vec3<N>& d) {
    using std::sqrt;
    const N discriminant = dot(o, d) * dot(o, d) - N(4) * dot(d, d) * (dot(o, o) - N(1));
    if (discriminant < N(0)) return {N(0), N(0), N(0)};
    const N t1 = (-dot(o, d) + sqrt(discriminant)) / (N(2) * dot(d, d));
    const N t2 = (-dot(o, d) - sqrt(discriminant)) / (N(2) * dot(d, d));
    if (t1 < N(0) && t2 < N(0)) return {N(0), N(0), N(0)};
    if (t1 > N(0) && t2 > N(0)) return o + (t2 < t1 ? t2 : t1) * d;
    if (t1 > N(0)) return o + t1 * d;
    return o + t2 * d;
  }
};

}  // namespace rayaudit
