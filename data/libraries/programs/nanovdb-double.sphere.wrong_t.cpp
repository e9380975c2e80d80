// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x1.0ac1345c161cp+0 0x1.50962b6c1dd8p+0 ray 0x1.1e89f9137c6p-1 0x1.25fb569063ap-1 0x0p+0 0x0p+0 0x0p+0 0x1p+0 range 0x1p+0 0x1p+2
// exact: hit 2.0840211343422419753...
// observed: hit 2.0416666666666665
// wrong by: rayaudit judge --format double --convention extent=unbounded,t_min=1e-09,t_max=1.7976931348623157e+308
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.5596464000975061, 0.5741831828361796, 0.0), Vector(0.0, 0.0, 1.0), 1.0,
                               4.0);
  Real t0, t1;
  if (!ray.intersects(Vector(0.0, 0.0, 1.0420105671711184), 1.3147914065319526, t0, t1)) return std::puts("miss"), 0;
  if (t0 == ray.t0() && t1 == ray.t1()) return std::puts("miss"), 0;  // both are ends of the ray
  std::printf("hit %.17g\n", double(t0 != ray.t0() ? t0 : t1));
}
