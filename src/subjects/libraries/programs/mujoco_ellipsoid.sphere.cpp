// build: c++ -O2 -std=c++17 FILE -lmujoco -o PROGRAM
// says false_hit: "Interect [sic] ray with pure geom, return nearest distance or -1 if no intersection." (mju_rayGeom, mujoco/mujoco.h)
// says false_miss: "Interect [sic] ray with pure geom, return nearest distance or -1 if no intersection." (mju_rayGeom, mujoco/mujoco.h)
// says wrong_root: "Interect [sic] ray with pure geom, return nearest distance or -1 if no intersection." (mju_rayGeom, mujoco/mujoco.h)
// says wrong_t: "Interect [sic] ray with pure geom, return nearest distance or -1 if no intersection." (mju_rayGeom, mujoco/mujoco.h)
// says not_finite: "Interect [sic] ray with pure geom, return nearest distance or -1 if no intersection." (mju_rayGeom, mujoco/mujoco.h)
// says wrong_t: "Intersect ray (pnt+x*vec, x>=0) [...] Return distance (x) to nearest surface, or -1 if no intersection" (mj_ray, mujoco/mujoco.h)
// says behind: "Intersect ray (pnt+x*vec, x>=0) [...] Return distance (x) to nearest surface, or -1 if no intersection" (mj_ray, mujoco/mujoco.h)
#include <mujoco/mujoco.h>
#include <cstdio>
int main() {
  const mjtNum at[] = {@cx@, @cy@, @cz@}, upright[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, size[] = {@r@, @r@, @r@};
  const mjtNum from[] = {@ox@, @oy@, @oz@}, along[] = {@dx@, @dy@, @dz@};
  const mjtNum x = mju_rayGeom(at, upright, size, from, along, mjGEOM_ELLIPSOID);
  if (x == -1) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", x);
}
