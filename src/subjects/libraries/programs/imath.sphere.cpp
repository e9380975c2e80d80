// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs Imath) -o PROGRAM
// says false_hit: "True if the sphere and line intersect, false if they do not." (ImathSphere.h)
// says false_miss: "True if the sphere and line intersect, false if they do not." (ImathSphere.h)
// says behind: "If the sphere and line `l` intersect, then compute the smallest `t` with `t>=0` so that `l(t)` is a point on the sphere." (ImathSphere.h)
// says wrong_root: "If the sphere and line `l` intersect, then compute the smallest `t` with `t>=0` so that `l(t)` is a point on the sphere." (ImathSphere.h)
// says wrong_t: "If the sphere and line `l` intersect, then compute the smallest `t` with `t>=0` so that `l(t)` is a point on the sphere." (ImathSphere.h)
// says not_finite: "If the sphere and line `l` intersect, then compute the smallest `t` with `t>=0` so that `l(t)` is a point on the sphere." (ImathSphere.h)
#include <ImathLine.h>
#include <ImathPlane.h>
#include <ImathSphere.h>
#include <cstdio>
using Real = @real@;
using Vector = Imath::Vec3<Real>;
int main() {
  Imath::Line3<Real> line;
  line.pos = Vector(@ox@, @oy@, @oz@), line.dir = Vector(@dx@, @dy@, @dz@);
  const Imath::Sphere3<Real> sphere(Vector(@cx@, @cy@, @cz@), @r@);
  Real t;
  if (!sphere.intersectT(line, t)) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(t));
}
