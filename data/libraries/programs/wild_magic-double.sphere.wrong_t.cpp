// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p-13 ray 0x0p+0 0x1p-7 0x1.8p-14 0x0p+0 -0x1p+0 0x0p+0
// exact: hit (256 - sqrt(7)) / 32768 = 0.0077317580776652651797...
// observed: hit 0.0078125
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Sphere3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0, 0.0078125, 9.1552734375e-05), direction(0.0, -1.0, 0.0);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Sphere3<Real> sphere(Vector(0.0, 0.0, 0.0), 0.0001220703125);
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
