// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says any: "Compute the intersection distance of a ray and a sphere." (glm/gtx/intersect.hpp)
#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using Real = @real@;
using Vector = glm::vec<3, Real>;
int main() {
  const Vector origin(@ox@, @oy@, @oz@), direction(@dx@, @dy@, @dz@), centre(@cx@, @cy@, @cz@);
  const Real radius = @r@;
  Real distance;
  if (!glm::intersectRaySphere(origin, direction, centre, radius * radius, distance))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(distance));
}
