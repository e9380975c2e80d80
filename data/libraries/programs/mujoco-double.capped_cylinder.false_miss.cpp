// MuJoCo 2.2.2, mju_rayGeom
// build: c++ -O2 -std=c++17 FILE -lmujoco -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1p-14 0x0p+0 0x0p+0 0x1p-14 0x1p-13 ray 0x0p+0 0x0p+0 0x0p+0 0x1p-12 0x0p+0 0x0p+0
// exact: hit 1 / 2 = 0.5
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <mujoco/mujoco.h>
#include <cstdio>
int main() {
  const mjtNum at[] = {0, 0, 0}, upright[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, size[] = {0.0001220703125, 6.103515625e-05, 0};
  const mjtNum from[] = {0.0, 0.0, 0.0}, along[] = {0.000244140625, 0.0, 0.0};
  const mjtNum x = mju_rayGeom(at, upright, size, from, along, mjGEOM_CYLINDER);
  if (x == -1) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", x);
}
