// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says false_hit: "True if there is an intersection." (irrlicht/line3d.h)
// says false_miss: "True if there is an intersection." (irrlicht/line3d.h)
// says wrong_root: "the distance to the first intersection point is stored in outdistance" (irrlicht/line3d.h)
// says wrong_t: "the distance to the first intersection point is stored in outdistance" (irrlicht/line3d.h)
// says not_finite: "the distance to the first intersection point is stored in outdistance" (irrlicht/line3d.h)
#include <irrlicht/line3d.h>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = irr::core::vector3d<Real>;
int main() {
  const Vector from(@ox@, @oy@, @oz@), along(@dx@, @dy@, @dz@);
  const irr::core::line3d<Real> line(from, from + along);
  double distance;
  if (!line.getIntersectionWithSphere(Vector(@cx@, @cy@, @cz@), @r@, distance))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", distance / std::hypot(along.X, along.Y, along.Z));
}
