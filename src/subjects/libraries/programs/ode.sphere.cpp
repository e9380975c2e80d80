// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs ode) -o PROGRAM
// says false_hit: "If the geoms intersect, this function returns the number of contact points generated (and updates the contact array), otherwise it returns 0" (dCollide, ode/collision.h)
// says false_miss: "If the geoms intersect, this function returns the number of contact points generated (and updates the contact array), otherwise it returns 0" (dCollide, ode/collision.h)
// says wrong_root: "pos - This is the point at which the ray intersects the surface of the other geom, regardless of whether the ray starts from inside or outside the geom." (manual, Geometry Classes, Ray Class)
// says behind: "pos - This is the point at which the ray intersects the surface of the other geom, regardless of whether the ray starts from inside or outside the geom." (manual, Geometry Classes, Ray Class)
// says wrong_t: "depth - This is the distance from the start of the ray to the contact point." (manual, Geometry Classes, Ray Class)
// says not_finite: "depth - This is the distance from the start of the ray to the contact point." (manual, Geometry Classes, Ray Class)
// says crashed: "Set the starting position (px,py,pz) and direction (dx,dy,dz) of the given ray." (dGeomRaySet, manual; nothing is said of directions that it cannot take)
#include <ode/ode.h>
#include <cmath>
#include <cstdio>
int main() {
  dInitODE2(0);
  const dReal dx = @dx@, dy = @dy@, dz = @dz@;
  const dGeomID ray = dCreateRay(nullptr, dInfinity);
  dGeomRaySet(ray, @ox@, @oy@, @oz@, dx, dy, dz);
  const dGeomID other = dCreateSphere(nullptr, @r@);
  dGeomSetPosition(other, @cx@, @cy@, @cz@);
  dContactGeom contact;
  if (dCollide(ray, other, 1, &contact, sizeof contact) == 0) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", contact.depth / std::hypot(dx, dy, dz));
}
