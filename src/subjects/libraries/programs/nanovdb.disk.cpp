// build: c++ -O2 -std=c++17 FILE -o PROGRAM
// says false_hit: "Return true if the Ray intersects the plane specified by a normal and point." (nanovdb/util/Ray.h)
// says false_miss: "Return true if the Ray intersects the plane specified by a normal and point." (nanovdb/util/Ray.h)
// says behind: "Return true if the Ray intersects the plane specified by a normal and point." (nanovdb/util/Ray.h)
// says wrong_root: "Time of intersection, if one exists." (of t, nanovdb/util/Ray.h)
// says wrong_t: "Time of intersection, if one exists." (of t, nanovdb/util/Ray.h)
// says not_finite: "Time of intersection, if one exists." (of t, nanovdb/util/Ray.h)
#include <nanovdb/util/Ray.h>
#include <cmath>
#include <cstdio>
using Real = @real@;
using Vector = nanovdb::Vec3<Real>;
int main() {
  const nanovdb::Ray<Real> ray(Vector(@ox@, @oy@, @oz@), Vector(@dx@, @dy@, @dz@), @t_min@,
                               @t_max@);
  Real t;
  if (!ray.intersects(Vector(@nx@, @ny@, @nz@), Vector(@cx@, @cy@, @cz@), t))
    return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(t));
}
