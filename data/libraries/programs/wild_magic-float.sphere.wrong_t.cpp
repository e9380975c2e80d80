// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: sphere 0x1.8p-10 0x1p-4 0x1.8p-10 0x1.2p-9 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0
// exact: hit 253 / 4096 = 0.061767578125
// observed: hit 0.0625
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Sphere3.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0f, 0.0f, 0.0f), direction(0.0f, 1.0f, 0.0f);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Sphere3<Real> sphere(Vector(0.0014648438f, 0.0625f, 0.0014648438f), 0.0021972656f);
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
