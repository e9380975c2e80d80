// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// says false_miss: "The point of intersection is P = origin + t*direction, with t >= 0." (Wm5IntrRay3Plane3.h)
// says false_hit: "The point of intersection is P = origin + t*direction, with t >= 0." (Wm5IntrRay3Plane3.h)
// says wrong_root: "The point of intersection is P = origin + t*direction, with t >= 0." (Wm5IntrRay3Plane3.h)
// says wrong_t: "The point of intersection is P = origin + t*direction, with t >= 0." (Wm5IntrRay3Plane3.h)
// says any: "The ray is represented as P+t*D, where P is the ray origin, D is a unit-length direction vector, and t >= 0." (Wm5Ray3.h)
#include <Wm5IntrRay3Plane3.h>
#include <cmath>
#include <cstdio>
#include <limits>
using Real = @real@;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(@ox@, @oy@, @oz@), direction(@dx@, @dy@, @dz@);
  const Wm5::Ray3<Real> ray(origin, direction);
  // "The user must ensure that the normal vector is unit length." (Wm5Plane3.h)
  Vector normal(@nx@, @ny@, @nz@);
  const Real off = normal.SquaredLength() - 1;
  if (!(std::fabs(off) <= 4 * std::numeric_limits<Real>::epsilon())) normal.Normalize();
  const Wm5::Plane3<Real> plane(normal, Vector(@cx@, @cy@, @cz@));
  Wm5::IntrRay3Plane3<Real> met(ray, plane);
  // Whoever asks compares the parameter with their range.
  const bool found = met.Find();
  const Real t = found ? met.GetRayParameter() : 0;
  if (!found) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", t);
}
