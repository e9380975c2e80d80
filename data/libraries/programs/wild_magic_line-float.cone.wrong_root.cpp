// Wild Magic 5.17, IntrLine3Cone3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: cone 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0 0x1p-1 0x1.007ffef24ca9p+0 unbounded ray -0x1.9b2bc8p-3 0x1.8c33b4p-4 0x1.1bf334p-2 -0x1.58b948p-1 0x1.c510c8p-3 -0x1.693874p-1 range -inf inf
// exact: hit -0.051911190389997628753..., at -0.165815888 0.0852450247 0.313918737
// observed: at -0.5053257942199707 0.19679829478263855 -0.04183843731880188
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,opening=cosine
#include <Wm5IntrLine3Cone3.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(-0.2007671f, 0.096728995f, 0.27729493f), direction(-0.6732886f, 0.22122341f, -0.7055088f);
  const Wm5::Line3<Real> line(origin, direction);
  const long double tangent = 1.0019530622054482 / (2 * (long double)0.5f);
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
    const double t = (x - -0.2007671f) * -0.6732886f + (y - 0.096728995f) * 0.22122341f + (z - 0.27729493f) * -0.7055088f;
    if (!(t > first)) any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
