// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x1.5234p+0 0x1.a04p-2 0x1.a04p+0 0x1.112ap+1 ray 0x0p+0 0x0p+0 0x0p+0 0x1p+1 0x0p+0 0x0p+0 range 0x1p+0 0x1p+1
// exact: hit 21645 / 16384 = 1.32110595703125
// observed: hit 1
// wrong by: rayaudit judge --format float --convention extent=unbounded,t_min=9.999999747378752e-06,t_max=3.4028234663852886e+38
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.0f, 0.0f, 0.0f), Vector(2.0f, 0.0f, 0.0f), 1.0f,
                               2.0f);
  Real t0, t1;
  if (!ray.intersects(Vector(1.321106f, 0.40649414f, 1.6259766f), 2.1340942f, t0, t1)) return std::puts("miss"), 0;
  if (t0 == ray.t0() && t1 == ray.t1()) return std::puts("miss"), 0;  // both are ends of the ray
  std::printf("hit %.17g\n", double(t0 != ray.t0() ? t0 : t1));
}
