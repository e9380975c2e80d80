// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// says false_miss: "The segment for the finite cylinder has endpoints C-(H/2)*D and C+(H/2)*D where D is a unit-length direction of the line." (Wm5Cylinder3.h)
// says false_hit: "The segment for the finite cylinder has endpoints C-(H/2)*D and C+(H/2)*D where D is a unit-length direction of the line." (Wm5Cylinder3.h)
// says wrong_root: "The cylinder wall is at a distance R units from the axis." (Wm5Cylinder3.h)
// says wrong_t: "The cylinder wall is at a distance R units from the axis." (Wm5Cylinder3.h)
// says crashed: "Static intersection query." (Find, Wm5IntrRay3Cylinder3.h), of which nothing says that it may end the program
// says any: "The ray is represented as P+t*D, where P is the ray origin, D is a unit-length direction vector, and t >= 0." (Wm5Ray3.h)
#include <Wm5IntrRay3Cylinder3.h>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(@ox@, @oy@, @oz@), direction(@dx@, @dy@, @dz@);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Line3<Real> axis(Vector(0, 0, 0), Vector(0, 0, 1));
  const Wm5::Cylinder3<Real> cylinder(axis, @r@, 2 * @h@);
  Wm5::IntrRay3Cylinder3<Real> met(ray, cylinder);
  bool any = false;
  double first = INFINITY;
  Vector at;
  const bool found = met.Find();
  // Whoever asks takes the first point in their range.
  for (int i = 0; found && i < met.GetQuantity(); ++i) {
    const Vector p = met.GetPoint(i);
    const double x = p.X(), y = p.Y(), z = p.Z();
    const double t = (x - @ox@) * @dx@ + (y - @oy@) * @dy@ + (z - @oz@) * @dz@;
    if (t > first) continue;
    any = true, first = t, at = p;
  }
  if (!any) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", at.X(), at.Y(), at.Z());
}
