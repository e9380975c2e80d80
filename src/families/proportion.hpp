#pragma once

#include <algorithm>

#include "families/moderate.hpp"

/// Families whose lengths are out of proportion: to each other, to the place, to the format.
namespace rayaudit::drawing {

/// The origin 2^k radii away from the shape.
template <template <class> class S>
Case far(Random& random, const Format& format, int k) {
  const auto shape = rounded<S>(moderate<S>(random, random.in_cube(), 4), format);
  const Vec direction = rounded(random.in_cube(), format);
  const double steps = std::ldexp(shape.radius * random.between(0.75, 1.5), k) / length(direction);
  const Vec origin = target(random, shape) - steps * direction;
  return {{rounded(origin, format), direction}, shape};
}

/// All of it 1e6 to 1e8 from the world origin, which is 2^k times its size.
template <template <class> class S>
Case placement(Random& random, const Format& format, int k) {
  const double least = random.one_in(2) ? 1e6 : 1e7;
  const Vec place = random.vector(least, 10 * least);
  const auto shape = rounded<S>(moderate<S>(random, place, std::ldexp(length(place), -k)), format);
  const Vec from = middle(shape) + 4 * reach(shape) * random.in_cube();
  return {aimed(random, format, from, target(random, shape)), shape};
}

/// The height is 2^k radii, and most rays pass close by.
template <template <class> class S>
Case slender(Random& random, const Format& format, int k) {
  const double radius = random.between(0.25, 1);
  const Vec base = random.in_cube();
  const double height = std::ldexp(radius, k);
  const Vec axis = random.vector(height, height);
  const auto shape = rounded<S>(S<double>{base, base + axis, radius}, format);
  const double near = random.between(0, 1);
  const double aim =
      random.one_in(4) ? random.between(0, 1) : near + std::ldexp(4 * random.symmetric(), -k);
  const double most = random.one_in(2) ? 1 : 4;
  const Vec to = point_at(random, shape, aim, 1, most);
  const Vec from = shape.base + near * (to - shape.base) + 8 * radius * random.in_cube();
  return {aimed(random, format, from, to), shape};
}

/// The height is 2^-k radii.
template <template <class> class S>
Case flat(Random& random, const Format& format, int k) {
  const double radius = random.between(0.25, 1);
  const Vec base = radius * random.in_cube();
  const double height = std::ldexp(radius, -k);
  const Vec axis = random.vector(height, height);
  const auto shape = rounded<S>(S<double>{base, base + axis, radius}, format);
  const Vec from = base + 4 * radius * random.in_cube();
  return {aimed(random, format, from, target(random, shape)), shape};
}

/// |d| about 2^k or 2^-k.
template <template <class> class S>
Case length(Random& random, const Format& format, int k) {
  const auto shape = rounded<S>(moderate<S>(random, 8.0 * random.in_cube(), 4), format);
  const Vec origin = rounded(middle(shape) + 4 * reach(shape) * random.in_cube(), format);
  const Vec way = target(random, shape) - origin;
  const int exponent = random.either(k);
  const double factor = std::ldexp(random.between(1, 2) / length(way), exponent);
  return {{origin, rounded(factor * way, format)}, shape};
}

/// The exponent e, held where numbers of moderate size times 2^e neither overflow nor lose all
/// bits.
inline int held(int e, const Format& format) {
  return std::clamp(e, format.tiny_exponent() + 12, format.max_exponent - 6);
}

/// Numbers 2^k or 2^-k times what is moderate: all alike, the direction apart, each part apart, or
/// each number.
template <template <class> class S>
Case scale(Random& random, const Format& format, int k) {
  auto shape = moderate<S>(random, 4.0 * random.in_cube(), 4);
  const Vec from = middle(shape) + 2 * reach(shape) * random.in_cube();
  Ray<double> ray = aimed(random, double_format, from, target(random, shape));
  const auto extreme = [&] { return held(random.either(k), format); };
  const auto within = [&] { return held(static_cast<int>(random.whole(-k, k)), format); };
  const int all = extreme();
  const auto kind = random.below(4);
  const auto whole = [&] { return kind < 2 ? all : within(); };
  const auto number = [&](double& x, int e) {
    x = rounded(std::ldexp(x, kind == 3 ? within() : e), format);
  };
  const auto part = [&](auto& p, int e) {
    if constexpr (requires { p.x; })
      number(p.x, e), number(p.y, e), number(p.z, e);
    else
      number(p, e);
  };
  const int shape_exponent = whole();
  std::apply([&](auto&... p) { (part(p, shape_exponent), ...); }, shape.parts());
  part(ray.origin, whole());
  part(ray.direction, kind == 1 ? within() : whole());
  return {ray, shape};
}

}  // namespace rayaudit::drawing
