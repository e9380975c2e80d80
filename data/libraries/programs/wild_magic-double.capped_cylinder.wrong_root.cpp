// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1p-13 0x0p+0 0x0p+0 0x1p-13 0x1p-13 ray -0x1p-12 0x0p+0 -0x1p-12 0x1.57599ae6a183p-1 0x0p+0 0x1.7bcf10e88c78p-1
// exact: hit 68719476736 / 377517339222403 = 0.00018202998802000981622..., at -0.000122070312 0 -0.000109108202
// observed: at 0 0 2.5924221618120696e-05
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Cylinder3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(-0.000244140625, 0.0, -0.000244140625), direction(0.6706055075199, 0.0, 0.7418141635773594);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Line3<Real> axis(Vector(0, 0, 0), Vector(0, 0, 1));
  const Wm5::Cylinder3<Real> cylinder(axis, 0.0001220703125, 2 * 0.0001220703125);
  Wm5::IntrRay3Cylinder3<Real> met(ray, cylinder);
  bool any = false;
  double first = INFINITY;
  Vector at;
  const bool found = met.Find();
  // Whoever asks takes the first point in their range.
  for (int i = 0; found && i < met.GetQuantity(); ++i) {
    const Vector p = met.GetPoint(i);
    const double x = p.X(), y = p.Y(), z = p.Z();
    const double t = (x - -0.000244140625) * 0.6706055075199 + (y - 0.0) * 0.0 + (z - -0.000244140625) * 0.7418141635773594;
    if (t > first) continue;
    any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
