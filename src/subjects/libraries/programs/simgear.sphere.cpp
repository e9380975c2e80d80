// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says any: "intersects(const SGRay<T>& ray, const SGSphere<T>& sphere)", of which nothing is said but its name (simgear/math/SGIntersect.hxx)
#include <simgear/compiler.h>
#include <cstdio>
#include <simgear/math/SGGeometry.hxx>
using Real = @real@;
using Vector = SGVec3<Real>;
int main() {
  const SGRay<Real> ray(Vector(@ox@, @oy@, @oz@), Vector(@dx@, @dy@, @dz@));
  const SGSphere<Real> sphere(Vector(@cx@, @cy@, @cz@), @r@);
  std::puts(intersects(ray, sphere) ? "yes" : "miss");
}
