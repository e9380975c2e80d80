// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: sphere 0x1p-8 0x0p+0 0x0p+0 0x1p-9 ray 0x0p+0 0x0p+0 0x0p+0 0x1.c58ap-1 0x0p+0 0x1.db2b3p-2
// exact: hit (60872982528 - 8192 sqrt(2439991743621)) / 17592186370345 = 0.0027328434395109377327...
// observed: hit 0.003460228443145752
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Sphere3.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0f, 0.0f, 0.0f), direction(0.8858185f, 0.0f, 0.46403193f);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Sphere3<Real> sphere(Vector(0.00390625f, 0.0f, 0.0f), 0.001953125f);
  Wm5::IntrRay3Sphere3<Real> met(ray, sphere);
  bool any = false;
  double first = INFINITY;
  const bool found = met.Find();
  // Whoever asks takes the first parameter in their range.
  for (int i = 0; found && i < met.GetQuantity(); ++i) {
    const Real t = met.GetRayParameter(i);
    if (t > first) continue;
    any = true, first = t;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", first);
}
