// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x0p+0 0x1p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 range 0x1p+0 0x1p+2
// exact: hit 2
// observed: miss
// wrong by: rayaudit judge --format float --convention extent=unbounded,t_min=9.999999747378752e-06,t_max=3.4028234663852886e+38
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.0f, 0.0f, 0.0f), Vector(0.0f, 1.0f, 0.0f), 1.0f,
                               4.0f);
  Real t0, t1;
  if (!ray.intersects(Vector(0.0f, 1.0f, 0.0f), 1.0f, t0, t1)) return std::puts("miss"), 0;
  if (t0 == ray.t0() && t1 == ray.t1()) return std::puts("miss"), 0;  // both are ends of the ray
  std::printf("hit %.17g\n", double(t0 != ray.t0() ? t0 : t1));
}
