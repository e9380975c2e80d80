#include "scenes/surface.hpp"

#include <cmath>

namespace rayaudit {
namespace {

template <class N>
Vec3<N> normal_of(const Disk<N>& disk, const Vec3<N>&) {
  return unit(disk.normal);
}
template <class N>
Vec3<N> normal_of(const Sphere<N>& sphere, const Vec3<N>& point) {
  return unit(point - sphere.centre);
}
/// What of a point's place from `base` is square to the axis, of length 1.
template <class N>
Vec3<N> from_axis(const Vec3<N>& base, const Vec3<N>& axis, const Vec3<N>& point) {
  const Vec3<N> v = point - base;
  return unit(v - dot(v, axis) * axis);
}
template <class N>
Vec3<N> normal_of(const Cylinder<N>& cylinder, const Vec3<N>& point) {
  return from_axis(cylinder.base, unit(cylinder.top - cylinder.base), point);
}
/// Along the axis it rises by the radius where it goes out by the height.
template <class N>
Vec3<N> normal_of(const Cone<N>& cone, const Vec3<N>& point) {
  const Vec3<N> w = cone.apex - cone.base, axis = unit(w);
  const Vec3<N> out = from_axis(cone.base, axis, point);
  return is_finite(out) ? unit(out + cone.radius / length(w) * axis) : axis;
}

/// Is a point of a closed shape rather on the plane square to the axis at its end, than beside it?
template <class N>
bool is_on_cap(const Vec3<N>& end, const Vec3<N>& axis, const Vec3<N>& point, const N& beside) {
  using std::fabs;
  return fabs(dot(point - end, axis)) < fabs(beside);
}
template <class N>
Vec3<N> normal_of(const CappedCylinder<N>& cylinder, const Vec3<N>& point) {
  const Vec3<N> axis = unit(cylinder.top - cylinder.base);
  const N beside = length(cross(point - cylinder.base, axis)) - cylinder.radius;
  if (is_on_cap(cylinder.base, axis, point, beside)) return -axis;
  if (is_on_cap(cylinder.top, axis, point, beside)) return axis;
  return normal_of(Cylinder<N>{cylinder.base, cylinder.top, cylinder.radius}, point);
}
template <class N>
Vec3<N> normal_of(const CappedCone<N>& cone, const Vec3<N>& point) {
  const Vec3<N> w = cone.apex - cone.base, axis = unit(w);
  const N level = cone.radius * (N(1) - dot(point - cone.base, axis) / length(w));
  if (is_on_cap(cone.base, axis, point, length(cross(point - cone.base, axis)) - level))
    return -axis;
  return normal_of(Cone<N>{cone.base, cone.apex, cone.radius}, point);
}

}  // namespace

template <class N>
Vec3<N> outward_normal(const Shape& shape, const Vec3<N>& point) {
  return std::visit([&](const auto& any) { return normal_of(in<N>(any), point); }, shape);
}
template Vec3<float> outward_normal(const Shape&, const Vec3<float>&);
template Vec3<double> outward_normal(const Shape&, const Vec3<double>&);

}  // namespace rayaudit
