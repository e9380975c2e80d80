#pragma once

#include <cstddef>
#include <span>

#include "geometry/case.hpp"

namespace rayaudit {

/// Where the lines of rays meet spheres, by CGAL's exact spherical kernel; how often they do. The
/// cases are of spheres.
std::size_t meet_by_spherical_kernel(std::span<const Case> cases);

}  // namespace rayaudit
