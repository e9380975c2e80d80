/// The law: each shape as a scalar field F and side conditions G >= 0, written once, without
/// division or root. Called with polynomials in t it yields the restriction to a ray; called with
/// numbers it yields values at a point; with numbers that carry derivatives, derivatives.
///
/// Included once for each set of instructions that it is compiled for, each time into a namespace
/// of its own, RAYAUDIT_LAW_NAMESPACE; so it has no guard, and fields.hpp has what it is about.
namespace RAYAUDIT_LAW_NAMESPACE {  // NOLINT(modernize-concat-nested-namespaces): one name

template <class A, class B>
[[gnu::always_inline]] inline auto from(const Vec3<A>& a, const Vec3<B>& b) {
  return Vec3<decltype(b.x - a.x)>{b.x - a.x, b.y - a.y, b.z - a.z};
}

template <class A, class B>
[[gnu::always_inline]] inline auto inner(const Vec3<A>& a, const Vec3<B>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class A, class B>
[[gnu::always_inline]] inline auto outer(const Vec3<A>& a, const Vec3<B>& b) {
  using C = decltype(a.y * b.z - a.z * b.y);
  return Vec3<C>{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class A>
[[gnu::always_inline]] inline auto norm2(const Vec3<A>& a) {
  return squared(a.x) + squared(a.y) + squared(a.z);
}

/// F = (p - c).n, G = r^2 - |p - c|^2.
template <class N, class P>
[[gnu::always_inline]] inline auto patch(const Disk<N>& disk, const Vec3<P>& p) {
  const auto v = from(disk.centre, p);
  const auto inside = squared(disk.radius) - norm2(v);
  return Patch<decltype(inner(v, disk.normal)), std::remove_const_t<decltype(inside)>, 1>{
      inner(v, disk.normal), {inside}};
}

/// F = |p - c|^2 - r^2.
template <class N, class P>
[[gnu::always_inline]] inline auto patch(const Sphere<N>& sphere, const Vec3<P>& p) {
  const auto field = norm2(from(sphere.centre, p)) - squared(sphere.radius);
  return Patch<std::remove_const_t<decltype(field)>, P, 0>{field, {}};
}

/// v = p - a, w = b - a: F = |v x w|^2 - r^2 |w|^2, G1 = v.w, G2 = |w|^2 - v.w.
/// |v x w|^2 is |v|^2 |w|^2 - (v.w)^2, in a form that intervals decide more often.
template <class N, class P>
[[gnu::always_inline]] inline auto patch(const Cylinder<N>& cylinder, const Vec3<P>& p) {
  const auto v = from(cylinder.base, p);
  const auto w = from(cylinder.base, cylinder.top);
  const auto ww = norm2(w);
  const auto height = inner(v, w);
  const auto field = norm2(outer(v, w)) - squared(cylinder.radius) * ww;
  const auto rest = ww - height;
  return Patch<std::remove_const_t<decltype(field)>, std::remove_const_t<decltype(rest)>, 2>{
      field, {height, rest}};
}

/// v = p - a, w = b - a, h = |w|^2 - v.w: F = |w|^2 |v x w|^2 - r^2 h^2, G1 = v.w, G2 = h.
template <class N, class P>
[[gnu::always_inline]] inline auto patch(const Cone<N>& cone, const Vec3<P>& p) {
  const auto v = from(cone.base, p);
  const auto w = from(cone.base, cone.apex);
  const auto ww = norm2(w);
  const auto height = inner(v, w);
  const auto h = ww - height;
  const auto field = ww * norm2(outer(v, w)) - squared(cone.radius) * squared(h);
  return Patch<std::remove_const_t<decltype(field)>, std::remove_const_t<decltype(h)>, 2>{
      field, {height, h}};
}

template <class N, class P>
[[gnu::always_inline]] inline auto patch(const CappedCylinder<N>& shape, const Vec3<P>& p) {
  return patch(Cylinder<N>{shape.base, shape.top, shape.radius}, p);
}
template <class N, class P>
[[gnu::always_inline]] inline auto patch(const CappedCone<N>& shape, const Vec3<P>& p) {
  return patch(Cone<N>{shape.base, shape.apex, shape.radius}, p);
}

}  // namespace RAYAUDIT_LAW_NAMESPACE
