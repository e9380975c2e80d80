#pragma once

#include <initializer_list>

#include "geometry/vec3.hpp"

namespace rayaudit {

/// The largest power of two that is at most size; 1 where size is not positive. Dividing by it
/// rounds nothing, so a shape is brought to a size near 1 for free, and squares stay in range.
template <class N>
N power_of_two(const N& size) {
  N power = N(1);
  if (!(size > N(0))) return power;
  for (const N& step : {N(4294967296.0), N(2)}) {
    // The second halves of the conditions end the loops at infinity and before 0.
    while (power * step <= size && power < power * step) power = power * step;
    while (power > size && power / step > N(0)) power = power / step;
  }
  return power;
}

/// The largest component of v, taken absolutely.
template <class N>
N largest_component(const Vec3<N>& v) {
  const N x = v.x < N(0) ? -v.x : v.x;
  const N y = v.y < N(0) ? -v.y : v.y;
  const N z = v.z < N(0) ? -v.z : v.z;
  const N& xy = x < y ? y : x;
  return xy < z ? z : xy;
}

}  // namespace rayaudit
