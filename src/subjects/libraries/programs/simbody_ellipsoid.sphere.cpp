// build: c++ -O2 FILE $(pkg-config --cflags simbody) -lSimTKmath -lSimTKcommon -o PROGRAM
// says false_hit: "Determine whether this object intersects a ray, and if so, find the intersection point. [...] return true if an intersection is found, false otherwise." (ContactGeometry::intersectsRay, simmath/internal/ContactGeometry.h)
// says false_miss: "Determine whether this object intersects a ray, and if so, find the intersection point. [...] return true if an intersection is found, false otherwise." (ContactGeometry::intersectsRay, simmath/internal/ContactGeometry.h)
// says wrong_root: "If an intersection is found, the distance from the ray origin to the intersection point is stored in this." (ContactGeometry::intersectsRay, simmath/internal/ContactGeometry.h)
// says wrong_t: "If an intersection is found, the distance from the ray origin to the intersection point is stored in this." (ContactGeometry::intersectsRay, simmath/internal/ContactGeometry.h)
// says behind: "If an intersection is found, the distance from the ray origin to the intersection point is stored in this." (ContactGeometry::intersectsRay, simmath/internal/ContactGeometry.h)
// says not_finite: "If an intersection is found, the distance from the ray origin to the intersection point is stored in this." (ContactGeometry::intersectsRay, simmath/internal/ContactGeometry.h)
#include <SimTKmath.h>
#include <cstdio>
using namespace SimTK;
int main() {
  const Vec3 from = Transform(Vec3(@cx@, @cy@, @cz@)).shiftBaseStationToFrame(Vec3(@ox@, @oy@, @oz@)), along(@dx@, @dy@, @dz@);
  const ContactGeometry::Ellipsoid shape(Vec3(@r@));
  Real distance;
  UnitVec3 normal;
  if (!shape.intersectsRay(from, UnitVec3(along), distance, normal)) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", distance / along.norm());
}
