// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// says false_miss: "This is an infinite, single-sided cone." (Wm5Cone3.h)
// says false_hit: "This is an infinite, single-sided cone." (Wm5Cone3.h)
// says wrong_root: "IT_SEGMENT: <point[0],point[1]> is the intersection segment" (Wm5IntrLine3Cone3.h)
// says wrong_t: "IT_POINT: point[0] is the intersection point" (Wm5IntrLine3Cone3.h)
// says any: "The line is represented as P+t*D where P is the line origin, D is a unit-length direction vector, and t is any real number." (Wm5Line3.h)
#include <Wm5IntrLine3Cone3.h>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(@ox@, @oy@, @oz@), direction(@dx@, @dy@, @dz@);
  const Wm5::Line3<Real> line(origin, direction);
  const long double tangent = @r@ / (2 * (long double)@h@);
  const long double cosine = 1 / std::sqrt(1 + tangent * tangent), sine = tangent * cosine;
  const Wm5::Cone3<Real> cone(Vector(0, 0, @h@), Vector(0, 0, -1), Real(cosine), Real(sine),
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
    const double t = (x - @ox@) * @dx@ + (y - @oy@) * @dy@ + (z - @oz@) * @dz@;
    if (!(t > first)) any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
