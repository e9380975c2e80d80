// Wild Magic 5.17, IntrLine3Cone3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: cone 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0 0x1p-1 0x1.4000271c86ce4p-4 unbounded ray 0x1.4p-8 -0x1.8p-7 -0x1p+0 0x0p+0 0x0p+0 -0x1p+0 range -inf inf
// exact: hit -3764735687676331 / 2814755016554098 = -1.3375003030584260116..., at 0.0048828125 -0.01171875 0.337500303
// observed: at 0.0048828125 -0.01171875 0.4999951124191284
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,opening=cosine
#include <Wm5IntrLine3Cone3.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0048828125f, -0.01171875f, -1.0f), direction(0.0f, 0.0f, -1.0f);
  const Wm5::Line3<Real> line(origin, direction);
  const long double tangent = 0.07812514570143808 / (2 * (long double)0.5f);
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
    const double t = (x - 0.0048828125f) * 0.0f + (y - -0.01171875f) * 0.0f + (z - -1.0f) * -1.0f;
    if (!(t > first)) any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
