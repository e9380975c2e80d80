#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <variant>

#include "geometry/vec3.hpp"

namespace rayaudit {

/// What a parameter of a shape is: a point moves with the world, a vector turns with it and has a
/// length of no account, a length only scales.
enum class Part { point, vector, length };

/// The flat disk {p : (p - c).n = 0, |p - c| <= r}, rim included; n of any length but 0.
template <class N>
struct Disk {
  Vec3<N> centre, normal;
  N radius;

  static constexpr std::string_view name = "disk";
  static constexpr std::string_view about = "the flat disk, rim included";
  static constexpr std::array kinds = {Part::point, Part::vector, Part::length};
  static constexpr std::array<std::string_view, 3> labels = {"centre", "normal", "radius"};
  auto parts() { return std::tie(centre, normal, radius); }
  auto parts() const { return std::tie(centre, normal, radius); }
  friend bool operator==(const Disk&, const Disk&) = default;
};

/// The sphere |p - c| = r.
template <class N>
struct Sphere {
  Vec3<N> centre;
  N radius;

  static constexpr std::string_view name = "sphere";
  static constexpr std::string_view about = "the surface of the ball";
  static constexpr std::array kinds = {Part::point, Part::length};
  static constexpr std::array<std::string_view, 2> labels = {"centre", "radius"};
  auto parts() { return std::tie(centre, radius); }
  auto parts() const { return std::tie(centre, radius); }
  friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// The lateral surface of the cylinder of radius r from base centre a to top centre b, open at both
/// ends, its two rims included.
template <class N>
struct Cylinder {
  Vec3<N> base, top;
  N radius;

  static constexpr std::string_view name = "cylinder";
  static constexpr std::string_view about = "the lateral surface only, open at both ends";
  static constexpr std::array kinds = {Part::point, Part::point, Part::length};
  static constexpr std::array<std::string_view, 3> labels = {"base", "top", "radius"};
  auto parts() { return std::tie(base, top, radius); }
  auto parts() const { return std::tie(base, top, radius); }
  friend bool operator==(const Cylinder&, const Cylinder&) = default;
};

/// The lateral surface of the cone from a base of centre a and radius r to the apex b: one nappe,
/// base rim and apex included.
template <class N>
struct Cone {
  Vec3<N> base, apex;
  N radius;

  static constexpr std::string_view name = "cone";
  static constexpr std::string_view about =
      "the lateral surface only, one nappe, from base rim to apex";
  static constexpr std::array kinds = {Part::point, Part::point, Part::length};
  static constexpr std::array<std::string_view, 3> labels = {"base", "apex", "radius"};
  auto parts() { return std::tie(base, apex, radius); }
  auto parts() const { return std::tie(base, apex, radius); }
  friend bool operator==(const Cone&, const Cone&) = default;
};

/// The surface of the solid cylinder of radius r from base centre a to top centre b: the lateral
/// surface and two caps, whose rims are edges that close it.
template <class N>
struct CappedCylinder {
  Vec3<N> base, top;
  N radius;

  static constexpr std::string_view name = "capped_cylinder";
  static constexpr std::string_view about = "lateral surface and caps, the surface of a solid";
  static constexpr std::array kinds = {Part::point, Part::point, Part::length};
  static constexpr std::array<std::string_view, 3> labels = {"base", "top", "radius"};
  auto parts() { return std::tie(base, top, radius); }
  auto parts() const { return std::tie(base, top, radius); }
  friend bool operator==(const CappedCylinder&, const CappedCylinder&) = default;
};

/// The surface of the solid cone from a base of centre a and radius r to the apex b: one nappe and
/// the disk that closes it.
template <class N>
struct CappedCone {
  Vec3<N> base, apex;
  N radius;

  static constexpr std::string_view name = "capped_cone";
  static constexpr std::string_view about = "one nappe and its base, the surface of a solid";
  static constexpr std::array kinds = {Part::point, Part::point, Part::length};
  static constexpr std::array<std::string_view, 3> labels = {"base", "apex", "radius"};
  auto parts() { return std::tie(base, apex, radius); }
  auto parts() const { return std::tie(base, apex, radius); }
  friend bool operator==(const CappedCone&, const CappedCone&) = default;
};

/// The list of shapes. A new one is its struct, a word here, its field and its families.
template <class N>
using AnyShape =
    std::variant<Disk<N>, Sphere<N>, Cylinder<N>, Cone<N>, CappedCylinder<N>, CappedCone<N>>;

using Shape = AnyShape<double>;

inline constexpr std::size_t shape_count = std::variant_size_v<Shape>;

/// The names of the shapes, in the order of the list.
inline constexpr std::array<std::string_view, shape_count> shape_names =
    []<std::size_t... I>(std::index_sequence<I...>) {
  return std::array<std::string_view, shape_count>{std::variant_alternative_t<I, Shape>::name...};
}
(std::make_index_sequence<shape_count>{});

inline std::string_view name(const Shape& shape) { return shape_names[shape.index()]; }

/// The same shape in another number; exact where every parameter is a number of M.
template <class M, class N, template <class> class S>
S<M> in(const S<N>& shape) requires requires {
  S<N>::kinds;
}
{
  struct {
    Vec3<M> operator()(const Vec3<N>& part) const { return rayaudit::in<M>(part); }
    M operator()(const N& part) const { return M(part); }
  } convert;
  return std::apply([&](const auto&... part) { return S<M>{convert(part)...}; }, shape.parts());
}

}  // namespace rayaudit
