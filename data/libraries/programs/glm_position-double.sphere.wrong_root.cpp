// GLM: version 0.9.9.8, intersectRaySphere for a position
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x1.0a803f7p-21 0x1.039c07ccp-19 0x1.945ba7aa8p-18 0x1.a9fc8508p-18 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0
// exact: hit (13568003925 - 4 sqrt(11505670656350670614)) / 2251799813685248 = 1.1790676069262935077e-16..., at 0 0 1.17906761e-16
// observed: at 0 0 1.205080828447369e-05
// wrong by: rayaudit judge --format double --convention direction=unit,ray=line,extent=unbounded,t_min=0
#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using Real = double;
using Vector = glm::vec<3, Real>;
int main() {
  const Vector origin(0.0, 0.0, 0.0), direction(0.0, 0.0, 1.0), centre(4.96396735272242e-07, 1.934241458556585e-06, 6.025404142295798e-06);
  Vector at, normal;
  if (!glm::intersectRaySphere(origin, direction, centre, Real(6.347692085739709e-06), at, normal))
    return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", double(at.x), double(at.y), double(at.z));
}
