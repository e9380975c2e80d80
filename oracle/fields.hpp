#pragma once

#include <array>
#include <cstddef>

#include "geometry/case.hpp"
#include "oracle/polynomial.hpp"

/// What the law (law.hpp) is about, and its restriction to a ray.
namespace rayaudit::oracle {

/// F = 0 where every G >= 0. One patch of a surface.
template <class F, class G, std::size_t sides>
struct Patch {
  F field;
  std::array<G, sides> side;
};

/// Which side condition of a shape is the apex's: it vanishes on the surface there and nowhere
/// else, and is negative on the mirrored nappe. -1 where there is none.
template <class S>
inline constexpr int apex_side = -1;
template <class N>
inline constexpr int apex_side<Cone<N>> = 1;
template <class N>
inline constexpr int apex_side<CappedCone<N>> = 1;

/// Which side conditions of a shape are closed by a cap, the i-th by bit i: a patch of its own with
/// the field -G_i, negative inside as F is, and the side condition -F >= 0. F, G_i and a cone's h
/// >= 0 then bound a convex solid, and every edge belongs to its cap.
template <class S>
inline constexpr unsigned caps = 0;
template <class N>
inline constexpr unsigned caps<CappedCylinder<N>> = 0b11;
template <class N>
inline constexpr unsigned caps<CappedCone<N>> = 0b01;

template <class S>
constexpr bool is_cap(int i) {
  constexpr unsigned all = caps<S>;
  return (all >> i & 1U) != 0;
}

/// Does the i-th side condition of a shape count? All do but of an endless surface, which keeps its
/// nappe or has both. A closed shape has no such extent.
template <class S>
constexpr bool counts(int i, Extent extent) {
  return caps<S> != 0 || extent == Extent::bounded ||
         (extent == Extent::unbounded && i == apex_side<S>);
}

}  // namespace rayaudit::oracle

#define RAYAUDIT_LAW_NAMESPACE rayaudit::oracle
#include "oracle/law.hpp"
#undef RAYAUDIT_LAW_NAMESPACE

namespace rayaudit::oracle {

/// A number of a case as the constant polynomial that a field takes.
template <class N>
struct AsConstant {
  Polynomial<N, 0> operator()(const N& x) const { return {{x}}; }
  Vec3<Polynomial<N, 0>> operator()(const Vec3<N>& v) const { return {{v.x}, {v.y}, {v.z}}; }
};

/// The field and side conditions of a shape along o + t d, as polynomials in t over N.
template <class N, template <class> class S>
[[gnu::always_inline]] inline auto along_line(const Vec3<N>& o, const Vec3<N>& d,
                                              const S<N>& shape) {
  const Vec3<Polynomial<N, 1>> p = {{{o.x, d.x}}, {{o.y, d.y}}, {{o.z, d.z}}};
  const auto constants =
      std::apply([](const auto&... part) { return S<Polynomial<N, 0>>{AsConstant<N>{}(part)...}; },
                 shape.parts());
  return patch(constants, p);
}

template <class N>
struct AsNumber {
  N operator()(double x) const { return N(x); }
  Vec3<N> operator()(const Vec3<double>& v) const { return {N(v.x), N(v.y), N(v.z)}; }
};

/// The same of a case in doubles.
template <class N, template <class> class S>
[[gnu::always_inline]] inline auto along_ray(const Ray<double>& ray, const S<double>& shape) {
  const AsNumber<N> number;
  return along_line(
      number(ray.origin), number(ray.direction),
      std::apply([&](const auto&... part) { return S<N>{number(part)...}; }, shape.parts()));
}

}  // namespace rayaudit::oracle
