// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1p-13 0x0p+0 0x0p+0 0x1p-13 0x1.9p-12 ray -0x1.cp-12 -0x1p-13 0x0p+0 0x1.227b1912c46dp-2 0x1.eaf7b6efb156p-1 0x0p+0
// exact: hit 0.00016865738860789301785..., at -0.000379402596 3.96588266e-05 0
// observed: at -0.00035965997600603534 0.00010639635746410736 0
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Cylinder3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(-0.00042724609375, -0.0001220703125, 0.0), direction(0.28367270638510167, 0.9589211623757983, 0.0);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Line3<Real> axis(Vector(0, 0, 0), Vector(0, 0, 1));
  const Wm5::Cylinder3<Real> cylinder(axis, 0.0003814697265625, 2 * 0.0001220703125);
  Wm5::IntrRay3Cylinder3<Real> met(ray, cylinder);
  bool any = false;
  double first = INFINITY;
  Vector at;
  const bool found = met.Find();
  // Whoever asks takes the first point in their range.
  for (int i = 0; found && i < met.GetQuantity(); ++i) {
    const Vector p = met.GetPoint(i);
    const double x = p.X(), y = p.Y(), z = p.Z();
    const double t = (x - -0.00042724609375) * 0.28367270638510167 + (y - -0.0001220703125) * 0.9589211623757983 + (z - 0.0) * 0.0;
    if (t > first) continue;
    any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
