#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/shapes.hpp"

/// Directions and normals of surfaces, worked out in a number N as a renderer does.
namespace rayaudit {

template <class N>
N length(const Vec3<N>& v) {
  const N size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(size > N(0)) || !std::isfinite(size)) return size;
  const Vec3<N> w = v / size;
  return size * std::sqrt(dot(w, w));
}

/// Of length 1 but for rounding, also where squares would leave the format.
template <class N>
Vec3<N> unit(const Vec3<N>& v) {
  const N size = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  const Vec3<N> w = v / size;
  return w / std::sqrt(dot(w, w));
}

template <class N>
bool is_finite(const Vec3<N>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The normal at a point of the surface, of length 1, to the outer side: away from the centre of a
/// sphere or the axis of a cylinder or cone (at its apex along that), and to where the normal of a
/// disk points. N is float or double.
template <class N>
Vec3<N> outward_normal(const Shape& shape, const Vec3<N>& point);

}  // namespace rayaudit
