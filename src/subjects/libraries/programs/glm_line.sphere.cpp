// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says any: "Compute the intersection of a line and a sphere." (glm/gtx/intersect.hpp)
#define GLM_ENABLE_EXPERIMENTAL
#include <cmath>
#include <cstdio>
#include <glm/glm.hpp>
#include <glm/gtx/intersect.hpp>
using Real = @real@;
using Vector = glm::vec<3, Real>;
int main() {
  const Vector from(@ox@, @oy@, @oz@), along(@dx@, @dy@, @dz@), centre(@cx@, @cy@, @cz@);
  Vector one, one_normal, other, other_normal;
  if (!glm::intersectLineSphere(from, from + along, centre, Real(@r@), one, one_normal, other,
                                other_normal))
    return std::puts("miss"), 0;
  if (glm::dot(other - one, along) < 0) one = other;  // of two points the first along the line
  std::printf("at %.17g %.17g %.17g\n", double(one.x), double(one.y), double(one.z));
}
