// GLM: version 0.9.9.8, intersectRaySphere and intersectRayPlane
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p-23 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0
// exact: hit 1 / 8388608 = 1.1920928955078125e-7
// observed: miss
// wrong by: rayaudit judge --format float --convention direction=unit,ray=line,extent=unbounded,t_min=0
#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using Real = float;
using Vector = glm::vec<3, Real>;
int main() {
  const Vector origin(0.0f, 0.0f, 0.0f), direction(0.0f, 0.0f, 1.0f), centre(0.0f, 0.0f, 0.0f);
  const Real radius = 1.1920929e-07f;
  Real distance;
  if (!glm::intersectRaySphere(origin, direction, centre, radius * radius, distance))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(distance));
}
