// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: disk 0x0p+0 0x0p+0 0x0p+0 0x1.ffe464a485a54p-1 -0x1.43143467d6p-6 0x1.74ca7a77dp-8 0x1p+0 unbounded ray 0x1.75p-16 0x1.898p-10 0x1.54p-10 0x1.c176ee1e9p-7 0x1.b246901d89848p-1 0x1.0f1b8e12700d8p-1
// exact: miss
// observed: hit 0
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Plane3.h>
#include <cmath>
#include <cstdio>
#include <limits>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(2.2232532501220703e-05, 0.0015010833740234375, 0.0012969970703125), direction(0.013716570157271235, 0.8481946025901914, 0.5295071027285543);
  const Wm5::Ray3<Real> ray(origin, direction);
  // "The user must ensure that the normal vector is unit length." (Wm5Plane3.h)
  Vector normal(0.9997893763382515, -0.01971917264685885, 0.005688338183801989);
  const Real off = normal.SquaredLength() - 1;
  if (!(std::fabs(off) <= 4 * std::numeric_limits<Real>::epsilon())) normal.Normalize();
  const Wm5::Plane3<Real> plane(normal, Vector(0.0, 0.0, 0.0));
  Wm5::IntrRay3Plane3<Real> met(ray, plane);
  // Whoever asks compares the parameter with their range.
  const bool found = met.Find();
  const Real t = found ? met.GetRayParameter() : 0;
  if (!found) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", t);
}
