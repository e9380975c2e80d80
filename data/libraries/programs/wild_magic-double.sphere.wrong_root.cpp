// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: sphere 0x1p-5 0x1p-13 0x1p-8 0x1.4p-13 ray 0x0p+0 0x0p+0 0x0p+0 0x1.fc1bb8ad2ce1cp-1 0x0p+0 0x1.f80fbfc4d314p-4
// exact: hit 0.031406989429149151038...
// observed: hit 0.031493179195424825
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Sphere3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0, 0.0, 0.0), direction(0.9923989974399237, 0.0, 0.12306189450936689);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Sphere3<Real> sphere(Vector(0.03125, 0.0001220703125, 0.00390625), 0.000152587890625);
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
