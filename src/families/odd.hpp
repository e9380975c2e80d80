#pragma once

#include <limits>

#include "families/anywhere.hpp"
#include "families/degenerate.hpp"

/// Families of odd numbers: zeros of both signs, small whole numbers, and no numbers at all.
namespace rayaudit::drawing {

inline double zero(Random& random) { return random.one_in(2) ? -0.0 : 0.0; }

inline double& component(Vec& v, std::int64_t i) { return i == 0 ? v.x : i == 1 ? v.y : v.z; }

/// The vector along one coordinate axis, the other components zeros of either sign.
inline Vec along_axis(Random& random, Vec v) {
  const auto kept = random.below(3);
  for (int i = 0; i < 3; ++i)
    if (i != kept) component(v, i) = zero(random);
  return v;
}

template <template <class> class S>
S<double> axis_aligned(Random& random, S<double> shape) {
  if constexpr (same<S, Disk>) {
    shape.normal = along_axis(random, shape.normal);
  } else if constexpr (!same<S, Sphere>) {
    const Vec end =
        shape.base + along_axis(random, {shape.radius, -2 * shape.radius, 4 * shape.radius});
    if constexpr (same<S, Cone>)
      shape.apex = end;
    else
      shape.top = end;
  }
  return shape;
}

/// Along a coordinate axis, with zeros of either sign; half of the shapes are so too.
template <template <class> class S>
Case axis(Random& random, const Format& format, int) {
  const Vec place = random.one_in(4) ? Vec{zero(random), 0, zero(random)} : 8.0 * random.in_cube();
  auto shape = moderate<S>(random, place, 4);
  if (random.one_in(2)) shape = axis_aligned<S>(random, shape);
  shape = rounded<S>(shape, format);
  const double step = random.either(std::ldexp(1.0, static_cast<int>(random.whole(-3, 3))));
  const Vec direction = along_axis(random, {step, step, step});
  const double steps = 8 * random.between(-0.25, 1) / std::abs(step);
  const Vec to = random.one_in(2) ? surface_point(random, shape) : target(random, shape);
  return {{rounded(to - steps * direction, format), direction}, shape};
}

/// The shapes of the handout: radius 1 at the world origin, height 1 along y.
template <template <class> class S>
S<double> handout_shape() {
  if constexpr (same<S, Sphere>)
    return {{0, 0, 0}, 1};
  else
    return {{0, 0, 0}, {0, 1, 0}, 1};
}

inline WholeVec small(Random& random, Whole most) {
  const Whole x = random.whole(-most, most), y = random.whole(-most, most);
  const Whole z = random.whole(-most, most);
  return {x, y, z};
}

inline WholeVec small_but_zero(Random& random, Whole most) {
  const WholeVec v = small(random, most);
  return v == WholeVec{0, 0, 0} ? WholeVec{0, 0, 1} : v;
}

/// A ray of small whole numbers through the point, most from the side that outward shows, or (one
/// in eight) anywhere; a few with a range that begins or ends at the point, or just past it.
inline Ray<double> small_ray(Random& random, const WholeVec& point, const WholeVec& outward) {
  WholeVec along = small_but_zero(random, 3);
  if (random.one_in(8)) return {in<double>(small(random, 6)), in<double>(along)};
  if (dot(along, outward) > 0 && !random.one_in(4)) along = -along;
  const Whole before = random.whole(1, 4);
  Ray<double> ray = {in<double>(point - before * along), in<double>(along)};
  const auto t = static_cast<double>(before);
  const auto range = random.below(16);
  if (range == 0) ray.t_max = t;
  if (range == 1) ray.t_min = t;
  if (range == 2) ray.t_max = t + 1;
  return ray;
}

template <class S>
void halve(S& shape, Ray<double>& ray) {
  std::apply([](auto&... part) { (scale_by(part, -1), ...); }, shape.parts());
  scale_by(ray.origin, -1);
  scale_by(ray.direction, -1);
}

/// Small whole numbers or halves: the handout's shapes with rays through or around the world
/// origin, or shapes with the world origin on their surface and rays that mostly pass there.
template <template <class> class S>
Case lattice(Random& random, const Format&, int) {
  const WholeVec world_origin = {0, 0, 0};
  S<double> shape = handout_shape<S>();
  Ray<double> ray = {};
  if (random.one_in(3)) {
    ray = small_ray(random, random.one_in(2) ? world_origin : small(random, 1), world_origin);
  } else {
    Upright<S> stand = {frame(random, 2), small(random, 4), random.whole(1, 2), random.whole(1, 2),
                        2};
    if (random.one_in(4)) stand.frame = turned(1, 1, 1, 0);
    const Whole at = random.one_in(2) ? 1 : random.whole(0, 2);
    const WholeVec point = random.one_in(4) ? stand.point(at) : surface_point(random, stand, at);
    const WholeVec home = random.one_in(4) ? world_origin : point;
    stand.foot = stand.foot - home;
    shape = stand.shape();
    ray = small_ray(random, point - home, stand.outward());
    if (random.one_in(2)) halve(shape, ray);
  }
  return {ray, shape};
}

/// A case anywhere with one number or part made so that there is nothing to ask.
template <template <class> class S>
Case invalid(Random& random, const Format& format, int k) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Case question = anywhere<S>(random, format, k);
  auto& shape = std::get<S<double>>(question.shape);
  const auto put = [&](double bad) {
    auto left = random.below(same<S, Sphere> ? 10 : 13);
    each_number(question, [&](double& x) {
      if (left-- == 0) x = bad;
    });
  };
  const Vec zeros = {zero(random), zero(random), zero(random)};
  switch (random.below(same<S, Sphere> ? 5 : 6)) {
    case 0:
      if (random.one_in(8))
        (random.one_in(2) ? question.ray.t_min : question.ray.t_max) = nan;
      else
        put(nan);
      break;
    case 1:
      put(random.either(infinity));
      break;
    case 2:
      question.ray.direction = zeros;
      break;
    case 3:
      shape.radius = random.one_in(2) ? zero(random) : -shape.radius;
      break;
    case 4: {
      const double t = random.one_in(8) ? infinity : static_cast<double>(random.below(4));
      question.ray.t_min = t;
      question.ray.t_max = random.one_in(2) ? t : t - static_cast<double>(random.whole(1, 3));
      break;
    }
    default:
      if constexpr (same<S, Disk>) shape.normal = zeros;
      if constexpr (same<S, Cylinder>) shape.top = shape.base;
      if constexpr (same<S, Cone>) shape.apex = shape.base;
  }
  return question;
}

}  // namespace rayaudit::drawing
