// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: disk 0x1p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 0x1p+0 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x1p-50 0x0p+0 0x0p+0 range 0x1p+0 0x1p+51
// exact: hit 1125899906842624
// observed: miss
// wrong by: rayaudit judge --format double --convention extent=unbounded,t_min=1e-09,t_max=1.7976931348623157e+308
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.0, 0.0, 0.0), Vector(8.881784197001252e-16, 0.0, 0.0), 1.0,
                               2251799813685248.0);
  Real t;
  if (!ray.intersects(Vector(1.0, 0.0, 0.0), Vector(1.0, 0.0, 0.0), t))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(t));
}
