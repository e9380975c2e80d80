// Wild Magic 5.17, IntrLine3Cone3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: cone 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0 0x1p-1 0x1.707c1ep+1 unbounded ray 0x1.5951p+0 0x1.254p-2 0x1.58p-6 0x1.d9213ea5735cp-1 0x1.9153888c5764p-3 -0x1.50029a75802ep-2 range -inf inf
// exact: miss
// observed: at 0.004630596054974845 0.0013138093765789893 0.49833393409077015
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,opening=cosine
#include <Wm5IntrLine3Cone3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(1.3488922119140625, 0.286376953125, 0.02099609375), direction(0.9240817620245068, 0.19596010854995605, -0.3281349310127961);
  const Wm5::Line3<Real> line(origin, direction);
  const long double tangent = 2.8787877559661865 / (2 * (long double)0.5);
  const long double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
  const Wm5::Cone3<Real> cone(Vector(0, 0, 0.5), Vector(0, 0, -1), Real(cosine), Real(sine),
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
    const double t = (x - 1.3488922119140625) * 0.9240817620245068 + (y - 0.286376953125) * 0.19596010854995605 + (z - 0.02099609375) * -0.3281349310127961;
    if (!(t > first)) any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
