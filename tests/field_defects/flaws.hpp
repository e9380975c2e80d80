#pragma once

#include <cmath>
#include <optional>
#include <string_view>

#include "routines/cone_nappe.hpp"
#include "routines/nearby.hpp"
#include "routines/stable_roots.hpp"
#include "routines/textbook.hpp"
#include "tests/oracle/replay/planted.hpp"

/// The flaws that public bug reports tell of, each in a routine that is sound but for it. Those
/// that planted.hpp has are not repeated.
namespace rayaudit::flaws {

using planted::Coefficients;
using planted::coefficients;
using planted::Sides;
using planted::sides;

/// The quadratic of a sphere that is brought near, and its discriminant from the distance between
/// centre and line, which does not cancel.
template <class N>
struct Approach {
  Nearby<N> line;
  N a, b, c, discriminant;
};
template <class N>
Approach<N> approach(const Ray<N>& ray, const Sphere<N>& sphere) {
  const Nearby<N> line(ray, sphere.centre, sphere.radius);
  const Vec3<N>&f = line.from, &d = line.direction;
  const N rr = line.radius * line.radius;
  const N a = dot(d, d), half_b = dot(f, d);
  const Vec3<N> beside = f - (half_b / a) * d;
  return {line, a, N(2) * half_b, dot(f, f) - rr, N(4) * a * (rr - dot(beside, beside))};
}

/// The handout, exercise 5.2: b^2 - 4ac with the half of b.
struct HalfOfB {
  static constexpr std::string_view name = "half_of_b";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    using std::sqrt;
    const auto [a, b, c] = coefficients(ray, sphere);
    const N half = b / N(2);
    const N discriminant = half * half - N(4) * a * c;
    if (discriminant < N(0)) return {};
    const N root = sqrt(discriminant);
    return first_root(ray, {(-b - root) / (N(2) * a), (-b + root) / (N(2) * a)});
  }
};

/// arborx/ArborX#461: q = -(b + sign(b) sqrt(D)) / 2 with sign(0) = 0.
struct SignOfZero {
  static constexpr std::string_view name = "sign_of_zero";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    using std::sqrt;
    const Approach<N> at = approach(ray, sphere);
    if (at.discriminant < N(0)) return {};
    const N sign = at.b > N(0) ? N(1) : at.b < N(0) ? N(-1) : N(0);
    const N q = -(at.b + sign * sqrt(at.discriminant)) / N(2);
    return first_root(ray, {at.line.home(q / at.a), at.line.home(at.c / q)});
  }
};

/// g-truc/glm#578: of rays that face the disk, those with d.n < epsilon for d.n < -epsilon, and so
/// parallel ones.
struct EpsilonOfTheWrongSign {
  static constexpr std::string_view name = "epsilon_of_the_wrong_sign";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Disk<N>& disk) const {
    const N epsilon = N(0x1p-52);
    const N facing = dot(ray.direction, disk.normal);
    const Vec3<N> n = facing > N(0) ? -disk.normal : disk.normal;
    const N across = dot(ray.direction, n);
    if (!(across < epsilon)) return {};
    const N t = dot(disk.centre - ray.origin, n) / across;
    if (t <= ray.t_min || t > ray.t_max) return {};
    const Vec3<N> v = ray.origin + t * ray.direction - disk.centre;
    if (dot(v, v) > disk.radius * disk.radius) return {};
    return t;
  }
};

/// turanszkij/WickedEngine#1695: the far root is found, and told to nobody.
struct NearRootOnly {
  static constexpr std::string_view name = "near_root_only";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const auto [a, b, c] = coefficients(ray, sphere);
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots || !in_range(ray, roots->one)) return {};
    return roots->one;
  }
};

/// rustgd/collision-rs#97, SlimDX#493, GeometricTools#20: d.d is taken for 1.
struct SquareOfLengthLeftOut {
  static constexpr std::string_view name = "square_of_length_left_out";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Vec3<N> v = ray.origin - sphere.centre;
    const N b = N(2) * dot(v, ray.direction);
    const N c = dot(v, v) - sphere.radius * sphere.radius;
    const std::optional<Roots<N>> roots = quadratic_formula(N(1), b, c);
    if (!roots) return {};
    return first_root(ray, *roots);
  }
};

/// ziotom78/pytracer#22: b^2 - 4ac, which loses the radius at a distance, tells whether there is a
/// hit.
struct RadiusLostAtADistance {
  static constexpr std::string_view name = "radius_lost_at_a_distance";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    const Approach<N> at = approach(ray, sphere);
    if (at.b * at.b - N(4) * at.a * at.c < N(0)) return {};
    const N held = at.discriminant < N(0) ? N(0) : at.discriminant;
    const std::optional<Roots<N>> roots = stable_roots<N>(at.a, at.b, at.c, held);
    if (!roots) return {};
    return first_root(ray, {at.line.home(roots->one), at.line.home(roots->other)});
  }
};

/// mccode-dev/McCode#986: the ray is seen not to be parallel to the axis, and then divided by the
/// square of what tells so, which can be 0; what refuses roots does not refuse NaN.
struct SquareUnderflows {
  static constexpr std::string_view name = "square_underflows";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    using std::sqrt;
    const Nearby<N> line(ray, cylinder.base, cylinder.radius);
    const Axis<N> axis(cylinder.base, cylinder.top, line.length);
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const Vec3<N> beside = cross(d, w), off = cross(f, w);
    if (beside.x == N(0) && beside.y == N(0) && beside.z == N(0)) return {};
    const N ww = dot(w, w);
    const N a = dot(beside, beside), half_b = dot(off, beside);
    const N c = dot(off, off) - line.radius * line.radius * ww;
    const N discriminant = half_b * half_b - a * c;
    if (discriminant < N(0)) return {};
    const N root = sqrt(discriminant);
    const Roots<N> roots = {(-half_b - root) / a, (-half_b + root) / a};
    for (const N& here : {roots.one, roots.other}) {
      const N height = dot(f, w) + here * dot(d, w), t = line.home(here);
      if (height < N(0) || height > ww * axis.length || t <= ray.t_min || t >= ray.t_max) continue;
      return t;
    }
    return {};
  }
};

/// RenderKit/ospray#482: the two ends are looked for along the ray, and not the hits along the
/// axis.
struct EndsAlongTheRay {
  static constexpr std::string_view name = "ends_along_the_ray";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const Sides<N> side = sides(ray, cylinder);
    const std::optional<Roots<N>> roots = quadratic_formula(side.a, side.b, side.c);
    if (!roots) return {};
    const N base = -side.from / side.slope;
    const N top = base + side.full / side.slope;
    return first_root(ray, *roots, [&](const N& t) {
      return base < top ? base <= t && t <= top : top <= t && t <= base;
    });
  }
};

/// RenderKit/ospray#600: |v|^2 |w|^2 - (v.w)^2, whose terms are huge where the cylinder is long.
struct LongTermsCancel {
  static constexpr std::string_view name = "long_terms_cancel";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    Nearby<N> line(ray, cylinder.base, cylinder.radius);
    const Axis<N> axis(cylinder.base, cylinder.top, line.length);
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const N ww = dot(w, w), full = ww * axis.length, rr = line.radius * line.radius;
    line.come_within(N(4) * (rr + full * axis.length));
    const N fw = dot(f, w), dw = dot(d, w);
    const N a = dot(d, d) * ww - dw * dw;
    const N b = N(2) * (dot(f, d) * ww - fw * dw);
    const N c = dot(f, f) * ww - fw * fw - rr * ww;
    const std::optional<Roots<N>> roots = stable_roots<N>(a, b, c, b * b - N(4) * a * c);
    if (!roots) return {};
    const std::optional<N> t = first_root(*roots, [&](const N& root) {
      const N height = fw + root * dw;
      return N(0) <= height && height <= full && in_range(ray, line.home(root));
    });
    if (!t) return {};
    return line.home(*t);
  }
};

/// aardvark-platform/aardvark.base#123: a ray along the axis divides 0 by 0, and what refuses roots
/// does not refuse NaN.
struct NothingRefusesNan {
  static constexpr std::string_view name = "nothing_refuses_nan";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    using std::sqrt;
    const Vec3<N> v = ray.origin - cylinder.base, w = cylinder.top - cylinder.base;
    const Vec3<N> beside = cross(ray.direction, w);
    const N ww = dot(w, w), a = dot(beside, beside), off = dot(v, beside);
    const N gap = cylinder.radius * cylinder.radius - off * off / a;
    if (gap < N(0)) return {};
    const N nearest = -dot(cross(v, w), beside) / a;
    const N half_chord = sqrt(gap * ww / a);
    const Roots<N> roots = {nearest - half_chord, nearest + half_chord};
    for (const N& t : {roots.one, roots.other}) {
      const N height = dot(v, w) + t * dot(ray.direction, w);
      if (t <= ray.t_min || t >= ray.t_max || height < N(0) || height > ww) continue;
      return t;
    }
    return {};
  }
};

/// The same thread: where the line comes in is told, be it behind the ray.
struct HitsBehind {
  static constexpr std::string_view name = "hits_behind";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    const auto [a, b, c, from, slope, full] = sides(ray, cylinder);
    const std::optional<Roots<N>> roots = quadratic_formula(a, b, c);
    if (!roots) return {};
    for (const N& t : {roots->one, roots->other}) {
      const N height = from + t * slope;
      if (t < ray.t_max && N(0) <= height && height <= full) return t;
    }
    return {};
  }
};

/// RayTracing/raytracing.github.io#1297: no hit counts before t = 0.001.
struct NothingNear {
  static constexpr std::string_view name = "nothing_near";

  template <class N, template <class> class S>
  std::optional<N> operator()(const Ray<N>& ray, const S<N>& shape) const {
    Ray<N> later = ray;
    if (later.t_min < N(0.001)) later.t_min = N(0.001);
    return Textbook()(later, shape);
  }
};

/// mmp/pbrt-v3#44: nothing but t > 0 keeps a ray from the surface that it starts on.
struct MeetsItAgain {
  static constexpr std::string_view name = "meets_it_again";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const Nearby<N> line(ray, cone.apex, cone.radius);
    const Axis<N> axis(cone.apex, cone.base, line.length);
    const Vec3<N>&f = line.from, &d = line.direction, &w = axis.along;
    const N ww = dot(w, w), fw = dot(f, w), dw = dot(d, w);
    const N rr = line.radius * line.radius / (axis.length * axis.length);
    const N a = ww * (dot(d, d) * ww - dw * dw) - rr * dw * dw;
    const N b = N(2) * (ww * (dot(f, d) * ww - fw * dw) - rr * fw * dw);
    const N c = ww * (dot(f, f) * ww - fw * fw) - rr * fw * fw;
    const std::optional<Roots<N>> roots = stable_roots<N>(a, b, c, b * b - N(4) * a * c);
    if (!roots) return {};
    const Depth<N> depth = {fw, dw, ww * axis.length};
    const std::optional<N> here = first_on_nappe(
        a, *roots, depth, [&](const N& root) { return in_range(ray, line.home(root)); });
    if (!here) return {};
    return line.home(*here);
  }
};

/// Embree's cone-linear curve, as 3.13.5 answers: the leading coefficient takes d.d for 1.
struct OneCoefficientWithoutLength {
  static constexpr std::string_view name = "one_coefficient_without_length";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cylinder<N>& cylinder) const {
    Sides<N> side = sides(ray, cylinder);
    side.a = side.full - side.slope * side.slope;
    return first_hit(ray, side);
  }

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Cone<N>& cone) const {
    const Vec3<N> v = ray.origin - cone.apex, w = cone.base - cone.apex;
    const N ww = dot(w, w), vw = dot(v, w), dw = dot(ray.direction, w);
    const N rr = cone.radius * cone.radius;
    const N a = ww * (ww - dw * dw) - rr * dw * dw;
    const N b = N(2) * (ww * (dot(v, ray.direction) * ww - vw * dw) - rr * vw * dw);
    const N c = ww * (dot(v, v) * ww - vw * vw) - rr * vw * vw;
    return first_hit(ray, {a, b, c, vw, dw, ww});
  }

 private:
  template <class N>
  static std::optional<N> first_hit(const Ray<N>& ray, const Sides<N>& side) {
    const std::optional<Roots<N>> roots = quadratic_formula(side.a, side.b, side.c);
    if (!roots) return {};
    return first_root(ray, *roots, [&](const N& t) {
      const N height = side.from + t * side.slope;
      return N(0) <= height && height <= side.full;
    });
  }
};

/// mitsuba-renderer/mitsuba2#171: a t whose point lies behind the surface, further the further away
/// the ray begins.
struct PointBehindTheSurface {
  static constexpr std::string_view name = "point_behind_the_surface";

  template <class N>
  std::optional<N> operator()(const Ray<N>& ray, const Sphere<N>& sphere) const {
    return Textbook()(ray, sphere);
  }
};

}  // namespace rayaudit::flaws
