// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: disk 0x0p+0 0x1p-16 0x0p+0 0x0p+0 0x1p-12 0x0p+0 0x1p-4 unbounded ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p-18 0x0p+0 range 0x1p+0 0x1p+3
// exact: hit 4
// observed: miss
// wrong by: rayaudit judge --format float --convention extent=unbounded,t_min=9.999999747378752e-06,t_max=3.4028234663852886e+38
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.0f, 0.0f, 0.0f), Vector(0.0f, 3.8146973e-06f, 0.0f), 1.0f,
                               8.0f);
  Real t;
  if (!ray.intersects(Vector(0.0f, 0.00024414062f, 0.0f), Vector(0.0f, 1.5258789e-05f, 0.0f), t))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(t));
}
