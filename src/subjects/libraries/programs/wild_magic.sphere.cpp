// build: c++ -O2 -std=c++17 FILE -I/usr/include/libwildmagic -lWm5Mathematics -lWm5Core -o PROGRAM
// says false_miss: "The sphere is represented as |X-C| = R where C is the center and R is the radius." (Wm5Sphere3.h)
// says false_hit: "The sphere is represented as |X-C| = R where C is the center and R is the radius." (Wm5Sphere3.h)
// says wrong_root: "The sphere is represented as |X-C| = R where C is the center and R is the radius." (Wm5Sphere3.h)
// says wrong_t: "The sphere is represented as |X-C| = R where C is the center and R is the radius." (Wm5Sphere3.h)
// says any: "The ray is represented as P+t*D, where P is the ray origin, D is a unit-length direction vector, and t >= 0." (Wm5Ray3.h)
#include <Wm5IntrRay3Sphere3.h>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = Wm5::Vector3<Real>;
int main() {
  const Vector origin(@ox@, @oy@, @oz@), direction(@dx@, @dy@, @dz@);
  const Wm5::Ray3<Real> ray(origin, direction);
  const Wm5::Sphere3<Real> sphere(Vector(@cx@, @cy@, @cz@), @r@);
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
