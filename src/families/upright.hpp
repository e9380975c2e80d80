#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

#include "families/moderate.hpp"

/// Shapes with whole-number coordinates in a general position, and rays to them that are exactly
/// what they are meant to be. A quaternion (a, b, c, d) of whole numbers turns the axes into three
/// orthogonal vectors of whole numbers (the columns of its rotation matrix, times the square of its
/// length), all of the length L = a^2 + b^2 + c^2 + d^2; every point of interest is a whole
/// combination of them. Each is a sum of terms that stay below a quarter of what the format holds,
/// so that nothing rounds.
namespace rayaudit::drawing {

using Whole = std::int64_t;
using WholeVec = Vec3<Whole>;

/// Bits of a term: four of them make a number of the format.
inline int term_bits(const Format& format) { return format.precision - 2; }

inline Whole largest(const WholeVec& v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// A whole number from 1 to most, of any size: half of them large.
inline Whole multiple(Random& random, Whole most) {
  const auto bits = static_cast<Whole>(std::bit_width(static_cast<std::uint64_t>(most)));
  const Whole held = random.one_in(2) ? most : std::min(most, Whole{1} << random.below(bits));
  return random.whole(1, held);
}

/// A whole number of at most the given magnitude, never 0.
inline Whole nonzero(Random& random, Whole most) {
  const Whole drawn = random.whole(-most, most - 1);
  return drawn < 0 ? drawn : drawn + 1;
}

/// How large the whole numbers are that a case is made of: as the format allows.
struct Sizes {
  Whole quaternion;  ///< components of the quaternion
  Whole slope;       ///< radius and height, in lowest terms
  Whole step;        ///< coefficients of a direction

  static Sizes of(const Format& format) {
    return is_float(format) ? Sizes{7, 15, 7} : Sizes{1023, 511, 511};
  }
};

struct Frame {
  WholeVec u, v, w;
  Whole length;
};

inline Frame turned(Whole a, Whole b, Whole c, Whole d) {
  return {{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
          {2 * (b * c - a * d), a * a - b * b + c * c - d * d, 2 * (c * d + a * b)},
          {2 * (b * d + a * c), 2 * (c * d - a * b), a * a - b * b - c * c + d * d},
          a * a + b * b + c * c + d * d};
}

/// In general position but for one in eight, which lies along the coordinate axes.
inline Frame frame(Random& random, Whole most) {
  if (!random.one_in(8)) {
    const Whole a = nonzero(random, most), b = nonzero(random, most);
    const Whole c = nonzero(random, most), d = nonzero(random, most);
    return turned(a, b, c, d);
  }
  const Whole length = random.whole(1, most);
  const Whole s = random.either(length), t = random.either(length);
  const WholeVec x = {s, 0, 0}, y = {0, t, 0}, z = {0, 0, length};
  const auto turn = random.below(3);
  if (turn == 0) return {x, y, z, length};
  if (turn == 1) return {y, z, x, length};
  return {z, x, y, length};
}

/// A shape on its axis w: its foot (centre or base centre), and radius and height as
/// stations * slope in units of the frame's length.
template <template <class> class S>
struct Upright {
  Frame frame;
  WholeVec foot;
  Whole radius_slope, height_slope;
  Whole stations;

  Whole radius() const { return stations * radius_slope; }
  Whole height() const { return stations * height_slope; }
  WholeVec end() const { return foot + height() * frame.w; }

  /// A direction in the surface, at the points below.
  WholeVec generator() const {
    if constexpr (same<S, Cone>)
      return radius_slope * frame.u - height_slope * frame.w;
    else
      return frame.w;
  }

  /// Square to the generator and to v, away from the axis.
  WholeVec outward() const {
    if constexpr (same<S, Cone>)
      return height_slope * frame.u + radius_slope * frame.w;
    else
      return frame.u;
  }

  /// The point of the surface at a station from 0 to stations, on the side of side (u, v or their
  /// opposites): up the cylinder, down the cone; on disk and sphere all are one.
  WholeVec point(Whole station, const WholeVec& side) const {
    if constexpr (same<S, Cylinder>)
      return foot + radius() * side + station * height_slope * frame.w;
    else if constexpr (same<S, Cone>)
      return end() + station * (radius_slope * side - height_slope * frame.w);
    else
      return foot + radius() * side;
  }
  WholeVec point(Whole station) const { return point(station, frame.u); }

  S<double> shape() const {
    const double r = static_cast<double>(radius() * frame.length);
    if constexpr (same<S, Disk>)
      return {in<double>(foot), in<double>(frame.w), r};
    else if constexpr (same<S, Sphere>)
      return {in<double>(foot), r};
    else
      return {in<double>(foot), in<double>(end()), r};
  }
};

template <template <class> class S>
Upright<S> upright(Random& random, const Format& format) {
  const Sizes sizes = Sizes::of(format);
  const Whole term = Whole{1} << term_bits(format);
  const Frame axes = frame(random, sizes.quaternion);
  const Whole foot = random.one_in(16) ? 0 : multiple(random, term - 1);
  const Whole x = random.whole(-foot, foot), y = random.whole(-foot, foot);
  const Whole z = random.whole(-foot, foot);
  const Whole radius = random.whole(1, sizes.slope), height = random.whole(1, sizes.slope);
  const Whole room = term / 2 / (axes.length * std::max(radius, height));
  return {axes, {x, y, z}, radius, height, 1 + multiple(random, room - 1)};
}

/// A vector of whole numbers, no component 0, that is square to none of the vectors of the frame
/// and so in no surface that passes along them.
inline WholeVec oblique(Random& random, const Format& format, const Frame& frame) {
  const Whole most = is_float(format) ? 63 : (Whole{1} << 20) - 1;
  const Whole x = nonzero(random, most), y = nonzero(random, most), z = nonzero(random, most);
  const WholeVec v = {x, y, z};
  const bool square = dot(v, frame.u) == 0 || dot(v, frame.v) == 0 || dot(v, frame.w) == 0;
  return square ? frame.u + Whole{2} * frame.v + Whole{3} * frame.w : v;
}

inline void scale_by(double& x, int e) { x = std::ldexp(x, e); }
inline void scale_by(Vec& v, int e) { scale_by(v.x, e), scale_by(v.y, e), scale_by(v.z, e); }

/// Space, direction and normal each times a power of two of its own, exactly; t follows.
template <class S>
Case rescaled(Random& random, const Format& format, S shape, Ray<double> ray) {
  const int space = static_cast<int>(random.whole(-8, 8)) - term_bits(format);
  const int way = static_cast<int>(random.whole(-4, 4)) -
                  std::ilogb(std::max({std::abs(ray.direction.x), std::abs(ray.direction.y),
                                       std::abs(ray.direction.z)}));
  const int vector = static_cast<int>(random.whole(-24, 0));
  std::size_t i = 0;
  std::apply(
      [&](auto&... part) { (scale_by(part, S::kinds[i++] == Part::vector ? vector : space), ...); },
      shape.parts());
  scale_by(ray.origin, space);
  scale_by(ray.direction, way);
  scale_by(ray.t_min, space - way);
  scale_by(ray.t_max, space - way);
  return {ray, shape};
}

/// The direction times a whole number that fills the format; one in four stays as it is.
inline Vec lengthened(Random& random, const Format& format, const WholeVec& along) {
  const Whole room = (Whole{1} << format.precision) / (largest(along) + 1);
  const Whole times = random.one_in(4) ? 1 : random.whole(1, room);
  return in<double>(times * along);
}

/// How many times a vector fits into a term.
inline Whole fits(const Format& format, const WholeVec& v) {
  return (Whole{1} << term_bits(format)) / largest(v);
}

/// A ray that comes from before the point and passes through it along the vector.
template <class S>
Case through(Random& random, const Format& format, const S& shape, const WholeVec& point,
             const WholeVec& along) {
  const Whole before = multiple(random, fits(format, along));
  const Vec direction = lengthened(random, format, along);
  return rescaled(random, format, shape, {in<double>(point - before * along), direction});
}

/// A ray that begins at the point.
template <class S>
Case from(Random& random, const Format& format, const S& shape, const WholeVec& point,
          const WholeVec& along) {
  const Vec direction = lengthened(random, format, along);
  return rescaled(random, format, shape, {in<double>(point), direction});
}

}  // namespace rayaudit::drawing
