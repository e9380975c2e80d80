// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1p-15 0x0p+0 0x0p+0 0x1p-15 0x1p-14 ray -0x1p-15 0x0p+0 0x0p+0 0x1.b1df47cb2d418p-1 0x1.0fd7f3d32a74p-1 0x0p+0
// exact: hit 0.000084705921410006887688..., at 4.12627804e-05 4.49741398e-05 0
// observed: at -8.602966951326582e-06 1.3730647314612833e-05 0
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Cylinder3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(-3.0517578125e-05, 0.0, 0.0), direction(0.8474066195982486, 0.5309444613714973, 0.0);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Line3<Real> axis(Vector(0, 0, 0), Vector(0, 0, 1));
  const Wm5::Cylinder3<Real> cylinder(axis, 6.103515625e-05, 2 * 3.0517578125e-05);
  Wm5::IntrRay3Cylinder3<Real> met(ray, cylinder);
  bool any = false;
  double first = INFINITY;
  Vector at;
  const bool found = met.Find();
  // Whoever asks takes the first point in their range.
  for (int i = 0; found && i < met.GetQuantity(); ++i) {
    const Vector p = met.GetPoint(i);
    const double x = p.X(), y = p.Y(), z = p.Z();
    const double t = (x - -3.0517578125e-05) * 0.8474066195982486 + (y - 0.0) * 0.5309444613714973 + (z - 0.0) * 0.0;
    if (t > first) continue;
    any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
