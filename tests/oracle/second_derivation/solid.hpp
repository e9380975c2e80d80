#pragma once

#include "tests/oracle/second_derivation/derived.hpp"

/// The surface of a solid by what lies between: a line passes it where it is inside on one side and
/// outside on the other, touches it where it is outside on both, and lies in it where what lies
/// between two of its points is on it. No convexity is made use of.
namespace rayaudit::second {

/// Where a point stands: outside the solid, on its surface, inside.
enum class Place { outside, on, inside };

/// A point of the line where it may come to the surface: what a single point is to be called if the
/// line is outside about it.
struct Candidate {
  Number t;
  Place place;
  oracle::Kind touch;
};

/// The crossings of a line, from its candidates in order, all different, and where the line stands
/// between them: between[i] is before the i-th, the last after all.
inline Crossings on_line(const std::vector<Candidate>& candidates,
                         const std::vector<Place>& between) {
  Crossings found;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto& [t, place, touch] = candidates[i];
    if (between[i] == Place::on) {
      found.back().kind = oracle::Kind::within;
      found.back().t_last = t;
    } else if (place == Place::on) {
      const bool passes = (between[i] == Place::inside) != (between[i + 1] == Place::inside);
      found.push_back({passes ? oracle::Kind::proper : touch, t});
    }
  }
  return found;
}

}  // namespace rayaudit::second
