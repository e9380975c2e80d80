#pragma once

#include "families/anywhere.hpp"
#include "families/degenerate.hpp"
#include "families/near.hpp"

/// Families of closed shapes: each draws what it draws of the open shape S, which is then closed,
/// and some also what only a surface with caps and edges has.
namespace rayaudit::drawing {

inline Case closed(const Case& question) {
  Case made = question;
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&question.shape))
    made.shape = CappedCylinder<double>{cylinder->base, cylinder->top, cylinder->radius};
  if (const auto* cone = std::get_if<Cone<double>>(&question.shape))
    made.shape = CappedCone<double>{cone->base, cone->apex, cone->radius};
  return made;
}

template <Draw open>
Case closed(Random& random, const Format& format, int k) {
  return closed(open(random, format, k));
}

/// A cap, as a disk: the base or, of a cylinder, the top.
template <template <class> class S>
Upright<Disk> cap(Random& random, const Upright<S>& stand) {
  const bool is_top = same<S, Cylinder> && random.one_in(2);
  return {stand.frame, is_top ? stand.end() : stand.foot, stand.radius_slope, stand.height_slope,
          stand.stations};
}

/// A point strictly inside the shape.
template <template <class> class S>
WholeVec inner_point(Random& random, const Upright<S>& stand) {
  const Whole level = station(random, stand);
  const Whole radius = stand.radius_slope * (same<S, Cone> ? level : stand.stations);
  const Whole up = stand.height_slope * (same<S, Cone> ? stand.stations - level : level);
  const Whole i = random.whole(1 - radius, radius - 1), room = radius - 1 - std::abs(i);
  const Whole j = random.whole(-room, room);
  return stand.foot + i * stand.frame.u + j * stand.frame.v + up * stand.frame.w;
}

/// Through an edge: a quarter from inside outwards, a quarter from outside inwards, and half graze
/// it.
template <template <class> class S>
Case edge(Random& random, const Format& format, int) {
  const auto stand = upright<S>(random, format);
  const Upright<Disk> at = cap(random, stand);
  const WholeVec point = at.point(0);
  const auto kind = random.below(4);
  if (kind == 0) {
    const WholeVec inside = inner_point(random, stand);
    return closed(from(random, format, stand.shape(), inside, point - inside));
  }
  const WholeVec off_cap = at.foot == stand.foot ? -stand.frame.w : stand.frame.w;
  const auto leaves_side = [&](const WholeVec& along) { return dot(along, stand.outward()) > 0; };
  const auto leaves_cap = [&](const WholeVec& along) { return dot(along, off_cap) > 0; };
  const auto grazes = [&](const WholeVec& v) { return leaves_side(v) != leaves_cap(v); };
  WholeVec along = oblique(random, format, stand.frame);
  for (int more = 16; more > 0 && grazes(along) != (kind > 1); --more)
    along = oblique(random, format, stand.frame);
  if (leaves_side(along) && leaves_cap(along)) along = -along;
  return closed(through(random, format, stand.shape(), point, along));
}

/// Half of them along a generator, half in the plane of a cap: into it, from within it, past it, or
/// along its edge.
template <template <class> class S>
Case closed_within(Random& random, const Format& format, int k) {
  if (random.one_in(2)) return closed(within<S>(random, format, k));
  const auto stand = upright<S>(random, format);
  const Upright<Disk> plane = cap(random, stand);
  return closed(in_plane_of(plane, random, format, stand.shape()));
}

/// Half of them parallel to axis or generator, half to the caps.
template <template <class> class S>
Case closed_parallel(Random& random, const Format& format, int k) {
  if (random.one_in(2)) return closed(parallel<S>(random, format, k));
  const auto stand = upright<S>(random, format);
  const Upright<Disk> plane = cap(random, stand);
  return closed(parallel_to(plane, random, format, stand.shape()));
}

/// The ray begins on a cap, in half of them.
template <template <class> class S>
Case closed_surface(Random& random, const Format& format, int k) {
  if (random.one_in(2)) return closed(surface<S>(random, format, k));
  const auto stand = upright<S>(random, format);
  const Upright<Disk> at = cap(random, stand);
  const WholeVec point = surface_point(random, at, 0);
  return closed(begun(random, format, stand, point));
}

template <template <class> class S>
Case closed_surface_near(Random& random, const Format& format, int k) {
  const Case question = closed_surface<S>(random, format, k);
  return nudged(random, format, k, question, 3);
}

/// The origin a point of a cap as the format has it, in half of them.
template <template <class> class S>
Case closed_spawned(Random& random, const Format& format, int k) {
  if (random.one_in(2)) return closed(spawned<S>(random, format, k));
  const auto shape = moderate_shape<S>(random, format);
  const Vec w = axis(shape);
  const Vec centre = same<S, Cylinder> && random.one_in(2) ? shape.base + w : shape.base;
  const Vec from = centre + radial(random, w, 0, shape.radius);
  return closed({{rounded(from, format), rounded(random.in_cube(), format)}, shape});
}

}  // namespace rayaudit::drawing
