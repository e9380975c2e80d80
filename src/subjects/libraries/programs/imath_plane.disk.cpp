// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs Imath) -o PROGRAM
// says false_hit: "True if the line intersects the plane." (ImathPlane.h)
// says false_miss: "True if the line intersects the plane." (ImathPlane.h)
// says wrong_root: "The parametric value of the point of intersection" (ImathPlane.h)
// says wrong_t: "The parametric value of the point of intersection" (ImathPlane.h)
// says not_finite: "The parametric value of the point of intersection" (ImathPlane.h)
#include <ImathLine.h>
#include <ImathPlane.h>
#include <ImathSphere.h>
#include <cstdio>
using Real = @real@;
using Vector = Imath::Vec3<Real>;
int main() {
  Imath::Line3<Real> line;
  line.pos = Vector(@ox@, @oy@, @oz@), line.dir = Vector(@dx@, @dy@, @dz@);
  const Imath::Plane3<Real> plane(Vector(@cx@, @cy@, @cz@), Vector(@nx@, @ny@, @nz@));
  Real t;
  if (!plane.intersectT(line, t)) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(t));
}
