// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x1.8108p-1 0x1.c9ep-2 0x1.deaffcp-1 0x1.47ccp+0 ray 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x1p+0 0x1p+1 range 0x1p-1 0x1p+1
// exact: hit (25744894 + sqrt(662799661185022)) / 50331648 = 1.0230102107488022271...
// observed: hit 0.5
// wrong by: rayaudit judge --format float --convention extent=unbounded,t_min=9.999999747378752e-06,t_max=3.4028234663852886e+38
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = float;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.0f, 0.0f, 0.0f), Vector(1.0f, 1.0f, 2.0f), 0.5f,
                               2.0f);
  Real t0, t1;
  if (!ray.intersects(Vector(0.75201416f, 0.44714355f, 0.9349364f), 1.2804565f, t0, t1)) return std::puts("miss"), 0;
  if (t0 == ray.t0() && t1 == ray.t1()) return std::puts("miss"), 0;  // both are ends of the ray
  std::printf("hit %.17g\n", double(t0 != ray.t0() ? t0 : t1));
}
