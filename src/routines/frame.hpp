#pragma once

#include <cmath>

#include "geometry/vec3.hpp"

namespace rayaudit {

/// Three vectors of length 1, square to one another.
template <class N>
struct Frame {
  Vec3<N> x, y, z;
};

/// A frame whose y points along the axis. Duff, Burgess, Christensen, Hery, Kensler, Liani &
/// Villemin, "Building an Orthonormal Basis, Revisited", JCGT 6(1), 2017; their n is our y.
template <class N>
Frame<N> frame_along(const Vec3<N>& axis) {
  using std::sqrt;
  const N length = sqrt(dot(axis, axis));
  const Vec3<N> n = axis / length;
  const N sign = n.z < N(0) ? -N(1) : N(1);
  const N a = -N(1) / (sign + n.z);
  const N b = n.x * n.y * a;
  return {{N(1) + sign * n.x * n.x * a, sign * b, -sign * n.x}, n, {b, sign + n.y * n.y * a, -n.y}};
}

}  // namespace rayaudit
