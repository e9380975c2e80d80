#pragma once

#include "families/upright.hpp"

/// Families that are exactly degenerate: every case is built in whole numbers (upright.hpp).
namespace rayaudit::drawing {

/// A station strictly between the ends.
template <template <class> class S>
Whole station(Random& random, const Upright<S>& stand) {
  return random.whole(1, stand.stations - 1);
}

/// A whole combination of two vectors, never of the second alone.
inline WholeVec combination(Random& random, const Format& format, const WholeVec& first,
                            const WholeVec& second) {
  const Whole most = Sizes::of(format).step;
  const Whole i = nonzero(random, most), j = random.whole(-most, most);
  return i * first + j * second;
}

/// In the tangent plane of a surface point, and not along the generator there.
template <template <class> class S>
Case tangent(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const WholeVec along = combination(random, format, stand.frame.v, stand.generator());
  return through(random, format, stand.shape(), stand.point(station(random, stand)), along);
}

/// Through the rim, where no crossing comes before: inwards, or outwards from within through the
/// open end (seen along the axis, away from that end).
template <template <class> class S>
Case rim(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  WholeVec along = oblique(random, format, stand.frame);
  const bool at_top = same<S, Cylinder> && random.one_in(2);
  const WholeVec point = stand.point(same<S, Cone> || at_top ? stand.stations : 0);
  if constexpr (!same<S, Disk>) {
    const WholeVec from_end = at_top ? -stand.frame.w : stand.frame.w;
    if (dot(along, stand.outward()) > 0 && dot(along, from_end) < 0) along = -along;
  }
  return through(random, format, stand.shape(), point, along);
}

/// Through the apex: three in four pass outside the cone there, the others inside.
template <template <class> class S>
Case apex(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const Whole most = Sizes::of(format).step;
  const Whole i = nonzero(random, most), j = nonzero(random, most);
  const Whole outside = (stand.height_slope * std::abs(i) - 1) / stand.radius_slope;
  const Whole run = std::abs(i) + std::abs(j);
  const Whole beyond = stand.height_slope * run / stand.radius_slope + 1;
  const Whole l = random.one_in(4) ? random.either(random.whole(beyond, beyond + most))
                                   : random.whole(-outside, outside);
  const WholeVec along = i * stand.frame.u + j * stand.frame.v + l * stand.frame.w;
  return through(random, format, stand.shape(), stand.end(), along);
}

/// A point beside the axis and level with the foot; half of them no further away than the radius.
template <template <class> class S>
WholeVec beside(Random& random, const Upright<S>& stand) {
  const Whole most = stand.radius() + stand.radius() / 4;
  const Whole i = nonzero(random, most), j = nonzero(random, most);
  return stand.foot + i * stand.frame.u + j * stand.frame.v;
}

/// Along the plane of a disk, off it.
template <class Shape>
Case parallel_to(const Upright<Disk>& disk, Random& random, const Format& format,
                 const Shape& shape) {
  const WholeVec along = combination(random, format, disk.frame.u, disk.frame.v);
  const WholeVec off = nonzero(random, disk.radius()) * disk.frame.w;
  return from(random, format, shape, beside(random, disk) + off, along);
}

/// Along the plane of the disk, off it; along the axis, off the cylinder; on the cone along the
/// axis or along a generator, where half are aimed at a point of the surface.
template <template <class> class S>
Case parallel(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const Frame& axes = stand.frame;
  if constexpr (same<S, Disk>) {
    return parallel_to(stand, random, format, stand.shape());
  } else if constexpr (same<S, Cylinder>) {
    const WholeVec height = random.whole(-stand.height(), stand.height()) * axes.w;
    const bool outside = random.one_in(2);
    const Whole i = outside ? random.whole(stand.radius() + 1, 2 * stand.radius())
                            : random.whole(0, stand.radius() - 1);
    const Whole room = outside ? stand.radius() : stand.radius() - 1 - i;
    const WholeVec off = i * axes.u + random.whole(-room, room) * axes.v;
    const WholeVec along = random.either(axes.w);
    return from(random, format, stand.shape(), stand.foot + off + height, along);
  } else {
    const bool to_axis = random.one_in(4);
    const WholeVec along = random.either(to_axis ? axes.w : stand.generator());
    if (random.one_in(2)) {
      const WholeVec height = random.whole(-stand.height(), stand.height()) * axes.w;
      return from(random, format, stand.shape(), beside(random, stand) + height, along);
    }
    const std::array sides = {-axes.u, axes.v, -axes.v};
    const WholeVec side = sides[static_cast<std::size_t>(random.below(3))];
    const WholeVec point = stand.point(station(random, stand), side);
    return through(random, format, stand.shape(), point, along);
  }
}

/// Square to the axis of cylinder and cone, along the normal of the disk; some half of them hit.
template <template <class> class S>
Case perpendicular(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const Frame& axes = stand.frame;
  if constexpr (same<S, Disk>) {
    const WholeVec along = random.either(axes.w);
    return through(random, format, stand.shape(), beside(random, stand), along);
  } else {
    const Whole most = Sizes::of(format).step;
    const Whole i = nonzero(random, most), j = nonzero(random, most);
    const WholeVec along = i * axes.u + j * axes.v, across = i * axes.v - j * axes.u;
    const Whole level = station(random, stand);
    const Whole radius = stand.radius_slope * (same<S, Cone> ? level : stand.stations);
    const Whole up = stand.height_slope * (same<S, Cone> ? stand.stations - level : level);
    const Whole most_off = radius + radius / 2;
    const Whole off = random.whole(-most_off, most_off) / std::max(std::abs(i), std::abs(j));
    return through(random, format, stand.shape(), stand.foot + up * axes.w + off * across, along);
  }
}

/// In the plane of a disk: into it, from within it, past it, or touching its rim.
template <class Shape>
Case in_plane_of(const Upright<Disk>& disk, Random& random, const Format& format,
                 const Shape& shape) {
  const Frame& axes = disk.frame;
  const Whole most = Sizes::of(format).step;
  const Whole i = nonzero(random, most), j = nonzero(random, most);
  const WholeVec along = i * axes.u + j * axes.v, across = i * axes.v - j * axes.u;
  const Whole a = random.whole(-disk.radius(), disk.radius());
  const Whole room = disk.radius() - std::abs(a), b = random.whole(-room, room);
  const WholeVec in_disk = disk.foot + a * axes.u + b * axes.v;
  const auto kind = random.below(8);
  if (kind < 3) return through(random, format, shape, in_disk, along);
  if (kind < 5) return from(random, format, shape, in_disk, along);
  if (kind < 6) return through(random, format, shape, disk.point(0), random.either(axes.v));
  const Whole past = disk.radius() / std::max(std::abs(i), std::abs(j)) + 1;
  return through(random, format, shape, disk.foot + random.either(past * across), along);
}

/// In the plane of the disk; along a generator: before the stretch, on it (at its ends too), or
/// after.
template <template <class> class S>
Case within(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const auto shape = stand.shape();
  if constexpr (same<S, Disk>) {
    return in_plane_of(stand, random, format, shape);
  } else {
    const Whole at = random.one_in(4) ? stand.stations * random.below(2)
                                      : random.whole(-stand.stations, 2 * stand.stations);
    const WholeVec along = random.either(stand.generator());
    return from(random, format, shape, stand.point(at), along);
  }
}

/// A point of the surface at the station; on the disk anywhere but the rim.
template <template <class> class S>
WholeVec surface_point(Random& random, const Upright<S>& stand, Whole station) {
  if constexpr (!same<S, Disk>) return stand.point(station);
  const Whole i = random.whole(0, stand.radius() - 1);
  const Whole room = stand.radius() - 1 - i, j = random.whole(-room, room);
  return stand.foot + i * stand.frame.u + j * stand.frame.v;
}

/// The ray begins at the point, at t = 0, or where t_min is.
template <template <class> class S>
Case begun(Random& random, const Format& format, const Upright<S>& stand, const WholeVec& point) {
  const WholeVec along = oblique(random, format, stand.frame);
  if (!random.one_in(4)) return from(random, format, stand.shape(), point, along);
  const Whole before = nonzero(random, fits(format, along));
  Ray<double> ray = {in<double>(point - before * along), in<double>(along)};
  ray.t_min = static_cast<double>(before);
  return rescaled(random, format, stand.shape(), ray);
}

/// The ray begins exactly on the surface.
template <template <class> class S>
Case surface(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const WholeVec point = surface_point(random, stand, station(random, stand));
  return begun(random, format, stand, point);
}

}  // namespace rayaudit::drawing
