#pragma once

#include <optional>
#include <string_view>

#include "geometry/shapes.hpp"
#include "routines/nearby.hpp"

namespace rayaudit {

/// The disk with every comparison multiplied out: t is the fraction above / across, and only a hit
/// divides. A parallel ray has across = 0, which leaves above no room in the range. Ray, radius and
/// normal are first brought to a size near 1 by powers of two, so that no product leaves the
/// format.
struct DivisionFree {
  static constexpr std::string_view name = "division_free";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    const Nearby<N> line(ray, disk.centre, disk.radius);
    const Vec3<N>&f = line.from, &d = line.direction;
    const Vec3<N> n = disk.normal / power_of_two(largest_component(disk.normal));
    const bool facing = dot(d, n) > N(0);
    const N across = facing ? dot(d, n) : -dot(d, n);
    const N above = facing ? -dot(f, n) : dot(f, n);
    const N scaled = line.unit * above;
    if (!(ray.t_min * across < scaled && scaled < ray.t_max * across)) return {};
    const Vec3<N> p = across * f + above * d;
    if (!(dot(p, p) <= line.radius * line.radius * across * across)) return {};
    return line.unit * (above / across);
  }
};

}  // namespace rayaudit
