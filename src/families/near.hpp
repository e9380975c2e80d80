#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <type_traits>

#include "families/degenerate.hpp"
#include "families/family.hpp"

/// Families that lie just off a degenerate case.
namespace rayaudit::drawing {

/// The number so many numbers of N further from 0; a zero moves as a one would.
template <class N>
double stepped(double x, std::int64_t steps) {
  using Bits = std::conditional_t<sizeof(N) == 4, std::int32_t, std::int64_t>;
  const N from = static_cast<N>(x);
  if (from == 0) return std::ldexp(static_cast<double>(steps), 1 - format_of<N>.precision);
  const Bits magnitude = std::bit_cast<Bits>(std::abs(from));
  return static_cast<double>(
      std::copysign(std::bit_cast<N>(static_cast<Bits>(magnitude + steps)), from));
}

inline double stepped(double x, std::int64_t steps, const Format& format) {
  return is_float(format) ? stepped<float>(x, steps) : stepped<double>(x, steps);
}

/// A case with one of its first numbers moved by 2^k ulps, up or down.
inline Case nudged(Random& random, const Format& format, int k, Case question, int numbers) {
  const std::int64_t steps = random.either(std::int64_t{1} << k);
  auto left = random.below(numbers);
  each_number(question, [&](double& x) {
    if (left-- == 0) x = stepped(x, steps, format);
  });
  return question;
}

/// A case of a degenerate family with one number moved by 2^k ulps: three in four times one of the
/// ray, whose every number counts, else any (the radius, say, is of no account at an apex).
template <Draw degenerate>
Case near(Random& random, const Format& format, int k) {
  const Case question = degenerate(random, format, 0);
  int numbers = 0;
  each_number(question, [&](const double&) { ++numbers; });
  return nudged(random, format, k, question, random.one_in(4) ? numbers : 6);
}

/// A direction of length 1 that is exactly parallel up to rounding: to the plane of a disk, to the
/// axis of a cylinder, to a generator of a cone or (one in four) its axis.
inline Vec parallel_direction(Random& random, const Disk<double>& shape) {
  return radial(random, shape.normal, 1, 1);
}
template <class S>
Vec parallel_direction(Random& random, const S& shape) {
  Vec along = axis(shape);
  if (std::is_same_v<S, Cone<double>> && !random.one_in(4))
    along = along - radial(random, along, shape.radius, shape.radius);
  return random.either(1 / length(along)) * along;
}

/// Turned away from parallel by an angle of 2^-k or less; near half hit.
template <template <class> class S>
Case parallel_near(Random& random, const Format& format, int k) {
  const auto shape = rounded<S>(moderate<S>(random, 4.0 * random.in_cube(), 4), format);
  const Vec parallel = parallel_direction(random, shape);
  const Vec turned = parallel + std::ldexp(1.0, -k) * random.in_cube();
  const Vec direction = rounded(random.between(0.25, 1) * turned, format);
  const Vec to = target(random, shape);
  const double steps = 4 * reach(shape) * random.between(0.25, 1);
  return {{rounded(to - steps * direction, format), direction}, shape};
}

/// An eye 2 above a planet of radius 6.4e6, at the world origin, below it, or anywhere.
inline Case planet(Random& random, const Format& format) {
  constexpr double radius = 6.4e6;
  const auto kind = random.below(3);
  Vec centre = {0, kind == 1 ? -radius : 0, 0};
  if (kind == 2) centre = rounded(radius * random.in_cube(), format);
  const Vec up = kind == 1 ? Vec{0, radius + 2, 0} : random.vector(radius + 2, radius + 2);
  const Vec direction = rounded(random.in_cube(), format);
  return {{rounded(centre + up, format), direction}, Sphere<double>{centre, radius}};
}

/// The origin 2^k ulps off the surface, and one sphere in four a planet.
template <template <class> class S>
Case surface_near(Random& random, const Format& format, int k) {
  if (same<S, Sphere> && random.one_in(4)) return planet(random, format);
  return nudged(random, format, k, surface<S>(random, format, 0), 3);
}

/// Past a tangent, or the rim of a disk, where the radius is then 2^-k of itself larger or smaller.
template <template <class> class S>
Case grazing(Random& random, const Format& format, int k) {
  Case question = {};
  if constexpr (same<S, Disk>)
    question = rim<S>(random, format, 0);
  else
    question = tangent<S>(random, format, 0);
  double& radius = std::get<S<double>>(question.shape).radius;
  radius = rounded(radius * (1 + random.either(std::ldexp(1.0, -k))), format);
  return question;
}

}  // namespace rayaudit::drawing
