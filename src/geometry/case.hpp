#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "geometry/ray.hpp"
#include "geometry/shapes.hpp"

namespace rayaudit {

/// How much of its surface a case asks about, which matters to a shape that has side conditions
/// and is not closed.
enum class Extent : std::uint8_t {
  bounded,     ///< the shape as it is
  unbounded,   ///< without ends: the plane of a disk, an endless cylinder, an endless nappe
  both_nappes  ///< the same, and of a cone the mirrored nappe too: the field alone
};

/// A ray and a shape: do they meet, and where first? Plain doubles that denote exactly the reals
/// they are; a case for a float subject holds doubles that are floats.
struct Case {
  Ray<double> ray;
  Shape shape;
  Extent extent = Extent::bounded;

  friend bool operator==(const Case&, const Case&) = default;
};

/// Has a shape side conditions that an extent takes away?
inline bool has_extent(const Shape& shape) {
  return std::holds_alternative<Disk<double>>(shape) ||
         std::holds_alternative<Cylinder<double>>(shape) ||
         std::holds_alternative<Cone<double>>(shape);
}

/// The words of an extent on a case line; empty for a shape as it is.
constexpr std::array<std::string_view, 3> extent_words = {"", "unbounded", "both_nappes"};

inline std::string_view word(Extent extent) {
  return extent_words[static_cast<std::size_t>(extent)];
}

/// Calls visit(number) for every number of the case but its range: origin, direction, then the
/// parameters of the shape in their order.
template <class C, class V>
void each_number(C& question, V&& visit) {
  const auto components = [&](auto& v) { visit(v.x), visit(v.y), visit(v.z); };
  components(question.ray.origin);
  components(question.ray.direction);
  std::visit(
      [&](auto& shape) {
        std::apply(
            [&](auto&... part) {
              const auto each = [&](auto& p) {
                if constexpr (requires { p.x; })
                  components(p);
                else
                  visit(p);
              };
              (each(part), ...);
            },
            shape.parts());
      },
      question.shape);
}

}  // namespace rayaudit
