// NanoVDB 32.4.2, Ray::intersects
// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x1.e0957ddb5772p+0 0x1.3eb3782c9e74p+1 ray 0x1.e664c402c148p-1 0x1.54d882b1d5fcp+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 range 0x1p+0 0x1p+2
// exact: hit 3.7545621224407043729...
// observed: miss
// wrong by: rayaudit judge --format double --convention extent=unbounded,t_min=1e-09,t_max=1.7976931348623157e+308
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = double;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(0.9499875310290378, 1.3314286884469624, 0.0), Vector(0.0, 0.0, 1.0), 1.0,
                               4.0);
  Real t0, t1;
  if (!ray.intersects(Vector(0.0, 0.0, 1.8772810612203514), 2.4898519723764423, t0, t1)) return std::puts("miss"), 0;
  if (t0 == ray.t0() && t1 == ray.t1()) return std::puts("miss"), 0;  // both are ends of the ray
  std::printf("hit %.17g\n", double(t0 != ray.t0() ? t0 : t1));
}
