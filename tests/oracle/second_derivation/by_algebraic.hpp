#pragma once

#include <CGAL/Exact_algebraic.h>

#include "tests/oracle/second_derivation/derived.hpp"

/// Cylinder and cone in algebraic numbers (CORE::Expr), from the definition by cross products:
/// |v x w| = r |w| on the cylinder, |v x w| |w| = r h on the cone. Not for threads.
namespace rayaudit::second {

using Algebraic = CGAL::Exact_algebraic;

inline Algebraic algebraic(const Rational& q) {
  return Algebraic(
      CORE::BigRat(CORE::BigInt(q.numerator().mpz()), CORE::BigInt(q.denominator().mpz())));
}

inline Number number(const Algebraic& t) {
  return [t](const Rational& q) { return static_cast<int>(CGAL::compare(t, algebraic(q))); };
}

/// a t^2 + 2 b t + c.
struct Quadratic {
  Algebraic a, b, c;

  bool is_zero() const { return a == 0 && b == 0 && c == 0; }
  bool has_double_root() const { return a != 0 && b * b == a * c; }
};

/// The roots in order, a double one once; not for zero.
inline std::vector<Algebraic> real_roots(const Quadratic& quadratic) {
  const auto& [a, b, c] = quadratic;
  if (a == 0) return b == 0 ? std::vector<Algebraic>{} : std::vector<Algebraic>{-c / (2 * b)};
  const Algebraic discriminant = b * b - a * c;
  if (discriminant < 0) return {};
  if (discriminant == 0) return {-b / a};
  const Algebraic root = sqrt(discriminant);
  const Algebraic one = (-b - root) / a, other = (-b + root) / a;
  return a > 0 ? std::vector<Algebraic>{one, other} : std::vector<Algebraic>{other, one};
}

/// From the base of a cylinder or cone: v = v0 + t d along the ray, w to the top or apex.
struct FromBase {
  Vec3<Algebraic> v0, d, w;

  FromBase(const Ray<double>& ray, const Vec3<double>& from, const Vec3<double>& to)
      : v0(in<Algebraic>(ray.origin) - in<Algebraic>(from)),
        d(in<Algebraic>(ray.direction)),
        w(in<Algebraic>(to) - in<Algebraic>(from)) {}

  Vec3<Algebraic> v(const Algebraic& t) const { return v0 + t * d; }
};

/// A ray and a cylinder or cone, the ray as v from the base.
struct Placed {
  FromBase line;
  Algebraic r;
  bool cone;

  Algebraic h(const Algebraic& t) const { return dot(line.w, line.w) - dot(line.v(t), line.w); }

  /// Both sides of the definition squared, as a function of t.
  Quadratic squared() const {
    const auto& [v0, d, w] = line;
    const Vec3<Algebraic> p = cross(v0, w), q = cross(d, w);
    const Algebraic ww = dot(w, w), h0 = h(0), h1 = -dot(d, w), rr = r * r;
    if (!cone) return {dot(q, q), dot(p, q), dot(p, p) - rr * ww};
    return {dot(q, q) * ww - rr * h1 * h1, dot(p, q) * ww - rr * h0 * h1,
            dot(p, p) * ww - rr * h0 * h0};
  }
};

inline Placed placed(const Case& question) {
  // CORE's floating-point filter is blind to underflow (tried: at 2^-700 it takes signs for 0), and
  // its root, when made finer, asserts a sign of what it had before.
  CORE::setFpFilterFlag(false);
  CORE::setIncrementalEvalFlag(false);
  const Ray<double>& ray = question.ray;
  if (const auto* s = std::get_if<Cylinder<double>>(&question.shape))
    return {{ray, s->base, s->top}, s->radius, false};
  const auto& s = std::get<Cone<double>>(question.shape);
  return {{ray, s.base, s.apex}, s.radius, true};
}

inline Crossings on_line(const Placed& shape) {
  using oracle::Kind;
  const Vec3<Algebraic>& w = shape.line.w;
  const Quadratic squared = shape.squared();
  if (squared.is_zero()) {
    const Algebraic rise = dot(shape.line.d, w);
    const Algebraic at_base = -dot(shape.line.v0, w) / rise, at_top = shape.h(0) / rise;
    const bool rising = rise > 0;
    return {{Kind::within, number(rising ? at_base : at_top), number(rising ? at_top : at_base)}};
  }
  Crossings found;
  for (const Algebraic& t : real_roots(squared)) {
    const Vec3<Algebraic> v = shape.line.v(t);
    const int above_base = CGAL::sign(dot(v, w)), below_top = CGAL::sign(shape.h(t));
    if (above_base < 0 || below_top < 0) continue;
    Kind kind = squared.has_double_root() ? Kind::tangent : Kind::proper;
    if (above_base == 0 || below_top == 0) kind = Kind::rim;
    // A line through the apex is outside unless it leans less than the generators:
    // |d x w| |w| < r |d.w|.
    if (shape.cone && v == w) kind = squared.a > 0 ? Kind::apex : Kind::proper;
    found.push_back({kind, number(t)});
  }
  return found;
}

inline Crossings by_algebraic(const Case& question) {
  return cut_to_range(on_line(placed(question)), question.ray);
}

}  // namespace rayaudit::second
