// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags eigen3) -o PROGRAM
// says any: "the parameter value of the intersection between *this and the given hyperplane" (ParametrizedLine::intersectionParameter)
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = Eigen::Matrix<Real, 3, 1>;
int main() {
  const Eigen::ParametrizedLine<Real, 3> line(Vector(@ox@, @oy@, @oz@), Vector(@dx@, @dy@, @dz@));
  const double x = @nx@, y = @ny@, z = @nz@, length = std::hypot(x, y, z);
  const Vector normal(Real(x / length), Real(y / length), Real(z / length));
  const Eigen::Hyperplane<Real, 3> plane(normal, Vector(@cx@, @cy@, @cz@));
  const Real t = line.intersectionParameter(plane);
  if (!std::isfinite(t)) return std::puts("miss"), 0;  // the line runs along the plane
  std::printf("hit %.17g\n", double(t));
}
