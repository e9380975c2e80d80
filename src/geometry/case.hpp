#pragma once

#include "geometry/ray.hpp"
#include "geometry/shapes.hpp"

namespace rayaudit {

/// A ray and a shape: do they meet, and where first? Plain doubles that denote exactly the reals
/// they are; a case for a float subject holds doubles that are floats.
struct Case {
  Ray<double> ray;
  Shape shape;

  friend bool operator==(const Case&, const Case&) = default;
};

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
