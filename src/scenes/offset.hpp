#pragma once

#include <span>
#include <string>
#include <string_view>

#include "geometry/format.hpp"
#include "geometry/ray.hpp"

namespace rayaudit {

/// How a ray that leaves a surface is kept from meeting it again at once.
struct Offset {
  enum class Kind : std::uint8_t {
    none,    ///< not at all
    t_min,   ///< answers up to t_min do not count; directions have length 1 but for rounding
    normal,  ///< it starts beside the surface, off by so many ulps of its largest coordinate
    proved,  ///< it starts beside the surface, off by the proved error of its point
  };
  Kind kind = Kind::none;
  double amount = 0;  ///< t_min, or the ulps
  std::string name;   ///< as it is asked for: `none`, `t_min=1e-3`, `normal=16`, `proved`
};

/// The usual ones: none, t_min=1e-4, t_min=1e-3, normal, proved. Throws Error for others.
Offset read_offset(std::string_view text);
std::span<const Offset> usual_offsets();

/// What a ray leaves: the point of its surface as the format has it, o + t d, with the normal there
/// (of length 1 but for rounding, to no side in particular).
struct Departure {
  Vec3<double> point = {0, 0, 0}, normal = {0, 0, 0};
  /// How far the point can lie from the exact one, in world units, where that is proved; else NaN.
  double proved = 0;
};

/// The ray from a departure, worked out in the format (float or double). A proved offset of a
/// point that nothing is proved of is none.
Ray<double> departing(const Departure& departure, const Vec3<double>& direction,
                      const Offset& offset, const Format& format);

}  // namespace rayaudit
