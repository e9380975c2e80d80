// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says any: "For 0 <= \alpha the ray intersects the infinite plane." (simgear/math/SGIntersect.hxx)
#include <simgear/compiler.h>
#include <cstdio>
#include <simgear/math/SGGeometry.hxx>
using Real = @real@;
using Vector = SGVec3<Real>;
int main() {
  const SGRay<Real> ray(Vector(@ox@, @oy@, @oz@), Vector(@dx@, @dy@, @dz@));
  const SGPlane<Real> plane(Vector(@nx@, @ny@, @nz@), Vector(@cx@, @cy@, @cz@));
  Vector at;
  if (!intersects(at, ray, plane)) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", double(at[0]), double(at[1]), double(at[2]));
}
