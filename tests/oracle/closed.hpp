#pragma once

#include <vector>

#include "geometry/case.hpp"

namespace rayaudit {

/// The same numbers as the closed shape; what is no cylinder or cone stays.
inline Shape closed(const Shape& shape) {
  if (const auto* s = std::get_if<Cylinder<double>>(&shape))
    return CappedCylinder<double>{s->base, s->top, s->radius};
  if (const auto* s = std::get_if<Cone<double>>(&shape))
    return CappedCone<double>{s->base, s->apex, s->radius};
  return shape;
}

/// The cases, and again with their cylinders and cones closed.
inline std::vector<Case> closed_too(std::vector<Case> cases) {
  for (std::size_t i = 0, drawn = cases.size(); i < drawn; ++i)
    if (const Case as_closed = {cases[i].ray, closed(cases[i].shape)}; as_closed != cases[i])
      cases.push_back(as_closed);
  return cases;
}

/// The open shape of a closed one, else the shape itself.
template <class N>
Cylinder<N> opened(const CappedCylinder<N>& s) {
  return {s.base, s.top, s.radius};
}
template <class N>
Cone<N> opened(const CappedCone<N>& s) {
  return {s.base, s.apex, s.radius};
}
template <class S>
const S& opened(const S& shape) {
  return shape;
}

}  // namespace rayaudit
