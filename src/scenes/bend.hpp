#pragma once

#include "scenes/surface.hpp"

/// How a surface turns a ray: directions and normals have length 1 but for rounding.
namespace rayaudit {

/// The mirrored direction; the side of the normal does not matter.
template <class N>
Vec3<N> mirrored(const Vec3<N>& direction, const Vec3<N>& normal) {
  return unit(direction - N(2) * dot(direction, normal) * normal);
}

/// What a boundary of two dielectrics does with a ray.
template <class N>
struct Bend {
  bool is_total = false;  ///< all of it is reflected
  Vec3<N> refracted = {N(0), N(0), N(0)};
  double reflected_share = 1;  ///< of its light
};

/// By Snell's law and Fresnel's equations for light that is not polarised (Born & Wolf, "Principles
/// of Optics", 7th ed., sec. 1.5). The normal points to the outer side; the index is that of the
/// inner side over that of the outer. Radiance is not scaled by the square of the index: what goes
/// in comes out again.
template <class N>
Bend<N> bend(const Vec3<N>& direction, const Vec3<N>& normal, N index) {
  const bool goes_in = dot(direction, normal) < N(0);
  const Vec3<N> facing = goes_in ? normal : -normal;
  const N ratio = goes_in ? N(1) / index : index;
  const N in = std::min(N(1), -dot(direction, facing));
  const N out_squared = N(1) - ratio * ratio * (N(1) - in * in);
  if (!(out_squared > N(0))) return {true};
  const N out = std::sqrt(out_squared);
  const N across = (ratio * in - out) / (ratio * in + out);
  const N within = (in - ratio * out) / (in + ratio * out);
  return {false, unit(ratio * direction + (ratio * in - out) * facing),
          static_cast<double>((across * across + within * within) / N(2))};
}

}  // namespace rayaudit
