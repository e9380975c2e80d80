// MuJoCo 2.2.2, mju_rayGeom
// build: c++ -O2 -std=c++17 FILE -lmujoco -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1.8p-26 0x0p+0 0x0p+0 0x1.8p-26 0x1.8p-26 ray -0x1.4p-22 0x0p+0 0x1.8p-20 0x1.cp-2 0x0p+0 -0x1.2p+1
// exact: hit 37 / 58720256 = 6.3010624476841517857e-7...
// observed: hit 6.457169850667318e-07
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <mujoco/mujoco.h>
#include <cstdio>
int main() {
  const mjtNum at[] = {0, 0, 0}, upright[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, size[] = {2.2351741790771484e-08, 2.2351741790771484e-08, 0};
  const mjtNum from[] = {-2.980232238769531e-07, 0.0, 1.430511474609375e-06}, along[] = {0.4375, 0.0, -2.25};
  const mjtNum x = mju_rayGeom(at, upright, size, from, along, mjGEOM_CYLINDER);
  if (x == -1) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", x);
}
