// Wild Magic 5.17, IntrLine3Cone3
// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// case: cone 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0 0x1p-1 0x1.fffffffff6p-10 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x1.9bc58bafep-9 0x1.32b2b294fp-7 0x1.fff99ca213e08p-1 range -inf inf
// exact: hit -0.12330620869856859628..., at -0.000387374898 -0.00115410682 -0.123300199
// observed: at -6.397451983409505e-05 -0.0001905994166817961 -0.020362886386280723
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,stand=upright_z,opening=cosine
#include <Wm5IntrLine3Cone3.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(0.0, 0.0, 0.0), direction(0.0031415684715625503, 0.009359681318414914, 0.9999512622688949);
  const Wm5::Line3<Real> line(origin, direction);
  const long double tangent = 0.0019531249999911182 / (2 * (long double)0.5);
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
    const double t = (x - 0.0) * 0.0031415684715625503 + (y - 0.0) * 0.009359681318414914 + (z - 0.0) * 0.9999512622688949;
    if (!(t > first)) any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
