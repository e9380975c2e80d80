#pragma once

#include <array>

#include "scenes/scene.hpp"

namespace rayaudit {

/// The ray through a place of the picture, in pixels from its left upper corner, worked out in N,
/// float or double.
template <class N>
Ray<N> camera_ray(const Camera& camera, const Film& film, const std::array<double, 2>& place);

}  // namespace rayaudit
