#include "oracle/position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "oracle/dual.hpp"
#include "oracle/fields.hpp"
#include "oracle/fused.hpp"
#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"

namespace rayaudit::oracle {
namespace {

using Exact = CGAL::Mpzf;

/// How many numbers a shape has.
template <class S>
constexpr std::size_t number_count() {
  std::size_t count = 0;
  for (const Part kind : S::kinds) count += kind == Part::length ? 1 : 3;
  return count;
}

/// A Real in a number that fields are evaluated in.
template <class V>
V in_number(const Real& x);

template <>
[[gnu::always_inline]] inline Bounded in_number(const Real& x) {
  const int e = x.exponent;
  const Bounded sum =
      e == 0 ? double_word::fast_two_sum(x.high, x.middle)
             : double_word::fast_two_sum(std::ldexp(x.high, e), std::ldexp(x.middle, e));
  const double rest = x.low == 0 ? 0 : std::fabs(std::ldexp(x.low, e)) + double_word::underflow;
  return {sum.high, sum.low, e == 0 ? rest : rest + double_word::underflow};
}

template <>
Exact in_number(const Real& x) {
  Exact sum = Exact(x.high) + Exact(x.middle) + Exact(x.low);
  for (int e = x.exponent; e != 0;) {
    const int step = std::clamp(e, -1000, 1000);
    sum = sum * Exact(std::ldexp(1.0, step));
    e -= step;
  }
  return sum;
}

template <class V>
[[gnu::always_inline]] inline Vec3<V> in_number(const Vec3<Real>& p) {
  return {in_number<V>(p.x), in_number<V>(p.y), in_number<V>(p.z)};
}

/// The field of a patch: F, or a cap's.
template <class S, class P>
[[gnu::always_inline]] inline auto field_of(const P& restricted, int patch) {
  if constexpr (caps<S> != 0)
    if (patch != 0) return decltype(restricted.field)(-restricted.side[patch - 1]);
  return restricted.field;
}

/// The field of a patch at a point with its derivatives by the point and, where n has room for
/// them, by the numbers of the shape in their order.
template <class V, std::size_t n, template <class> class S>
[[gnu::always_inline]] inline Dual<V, n> field_at(const S<double>& shape, const Vec3<V>& p,
                                                  int patch_number) {
  using Number = Dual<V, n>;
  std::size_t next = 3;
  const auto variable = [&](double x) __attribute__((always_inline)) {
    return n > 3 ? Number(V(x), next++) : Number(V(x));
  };
  struct Seed {
    decltype(variable)& seed;
    Number operator()(double x) const { return seed(x); }
    Vec3<Number> operator()(const Vec3<double>& v) const {
      return {seed(v.x), seed(v.y), seed(v.z)};
    }
  };
  const auto numbers = std::apply(
      [&](const auto&... part) { return S<Number>{Seed{variable}(part)...}; }, shape.parts());
  const Vec3<Number> point = {Number(p.x, 0), Number(p.y, 1), Number(p.z, 2)};
  return field_of<S<double>>(patch(numbers, point), patch_number);
}

/// |F| / |grad F| in exact numbers: sqrt(F^2 g) / g with g = |grad F|^2.
Position exact_position(const Shape& shape, const Vec3<Real>& point, int patch) {
  return std::visit(
      [&](const auto& s) -> Position {
        const Dual<Exact, 3> f = field_at<Exact, 3>(s, in_number<Exact>(point), patch);
        const Exact g = f.by[0] * f.by[0] + f.by[1] * f.by[1] + f.by[2] * f.by[2];
        const double undefined = std::numeric_limits<double>::quiet_NaN();
        if (g.sign() == 0) return {f.value.sign(), {undefined, 0, 0, 0}};
        if (f.value.sign() == 0) return {0, {}};
        return {f.value.sign(),
                value(Radical{.p = 0, .d = f.value * f.value * g, .q = g, .e = 1}, 60)};
      },
      shape);
}

bool usable(double x) { return std::isfinite(x) && x > 0x1p-900; }

/// Sum |x_j dF/dx_j| over the numbers of a case at t, and dF/dt: t moves by their ratio. dF/dt
/// vanishes towards a double root, where a sum of slopes would cancel; so it is that of F(o + t d).
template <class V>
struct Motion {
  typename SlopeOf<V>::type by_inputs = typename SlopeOf<V>::type(0);
  V by_t = V(0);
};

template <class V>
[[gnu::always_inline]] inline V slope(const Polynomial<V, 1>& f, const V&) {
  return f.c[1];
}
template <class V>
[[gnu::always_inline]] inline V slope(const Polynomial<V, 2>& f, const V& t) {
  return f.c[1] + twice(V(f.c[2] * t));
}

template <class V, class S>
[[gnu::always_inline]] inline V slope(const Ray<double>& ray, const S& shape, int patch_number,
                                      const V& t) {
  const auto restricted = along_ray<V>(ray, shape);
  if constexpr (caps<S> != 0)
    if (patch_number != 0) return -restricted.side[patch_number - 1].c[1];
  return slope(restricted.field, t);
}

template <class V>
[[gnu::always_inline]] inline V size(const V& x) {
  return x < V(0) ? V(-x) : x;
}

template <class V, template <class> class S>
[[gnu::always_inline]] inline auto motion(const Ray<double>& ray, const S<double>& shape,
                                          int patch_number, const V& t) {
  constexpr std::size_t n = 3 + number_count<S<double>>();
  using Slope = typename SlopeOf<V>::type;
  const auto& [o, d] = std::tie(ray.origin, ray.direction);
  const Vec3<V> p = {V(o.x) + t * V(d.x), V(o.y) + t * V(d.y), V(o.z) + t * V(d.z)};
  const auto by = field_at<V, n>(shape, p, patch_number).by;
  Motion<V> sum;
  sum.by_t = slope<V>(ray, shape, patch_number, t);
  const Slope lead = leading(t);
  const auto along = [&](double origin, double direction, const Slope& by_point) {
    sum.by_inputs =
        sum.by_inputs + size(Slope(origin) * by_point) + size(lead * Slope(direction) * by_point);
  };
  along(o.x, d.x, by[0]), along(o.y, d.y, by[1]), along(o.z, d.z, by[2]);
  std::size_t next = 3;
  const auto add = [&](double x) { sum.by_inputs = sum.by_inputs + size(Slope(x) * by[next++]); };
  const auto each = [&](const auto& part) {
    if constexpr (requires { part.x; })
      add(part.x), add(part.y), add(part.z);
    else
      add(part);
  };
  std::apply([&](const auto&... part) { (each(part), ...); }, shape.parts());
  return sum;
}

/// The sign of F on both sides of a double root; 0 where the field has none along the ray.
int sign_about_double_root(const Polynomial<Exact, 1>&) { return 0; }
int sign_about_double_root(const Polynomial<Exact, 2>& f) {
  const auto& [c, b, a] = f.c;
  return (b * b - twice(twice(Exact(a * c)))).sign() == 0 ? a.sign() : 0;
}

/// The sign of F beyond both of its roots.
int sign_outside(const Polynomial<Exact, 1>&) { return 0; }
int sign_outside(const Polynomial<Exact, 2>& f) { return f.c[2].sign(); }

constexpr Sensitivity at_double_root(int sign) {
  return {{std::numeric_limits<double>::infinity(), 0, 0, 0}, sign};
}

/// Before a double root of F the sign of F is that about it; but at the apex of a closed cone a
/// steep line comes from outside or inside, as h rises or falls, whatever the mirrored nappe has
/// it.
template <class S, class P>
int sign_before_double_root(const P& restricted, int about) {
  if constexpr (caps<S> != 0 && apex_side<S> >= 0)
    if (about < 0) return restricted.side[apex_side<S>].c[1].sign();
  return about;
}

Sensitivity exact_sensitivity(const Case& question, const Crossing& crossing) {
  return std::visit(
      [&](const auto& shape) -> Sensitivity {
        using S = std::remove_cvref_t<decltype(shape)>;
        const auto restricted = along_ray<Exact>(question.ray, shape);
        const auto& field = restricted.field;
        if (crossing.patch == 0)
          if (const int sign = sign_about_double_root(field); sign != 0)
            return at_double_root(sign_before_double_root<S>(restricted, sign));
        const Motion<Exact> sum =
            motion<Exact>(question.ray, shape, crossing.patch, in_number<Exact>(crossing.t));
        // Two roots so near each other that t does not tell them apart: between them there is
        // nothing.
        if (sum.by_t.sign() == 0) return at_double_root(sign_outside(field));
        return {value(Radical{.p = sum.by_inputs, .q = size(sum.by_t)}, 60), -sum.by_t.sign()};
      },
      question.shape);
}

}  // namespace

Position position(const Shape& shape, const Vec3<Real>& point, int patch) {
  int sign = 0;
  double distance = 0;
  run_fused([&]() __attribute__((always_inline)) {
    with_shape(
        shape, [&](const auto& s) __attribute__((always_inline)) {
          const Dual<Bounded, 3> f = field_at<Bounded, 3>(s, in_number<Bounded>(point), patch);
          const double g = f.by[0] * f.by[0] + f.by[1] * f.by[1] + f.by[2] * f.by[2];
          if (usable(g) && known_to(f.value, 0x1p-34)) sign = proved_sign(f.value);
          distance = std::fabs(f.value.high) / std::sqrt(g);
        });
  });
  if (sign == 0 || !usable(distance)) return exact_position(shape, point, patch);
  return {sign, {distance, 0, 0, 0}};
}

Sensitivity sensitivity(const Case& question, const Crossing& crossing) {
  // There t has no derivative, and the line lies in F >= 0 but where it goes on into another nappe.
  const bool is_apex = crossing.kind == Kind::apex && question.extent != Extent::both_nappes;
  if (crossing.kind == Kind::tangent || is_apex) return at_double_root(1);
  if (!is_moderate(question)) return exact_sensitivity(question, crossing);
  Motion<Bounded> sum;
  run_fused([&]() __attribute__((always_inline)) {
    with_shape(
        question.shape, [&](const auto& shape) __attribute__((always_inline)) {
          sum =
              motion<Bounded>(question.ray, shape, crossing.patch, in_number<Bounded>(crossing.t));
        });
  });
  const double forced = sum.by_inputs / std::fabs(sum.by_t.high);
  if (!usable(forced) || !known_to(sum.by_t, 0x1p-34)) return exact_sensitivity(question, crossing);
  return {{forced, 0, 0, 0}, -proved_sign(sum.by_t)};
}

Real projection(const Ray<double>& ray, const Vec3<Real>& point, int bits) {
  const auto along = [&]<class V>(const Vec3<V>& p) {
    const auto& [o, d] = std::tie(ray.origin, ray.direction);
    const Vec3<V> toward = {V(d.x), V(d.y), V(d.z)};
    return std::pair<V, V>(inner(from(Vec3<V>{V(o.x), V(o.y), V(o.z)}, p), toward),
                           inner(toward, toward));
  };
  const auto [reach, length] = along(in_number<Bounded>(point));
  const Bounded t = reach / length;
  if (known_to(t, std::ldexp(1.0, -bits))) return {t.high, t.low, 0, 0};
  const auto [exact_reach, exact_length] = along(in_number<Exact>(point));
  return value(Radical{.p = exact_reach, .q = exact_length}, bits);
}

}  // namespace rayaudit::oracle
