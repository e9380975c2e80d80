#pragma once

#include <string_view>
#include <vector>

#include "geometry/case.hpp"

namespace rayaudit {

/// A root of F along the line of a ray, for a picture: t to nearest, and what it is.
struct Along {
  double t, t_last;       ///< of a stretch within the surface where it ends, else t again
  std::string_view kind;  ///< proper, a kind of touch, or why it is no crossing that counts
};

/// The crossings of a case, then the other roots along its line; nothing where the case is invalid.
std::vector<Along> along(const Case& question);

}  // namespace rayaudit
