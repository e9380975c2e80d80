#pragma once

#include "geometry/ray.hpp"
#include "routines/power_of_two.hpp"

namespace rayaudit {

/// A ray as a shape sees it: from a point of the shape's, in lengths near the shape's radius, with
/// a direction of length near 1. All of it by powers of two, so that nothing is rounded but the
/// difference of two given points.
template <class N>
struct Nearby {
  N length, unit;  ///< a length of 1 here, and a t of 1 here, in those of the world
  Vec3<N> from, direction;
  N start = N(0);  ///< the t of from, here
  N radius;

  Nearby(const Ray<N>& ray, const Vec3<N>& place, const N& world_radius)
      : length(power_of_two(world_radius)),
        unit(length / power_of_two(largest_component(ray.direction))),
        from(ray.origin / length - place / length),
        direction(ray.direction / power_of_two(largest_component(ray.direction))),
        radius(world_radius / length) {}

  /// A ray from outside the reach of the shape starts anew at its point nearest the place. One from
  /// inside stays as it is, so that a small t stays small.
  void come_within(const N& reach_squared) {
    if (dot(from, from) <= reach_squared) return;
    start = -dot(from, direction) / dot(direction, direction);
    from = from + start * direction;
  }

  /// Where the ray now starts, as seen from another point of the shape's.
  Vec3<N> from_point(const Ray<N>& ray, const Vec3<N>& point) const {
    return ray.origin / length - point / length + start * direction;
  }

  /// The t of the world.
  N home(const N& t) const { return unit * (start + t); }
};

/// The axis from one end of a shape to the other, with a largest component near 1.
template <class N>
struct Axis {
  Vec3<N> along;
  N length;  ///< a length of 1 along it, in those of the ray nearby

  Axis(const Vec3<N>& from, const Vec3<N>& to, const N& world_length)
      : along(to / world_length - from / world_length),
        length(power_of_two(largest_component(along))) {
    along = along / length;
  }
};

}  // namespace rayaudit
