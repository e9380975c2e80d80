// Wild Magic 5.17, IntrRay3Plane3, IntrRay3Sphere3 and IntrRay3Cylinder3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: disk 0x1.ba71dap-1 0x1.3ba477p+0 0x0p+0 -0x1.9808b5da8788p-2 0x1.405c49d64f9bp-2 0x1.b96eebd2c3bap-1 0x1p+0 unbounded ray 0x0p+0 0x0p+0 0x1.8960ap-5 0x1.40deb15d51928p-1 0x1.8ef75d187003p-1 0x1.c34d04c768p-8
// exact: hit 305747572975156068352 / 558671576555344482497 = 0.54727604876613471072...
// observed: hit 0
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <Wm5IntrRay3Plane3.h>
#include <cmath>
#include <cstdio>
#include <limits>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0, 0.0, 0.04801970720291138), direction(0.6266990114607198, 0.7792309849101056, 0.006886304537516708);
  const Wm5::Ray3<Real> ray(origin, direction);
  // "The user must ensure that the normal vector is unit length." (Wm5Plane3.h)
  Vector normal(-0.3984707274083874, 0.3128520524077443, 0.8621743864804223);
  const Real off = normal.SquaredLength() - 1;
  if (!(std::fabs(off) <= 4 * std::numeric_limits<Real>::epsilon())) normal.Normalize();
  const Wm5::Plane3<Real> plane(normal, Vector(0.8641498684883118, 1.2329782843589783, 0.0));
  Wm5::IntrRay3Plane3<Real> met(ray, plane);
  // Whoever asks compares the parameter with their range.
  const bool found = met.Find();
  const Real t = found ? met.GetRayParameter() : 0;
  if (!found) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", t);
}
