// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says any: "Compute the intersection of a ray and a plane." (glm/gtx/intersect.hpp)
#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using Real = @real@;
using Vector = glm::vec<3, Real>;
int main() {
  const Vector origin(@ox@, @oy@, @oz@), direction(@dx@, @dy@, @dz@), point(@cx@, @cy@, @cz@);
  const double x = @nx@, y = @ny@, z = @nz@, length = std::hypot(x, y, z);
  Real distance;
  if (!glm::intersectRayPlane(origin, direction, point, Vector(x / length, y / length, z / length),
                              distance))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(distance));
}
