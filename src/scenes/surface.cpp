#include "scenes/surface.hpp"

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

}  // namespace

template <class N>
Vec3<N> outward_normal(const Shape& shape, const Vec3<N>& point) {
  return std::visit([&](const auto& any) { return normal_of(in<N>(any), point); }, shape);
}
template Vec3<float> outward_normal(const Shape&, const Vec3<float>&);
template Vec3<double> outward_normal(const Shape&, const Vec3<double>&);

}  // namespace rayaudit
