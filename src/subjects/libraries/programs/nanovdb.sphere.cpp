// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says false_hit: "Return true if this ray intersects the specified sphere." (nanovdb/util/Ray.h)
// says false_miss: "Return true if this ray intersects the specified sphere." (nanovdb/util/Ray.h)
// says behind: "Return true if this ray intersects the specified sphere." (nanovdb/util/Ray.h)
// says wrong_t: "The first intersection point if an intersection exists." (of t0, nanovdb/util/Ray.h)
// says not_finite: "The first intersection point if an intersection exists." (of t0, nanovdb/util/Ray.h)
// says wrong_root: "If the return value is true, i.e. a hit, and t0 = this->t0() or t1 == this->t1() only one true intersection exist." (nanovdb/util/Ray.h)
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(@ox@, @oy@, @oz@), Vector(@dx@, @dy@, @dz@), @t_min@,
                               @t_max@);
  Real t0, t1;
  if (!ray.intersects(Vector(@cx@, @cy@, @cz@), @r@, t0, t1)) return std::puts("miss"), 0;
  if (t0 == ray.t0() && t1 == ray.t1()) return std::puts("miss"), 0;  // both are ends of the ray
  std::printf("hit %.17g\n", double(t0 != ray.t0() ? t0 : t1));
}
