// Open CASCADE 7.6.3, IntAna_IntConicQuad
// build: c++ -O2 -std=c++17 FILE -isystem /usr/include/opencascade -lTKGeomBase -lTKMath -lTKernel -o PROGRAM
// case: sphere 0x1.b3c6381dd8bccp+25 0x0p+0 0x1.4p+26 0x1p+0 ray 0x1.b3c637b4p+25 0x0p+0 0x1.4p+26 0x0p+0 0x1p+0 0x0p+0 range -inf inf
// exact: hit -sqrt(356000623693143) / 33554432 = -0.56230958676162965651...
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,extent=both_nappes,stand=upright_z,opening=angle
#include <gp_Cone.hxx>
#include <gp_Cylinder.hxx>
#include <gp_Pln.hxx>
#include <gp_Sphere.hxx>  // IntAna_Quadric.hxx needs the four
#include <gp_Lin.hxx>
#include <IntAna_IntConicQuad.hxx>
#include <IntAna_Quadric.hxx>
#include <algorithm>
#include <cmath>
#include <cstdio>
int main() try {
  const gp_Lin line(gp_Pnt(57117807.40625, 0.0, 83886080.0), gp_Dir(0.0, 1.0, 0.0));
  const gp_Sphere sphere(gp_Ax3(gp_Pnt(57117808.2331768, 0.0, 83886080.0), gp::DZ()), 1.0);
  const IntAna_IntConicQuad met(line, IntAna_Quadric(sphere));
  if (met.IsDone() && met.IsInQuadric()) return std::puts("yes"), 0;
  if (!met.IsDone() || met.IsParallel() || met.NbPoints() == 0) return std::puts("miss"), 0;
  double first = met.ParamOnConic(1);
  for (int i = 2; i <= met.NbPoints(); ++i) first = std::min(first, met.ParamOnConic(i));
  // A parameter is a length along the line; it is told in units of the direction as given.
  const long double dx = 0.0, dy = 1.0, dz = 0.0;
  std::printf("hit %.17g\n", double(first / std::sqrt(dx * dx + dy * dy + dz * dz)));
} catch (const Standard_Failure& raised) {
  std::fprintf(stderr, "raised: %s\n", raised.GetMessageString());
  std::puts("miss");
}
