// build: c++ -O2 -std=c++17 FILE -lCoin -o PROGRAM
// says false_miss: "If the ray does not intersect the sphere, FALSE is returned, otherwise we will return TRUE." (SbSphere::intersect)
// says false_hit: "If the ray does not intersect the sphere, FALSE is returned, otherwise we will return TRUE." (SbSphere::intersect)
// says wrong_root: "Find the intersection points of the ray l on the sphere and return these in enter and exit." (SbSphere::intersect)
// says wrong_t: "Find the intersection points of the ray l on the sphere and return these in enter and exit." (SbSphere::intersect)
// says not_finite: "Find the intersection points of the ray l on the sphere and return these in enter and exit." (SbSphere::intersect)
#include <Inventor/SbLine.h>
#include <Inventor/SbSphere.h>
#include <cstdio>
int main() {
  SbLine line;
  line.setPosDir(SbVec3f(@ox@, @oy@, @oz@), SbVec3f(@dx@, @dy@, @dz@));
  const SbSphere sphere(SbVec3f(@cx@, @cy@, @cz@), @r@);
  SbVec3f enter, exit;
  if (!sphere.intersect(line, enter, exit)) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", enter[0], enter[1], enter[2]);
}
