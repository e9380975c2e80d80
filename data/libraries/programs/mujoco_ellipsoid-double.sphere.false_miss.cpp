// MuJoCo 2.2.2, mju_rayGeom of an ellipsoid
// build: c++ -O2 -std=c++17 FILE -lmujoco -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1.3b216d8ap+2 ray 0x1.9c7c14p+1 0x1.4d6cda3cp+2 0x1.d539047p+0 -0x1.3b2f559p-8 -0x1.0c6239b8p-8 -0x1.c7f44dcp-7
// exact: hit 266.9472057085650724...
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <mujoco/mujoco.h>
#include <cstdio>
int main() {
  const mjtNum at[] = {0.0, 0.0, 0.0}, upright[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, size[] = {4.923915276303887, 4.923915276303887, 4.923915276303887};
  const mjtNum from[] = {3.222536563873291, 5.209768828004599, 1.8329012654721737}, along[] = {-0.004809339894563891, -0.004095210162631702, -0.013914621318690479};
  const mjtNum x = mju_rayGeom(at, upright, size, from, along, mjGEOM_ELLIPSOID);
  if (x == -1) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", x);
}
