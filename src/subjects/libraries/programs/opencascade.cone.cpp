// build: c++ -O2 -std=c++17 FILE -isystem /usr/include/opencascade -lTKGeomBase -lTKMath -lTKernel -o PROGRAM
// says false_miss: "Returns the number of intersection point." (NbPoints, IntAna_IntConicQuad.hxx)
// says false_hit: "Returns the number of intersection point." (NbPoints, IntAna_IntConicQuad.hxx)
// says wrong_root: "Returns the parameter on the line of the intersection point of range N." (ParamOnConic, IntAna_IntConicQuad.hxx)
// says wrong_t: "Returns the parameter on the line of the intersection point of range N." (ParamOnConic, IntAna_IntConicQuad.hxx)
// says not_finite: "This class provides the analytic intersection between a conic defined as an element of gp (Lin,Circ,Elips, Parab,Hypr) and a quadric" (IntAna_IntConicQuad.hxx)
// says any: "Defines an infinite conical surface. A cone is defined by its half-angle" (gp_Cone.hxx)
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
  const gp_Lin line(gp_Pnt(@ox@, @oy@, @oz@), gp_Dir(@dx@, @dy@, @dz@));
  const double angle = std::atan((long double)@r@ / (2 * @h@));
  const gp_Cone cone(gp_Ax3(gp_Pnt(0, 0, @h@), gp::DZ()), angle, 0);
  const IntAna_IntConicQuad met(line, IntAna_Quadric(cone));
  if (met.IsDone() && met.IsInQuadric()) return std::puts("yes"), 0;
  if (!met.IsDone() || met.IsParallel() || met.NbPoints() == 0) return std::puts("miss"), 0;
  double first = met.ParamOnConic(1);
  for (int i = 2; i <= met.NbPoints(); ++i) first = std::min(first, met.ParamOnConic(i));
  // A parameter is a length along the line; it is told in units of the direction as given.
  const long double dx = @dx@, dy = @dy@, dz = @dz@;
  std::printf("hit %.17g\n", double(first / std::sqrt(dx * dx + dy * dy + dz * dz)));
} catch (const Standard_Failure& raised) {
  std::fprintf(stderr, "raised: %s\n", raised.GetMessageString());
  std::puts("miss");
}
