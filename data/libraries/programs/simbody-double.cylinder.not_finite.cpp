// Simbody 3.7.0, ContactGeometry::intersectsRay
// build: c++ -O2 FILE $(pkg-config --cflags simbody) -lSimTKmath -lSimTKcommon -o PROGRAM
// case: cylinder 0x0p+0 0x0p+0 -0x1p-2 0x0p+0 0x0p+0 0x1p-2 0x1p+0 unbounded ray 0x1p+0 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0
// exact: the ray lies in the surface: any finite t there, or miss
// observed: hit nan
// wrong by: rayaudit judge --format double --convention ray=line,extent=unbounded,stand=upright_z,t_min=0
#include <SimTKmath.h>
#include <cstdio>
using namespace SimTK;
int main() {
  const Vec3 from = Vec3(1.0, 0.0, 0.0), along(0.0, 0.0, 1.0);
  const ContactGeometry::Cylinder shape(1.0);
  Real distance;
  UnitVec3 normal;
  if (!shape.intersectsRay(from, UnitVec3(along), distance, normal)) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", distance / along.norm());
}
