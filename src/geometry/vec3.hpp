#pragma once

namespace rayaudit {

/// Three components over any number N: a point or a vector, as its place says.
template <class N>
struct Vec3 {
  N x, y, z;

  friend bool operator==(const Vec3&, const Vec3&) = default;
};

template <class N>
Vec3<N> operator+(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class N>
Vec3<N> operator-(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class N>
Vec3<N> operator-(const Vec3<N>& a) {
  return {-a.x, -a.y, -a.z};
}

template <class N>
Vec3<N> operator*(const N& s, const Vec3<N>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

template <class N>
Vec3<N> operator/(const Vec3<N>& a, const N& s) {
  return {a.x / s, a.y / s, a.z / s};
}

template <class N>
N dot(const Vec3<N>& a, const Vec3<N>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class N>
Vec3<N> cross(const Vec3<N>& a, const Vec3<N>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// The same vector in another number; exact where every component is a number of M.
template <class M, class N>
Vec3<M> in(const Vec3<N>& a) {
  return {M(a.x), M(a.y), M(a.z)};
}

}  // namespace rayaudit
