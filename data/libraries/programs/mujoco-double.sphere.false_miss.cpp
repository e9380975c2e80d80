// MuJoCo 2.2.2, mju_rayGeom
// build: c++ -O2 -std=c++17 FILE -lmujoco -o PROGRAM
// case: sphere 0x0p+0 0x1.da2cp-6 0x0p+0 0x1.bp-18 ray 0x1.b980ep-5 0x0p+0 0x1.df01ap-5 -0x1.e2c4e8p-3 0x1.0348p-3 -0x1.05ee2p-2
// exact: hit (8817242521139 - sqrt(51913941713551)) / 38568974174345 = 0.22860953667445389702...
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <mujoco/mujoco.h>
#include <cstdio>
int main() {
  const mjtNum at[] = {0.0, 0.02894115447998047, 0.0}, upright[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, size[] = {6.4373016357421875e-06, 0, 0};
  const mjtNum from[] = {0.05389446020126343, 0.0, 0.05847245454788208}, along[] = {-0.23572713136672974, 0.1266021728515625, -0.25579118728637695};
  const mjtNum x = mju_rayGeom(at, upright, size, from, along, mjGEOM_SPHERE);
  if (x == -1) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", x);
}
