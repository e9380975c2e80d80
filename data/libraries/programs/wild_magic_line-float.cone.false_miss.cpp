// Wild Magic 5.17, IntrLine3Cone3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: cone 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0 0x1p-1 0x1.7001fec557f94p-1 unbounded ray -0x1.2p-1 0x1.28p-3 -0x1.4p-2 0x1.1e308p-1 -0x1.4b0934p-3 0x1.a066e4p-1 range -inf inf
// exact: hit 0.80203696943068604573...
// observed: miss
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,opening=cosine
#include <Wm5IntrLine3Cone3.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(-0.5625f, 0.14453125f, -0.3125f), direction(0.5589638f, -0.16163865f, 0.813285f);
  const Wm5::Line3<Real> line(origin, direction);
  const long double tangent = 0.7187652221582419 / (2 * (long double)0.5f);
  const long double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
  const Wm5::Cone3<Real> cone(Vector(0, 0, 0.5f), Vector(0, 0, -1), Real(cosine), Real(sine),
                              Wm5::Math<Real>::MAX_REAL);
  Wm5::IntrLine3Cone3<Real> met(line, cone);
  bool any = false;
  double first = INFINITY;
  Vector at;
  const bool found = met.Find();
  // Of an IT_RAY the second point is a direction.
  using Kind = Wm5::Intersector<Real, Vector>;
  const int points = met.GetIntersectionType() == Kind::IT_SEGMENT ? 2 : 1;
  for (int i = 0; found && i < points; ++i) {
    const Vector p = met.GetPoint(i);
    const double x = p.X(), y = p.Y(), z = p.Z();
    const double t = (x - -0.5625f) * 0.5589638f + (y - 0.14453125f) * -0.16163865f + (z - -0.3125f) * 0.813285f;
    if (!(t > first)) any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
