// GLM: version 0.9.9.8, intersectRaySphere and intersectRayPlane
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p-52 ray 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0
// exact: hit 1 / 4503599627370496 = 2.2204460492503130808e-16...
// observed: miss
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,t_min=0
#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using Real = double;
using Vector = glm::vec<3, Real>;
int main() {
  const Vector origin(0.0, 0.0, 0.0), direction(1.0, 0.0, 0.0), centre(0.0, 0.0, 0.0);
  const Real radius = 2.220446049250313e-16;
  Real distance;
  if (!glm::intersectRaySphere(origin, direction, centre, radius * radius, distance))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(distance));
}
