#pragma once

#include <array>
#include <limits>

#include "scenes/scene.hpp"
#include "scenes/surface.hpp"

namespace rayaudit {

inline constexpr double pi = 3.14159265358979323846;

/// How a light falls on a point: from where, from how far, and how bright on a surface that faces
/// it. It may not fall there at all: the distance is then 0.
template <class N>
struct Falling {
  Vec3<N> direction = {N(0), N(0), N(0)};
  N distance = N(0);
  Colour colour = {0, 0, 0};
};

template <class N>
Falling<N> from_point(const Light& light, const Vec3<N>& point) {
  const Vec3<N> v = in<N>(light.where) - point;
  const N distance = length(v);
  if (!(distance > N(0))) return {};
  const double squared = static_cast<double>(distance) * static_cast<double>(distance);
  return {unit(v), distance, light.colour / squared};
}

/// Two directions square to a third and to each other, each of length 1.
template <class N>
std::array<Vec3<N>, 2> square_to(const Vec3<N>& w) {
  const bool is_upright = std::abs(w.x) > N(0.5);
  const Vec3<N> u =
      unit(cross(is_upright ? Vec3<N>{N(0), N(1), N(0)} : Vec3<N>{N(1), N(0), N(0)}, w));
  return {u, cross(w, u)};
}

/// By one point of the side that faces, drawn evenly in solid angle (Shirley, Wang & Zimmerman,
/// "Monte Carlo techniques for direct lighting calculations", ACM TOG 15(1), 1996, sec. 3.2). From
/// within the sphere no light is seen.
template <class N>
Falling<N> from_sphere(const Light& light, const Sphere<double>& shape, const Vec3<N>& point,
                       const std::array<double, 2>& lot) {
  const Sphere<N> sphere = in<N>(shape);
  const Vec3<N> v = sphere.centre - point;
  const N far = length(v), sine = sphere.radius / far;
  if (!(sine < N(1))) return {};
  const N most = sine * sine / (N(1) + std::sqrt(N(1) - sine * sine));  // 1 - cos of the widest
  const N off = static_cast<N>(lot[0]) * most, sine_off = off * (N(2) - off);
  const double turn = 2 * pi * lot[1];
  const Vec3<N> w = unit(v);
  const std::array<Vec3<N>, 2> aside = square_to(w);
  const Vec3<N> across =
      static_cast<N>(std::cos(turn)) * aside[0] + static_cast<N>(std::sin(turn)) * aside[1];
  const Vec3<N> direction = unit((N(1) - off) * w + std::sqrt(sine_off) * across);
  const N depth = std::sqrt(std::max(N(0), sine * sine - sine_off));
  return {direction, far * ((N(1) - off) - depth),
          2 * pi * static_cast<double>(most) * light.colour};
}

template <class N>
Falling<N> falling(const Light& light, const Scene& scene, const Vec3<N>& point,
                   const std::array<double, 2>& lot) {
  switch (light.kind) {
    case Light::Kind::point:
      return from_point(light, point);
    case Light::Kind::distant:
      return {unit(in<N>(light.where)), std::numeric_limits<N>::infinity(), light.colour};
    case Light::Kind::sphere:
      break;
  }
  const Shape& shape = scene.primitives[light.primitive].shape;
  return from_sphere(light, std::get<Sphere<double>>(shape), point, lot);
}

}  // namespace rayaudit
