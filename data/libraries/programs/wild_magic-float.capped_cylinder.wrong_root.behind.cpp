// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1p-8 0x0p+0 0x0p+0 0x1p-8 0x1p-10 ray 0x0p+0 -0x1p-11 0x0p+0 0x1.0a3618p-1 0x1.b559cp-1 0x0p+0
// exact: hit (7337525248 + 2048 sqrt(65612840639131)) / 17592185590985 = 0.0013600745759112320145..., at 0.000707162551 0.000673494947 0
// observed: at 0.00021686343825422227 -0.00013200280955061316 0
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Cylinder3.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0f, -0.00048828125f, 0.0f), direction(0.51994395f, 0.85420036f, 0.0f);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Line3<Real> axis(Vector(0, 0, 0), Vector(0, 0, 1));
  const Wm5::Cylinder3<Real> cylinder(axis, 0.0009765625f, 2 * 0.00390625f);
  Wm5::IntrRay3Cylinder3<Real> met(ray, cylinder);
  bool any = false;
  double first = INFINITY;
  Vector at;
  const bool found = met.Find();
  // Whoever asks takes the first point in their range.
  for (int i = 0; found && i < met.GetQuantity(); ++i) {
    const Vector p = met.GetPoint(i);
    const double x = p.X(), y = p.Y(), z = p.Z();
    const double t = (x - 0.0f) * 0.51994395f + (y - -0.00048828125f) * 0.85420036f + (z - 0.0f) * 0.0f;
    if (t > first) continue;
    any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
