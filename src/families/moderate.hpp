#pragma once

#include <cmath>
#include <type_traits>

#include "families/random.hpp"
#include "geometry/case.hpp"
#include "geometry/format.hpp"

/// Shapes of a given place and size, and the points of and around them that rays are drawn from
/// and aimed at; all in double, rounded to a format by those who make a case of them.
namespace rayaudit::drawing {

using Vec = Vec3<double>;

template <template <class> class S, template <class> class T>
inline constexpr bool same = std::is_same_v<S<double>, T<double>>;

inline bool is_float(const Format& format) { return format.precision == float_format.precision; }

inline double rounded(double x, const Format& format) {
  return is_float(format) ? static_cast<double>(static_cast<float>(x)) : x;
}
inline Vec rounded(const Vec& v, const Format& format) {
  return {rounded(v.x, format), rounded(v.y, format), rounded(v.z, format)};
}
template <template <class> class S>
S<double> rounded(S<double> shape, const Format& format) {
  std::apply([&](auto&... part) { ((part = rounded(part, format)), ...); }, shape.parts());
  return shape;
}

inline double length(const Vec& v) { return std::sqrt(dot(v, v)); }

/// A shape with its centre or base at a place; its radius and height from size / 4 to size.
template <template <class> class S>
S<double> moderate(Random& random, const Vec& place, double size) {
  const double radius = size * random.between(0.25, 1);
  if constexpr (same<S, Sphere>) {
    return {place, radius};
  } else if constexpr (same<S, Disk>) {
    return {place, random.in_cube(), radius};
  } else {
    return {place, place + random.vector(size / 4, size), radius};
  }
}

inline Vec axis(const Cylinder<double>& shape) { return shape.top - shape.base; }
inline Vec axis(const Cone<double>& shape) { return shape.apex - shape.base; }

inline Vec middle(const Disk<double>& shape) { return shape.centre; }
inline Vec middle(const Sphere<double>& shape) { return shape.centre; }
template <class S>
Vec middle(const S& shape) {
  return shape.base + 0.5 * axis(shape);
}

/// The radius of a ball around the middle that holds the shape.
inline double reach(const Disk<double>& shape) { return shape.radius; }
inline double reach(const Sphere<double>& shape) { return shape.radius; }
template <class S>
double reach(const S& shape) {
  const Vec half = 0.5 * axis(shape);
  return std::sqrt(dot(half, half) + shape.radius * shape.radius);
}

/// A vector square to the axis, of a length from least to most.
inline Vec radial(Random& random, const Vec& axis, double least, double most) {
  const double along = random.between(least, most);
  const Vec v = cross(axis, random.in_cube());
  return along / length(v) * v;
}

/// The radius at a height, 0 the base, 1 the top.
inline double radius_at(const Cylinder<double>& shape, double) { return shape.radius; }
inline double radius_at(const Cone<double>& shape, double height) {
  return (1 - height) * shape.radius;
}

/// A point at a height, from least to most of the radius there away from the axis.
template <class S>
Vec point_at(Random& random, const S& shape, double height, double least, double most) {
  const Vec w = axis(shape);
  const double radius = radius_at(shape, height);
  return shape.base + height * w + radial(random, w, least * radius, most * radius);
}

/// A point on the surface, up to rounding.
inline Vec surface_point(Random& random, const Disk<double>& shape) {
  return shape.centre + radial(random, shape.normal, 0, shape.radius);
}
inline Vec surface_point(Random& random, const Sphere<double>& shape) {
  return shape.centre + random.vector(shape.radius, shape.radius);
}
template <class S>
Vec surface_point(Random& random, const S& shape) {
  return point_at(random, shape, random.between(0, 1), 1, 1);
}

/// A point that the shape surrounds.
inline Vec inside_point(Random& random, const Sphere<double>& shape) {
  return shape.centre + random.vector(0, 0.999 * shape.radius);
}
template <class S>
Vec inside_point(Random& random, const S& shape) {
  return point_at(random, shape, random.between(0, 0.999), 0, 0.999);
}

/// A point to aim at so that near half of the rays hit.
inline Vec target(Random& random, const Disk<double>& shape) {
  return shape.centre + radial(random, shape.normal, 0, 2 * shape.radius);
}
template <class S>
Vec target(Random& random, const S& shape) {
  if (random.below(5) < 2) return surface_point(random, shape);
  return middle(shape) + 2 * reach(shape) * random.in_cube();
}

/// From an origin towards a point; the direction of any length from a sixteenth of the way to all.
inline Ray<double> aimed(Random& random, const Format& format, const Vec& from, const Vec& to) {
  const Vec origin = rounded(from, format);
  const double part = random.between(0x1p-4, 1);
  return {origin, rounded(part * (to - origin), format)};
}

}  // namespace rayaudit::drawing
