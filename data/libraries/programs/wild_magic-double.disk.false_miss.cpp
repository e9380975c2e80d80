// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: disk 0x0p+0 0x1p+0 0x0p+0 0x1.3af3eb0e99c8p-1 -0x1.7ff9bb22f463p-1 0x1.f22e685ff0fcp-3 0x1p+0 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x1.875df7edd8a78p-1 0x1.f782f721cd61p-2 -0x1.ab0f190fd511p-2
// exact: hit 237669330035981436167642939392 / 3038419744253070059389 = 78221361.773834613253...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Plane3.h>
#include <cmath>
#include <cstdio>
#include <limits>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0, 0.0, 0.0), direction(0.7643887975539903, 0.4917105306988967, -0.4170497814095748);
  const Wm5::Ray3<Real> ray(origin, direction);
  // "The user must ensure that the normal vector is unit length." (Wm5Plane3.h)
  Vector normal(0.615142198116601, -0.7499521713418229, 0.2432525781897521);
  const Real off = normal.SquaredLength() - 1;
  if (!(std::fabs(off) <= 4 * std::numeric_limits<Real>::epsilon())) normal.Normalize();
  const Wm5::Plane3<Real> plane(normal, Vector(0.0, 1.0, 0.0));
  Wm5::IntrRay3Plane3<Real> met(ray, plane);
  // Whoever asks compares the parameter with their range.
  const bool found = met.Find();
  const Real t = found ? met.GetRayParameter() : 0;
  if (!found) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", t);
}
