#pragma once

#include <array>
#include <optional>
#include <span>

#include "geometry/error.hpp"
#include "geometry/shapes.hpp"

/// The transforms of a scene. They are worked out in long double, so that what they place is off by
/// little more than its rounding to double.
namespace rayaudit {

using Wide = long double;

/// In radians.
inline constexpr Wide degree = 0.01745329251994329576923690768488612713L;

/// p -> x p.x + y p.y + z p.z + moved.
struct Affine {
  Vec3<Wide> x = {1, 0, 0}, y = {0, 1, 0}, z = {0, 0, 1}, moved = {0, 0, 0};

  Vec3<Wide> vector(const Vec3<Wide>& v) const { return v.x * x + v.y * y + v.z * z; }
  Vec3<Wide> point(const Vec3<Wide>& p) const { return vector(p) + moved; }
  /// First the inner, then this.
  Affine after(const Affine& inner) const;
};

/// A transform and its inverse, both with finite doubles for numbers but for their rounding.
struct Transform {
  Affine to = {}, from = {};

  /// As directives build up: first the inner. Throws Error where numbers overflow.
  Transform after(const Transform& inner) const;
  Transform inverse() const { return {from, to}; }
};

/// As the directives are called; all throw Error where there is no such transform or inverse.
Transform translate(const Vec3<double>& by);
Transform scale(const Vec3<double>& by);
/// By degrees; a multiple of 90 has no rounding of its own.
Transform rotate(double degrees, const Vec3<double>& axis);
/// From the world to a camera whose x is right, y up and z forward: pbrt is left-handed.
Transform look_at(const Vec3<double>& eye, const Vec3<double>& at, const Vec3<double>& up);
/// Of 4 x 4 numbers, column after column; the last row must be 0 0 0 1.
Transform matrix(std::span<const double> columns);

Wide length(const Vec3<Wide>& v);

/// How far two axes may be from perpendicular, as a cosine, or from one length, as a share of it,
/// for an image to be taken as a shape of ours. Matrices are typed with six digits: six numbers off
/// by 5e-7 move a product of two columns by 3e-6. What is meant as no similarity is farther off.
inline constexpr Wide most_skew = 1e-5;

/// The image of a shape about the z axis, of its centre or ends and a radius that is the mean of
/// the two axes' across. Throws Error, which tells why, where it is no shape of the same kind or
/// has no finite doubles.
Shape image(const Shape& shape, const Affine& transform);

/// Are axes perpendicular to each other?
bool are_perpendicular(const Vec3<Wide>& a, const Vec3<Wide>& b);

/// To the nearest doubles.
Vec3<double> nearest_doubles(const Vec3<Wide>& v);

}  // namespace rayaudit
