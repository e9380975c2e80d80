#pragma once

#include "tests/oracle/closed.hpp"

namespace rayaudit {

/// C + B t + A t^2 = F(o + t d), its coefficients written out for each shape.
template <class Wide>
struct Restriction {
  Wide a, half_b, c;
};

template <class Wide>
Restriction<Wide> restriction(const Disk<Wide>& disk, const Vec3<Wide>& o, const Vec3<Wide>& d) {
  return {0, dot(d, disk.normal) / 2, dot(o - disk.centre, disk.normal)};
}

template <class Wide>
Restriction<Wide> restriction(const Sphere<Wide>& sphere, const Vec3<Wide>& o,
                              const Vec3<Wide>& d) {
  const Vec3<Wide> v = o - sphere.centre;
  return {dot(d, d), dot(v, d), dot(v, v) - sphere.radius * sphere.radius};
}

/// |v|^2 |w|^2 - (v.w)^2 along the ray.
template <class Wide>
Restriction<Wide> about_axis(const Vec3<Wide>& v, const Vec3<Wide>& w, const Vec3<Wide>& d) {
  const Wide ww = dot(w, w), vw = dot(v, w), dw = dot(d, w);
  return {dot(d, d) * ww - dw * dw, dot(v, d) * ww - vw * dw, dot(v, v) * ww - vw * vw};
}

template <class Wide>
Restriction<Wide> restriction(const Cylinder<Wide>& cylinder, const Vec3<Wide>& o,
                              const Vec3<Wide>& d) {
  const Vec3<Wide> w = cylinder.top - cylinder.base;
  Restriction<Wide> f = about_axis(o - cylinder.base, w, d);
  f.c -= cylinder.radius * cylinder.radius * dot(w, w);
  return f;
}

template <class Wide>
Restriction<Wide> restriction(const Cone<Wide>& cone, const Vec3<Wide>& o, const Vec3<Wide>& d) {
  const Vec3<Wide> v = o - cone.base, w = cone.apex - cone.base;
  const Wide ww = dot(w, w), h = ww - dot(v, w), dw = dot(d, w), rr = cone.radius * cone.radius;
  const auto [a, half_b, c] = about_axis(v, w, d);
  return {ww * a - rr * dw * dw, ww * half_b + rr * h * dw, ww * c - rr * h * h};
}

template <class Wide>
Restriction<Wide> restriction(const CappedCylinder<Wide>& shape, const Vec3<Wide>& o,
                              const Vec3<Wide>& d) {
  return restriction(opened(shape), o, d);
}
template <class Wide>
Restriction<Wide> restriction(const CappedCone<Wide>& shape, const Vec3<Wide>& o,
                              const Vec3<Wide>& d) {
  return restriction(opened(shape), o, d);
}

/// A cap's field, of degree 1: negative inside.
template <class Wide, class S>
Restriction<Wide> restriction_to_cap(const S& shape, int cap, const Vec3<Wide>& o,
                                     const Vec3<Wide>& d) {
  const auto& [base, end, radius] = shape;
  const Vec3<Wide> w = end - base;
  if (cap == 0) return {0, -dot(d, w) / 2, dot(base - o, w)};
  return {0, dot(d, w) / 2, dot(o - end, w)};
}

}  // namespace rayaudit
