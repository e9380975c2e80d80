#pragma once

#include "families/moderate.hpp"

/// Families in general position: nothing special but where the ray begins or how d was made.
namespace rayaudit::drawing {

template <template <class> class S>
S<double> moderate_shape(Random& random, const Format& format) {
  return rounded<S>(moderate<S>(random, 8.0 * random.in_cube(), 4), format);
}

template <template <class> class S>
Case anywhere(Random& random, const Format& format, int) {
  const auto shape = moderate_shape<S>(random, format);
  const Vec from = middle(shape) + 4 * reach(shape) * random.in_cube();
  return {aimed(random, format, from, target(random, shape)), shape};
}

template <template <class> class S>
Case inside(Random& random, const Format& format, int) {
  const auto shape = moderate_shape<S>(random, format);
  const Vec from = inside_point(random, shape);
  return {{rounded(from, format), rounded(random.in_cube(), format)}, shape};
}

/// The origin is a surface point as the format has it, the direction any: a shadow or a bounce.
template <template <class> class S>
Case spawned(Random& random, const Format& format, int) {
  const auto shape = moderate_shape<S>(random, format);
  const Vec from = surface_point(random, shape);
  return {{rounded(from, format), rounded(random.in_cube(), format)}, shape};
}

/// The ray leaves a ball around the shape, straight away from a point of its surface.
template <template <class> class S>
Case behind(Random& random, const Format& format, int) {
  const auto shape = moderate_shape<S>(random, format);
  const double around = reach(shape);
  const Vec from = middle(shape) + random.vector(1.125 * around, 4 * around);
  Ray<double> ray = aimed(random, format, from, surface_point(random, shape));
  ray.direction = -ray.direction;
  return {ray, shape};
}

/// The direction divided by its length, every operation in N as a renderer does it.
template <class N>
Vec normalised(const Vec& direction) {
  const Vec3<N> d = in<N>(direction);
  using std::sqrt;
  return in<double>(d / sqrt(dot(d, d)));
}

template <template <class> class S>
Case unit(Random& random, const Format& format, int k) {
  Case question = anywhere<S>(random, format, k);
  Vec& direction = question.ray.direction;
  direction = is_float(format) ? normalised<float>(direction) : normalised<double>(direction);
  return question;
}

}  // namespace rayaudit::drawing
