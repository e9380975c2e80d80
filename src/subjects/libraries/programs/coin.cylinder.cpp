// build: c++ -O2 -std=c++17 FILE -lCoin -o PROGRAM
// says false_miss: "If the ray does not intersect the cylinder, FALSE is returned, otherwise we will return TRUE." (SbCylinder::intersect)
// says false_hit: "If the ray does not intersect the cylinder, FALSE is returned, otherwise we will return TRUE." (SbCylinder::intersect)
// says wrong_root: "Find the intersection points of the ray l on the cylinder and return these in enter and exit." (SbCylinder::intersect)
// says wrong_t: "Find the intersection points of the ray l on the cylinder and return these in enter and exit." (SbCylinder::intersect)
// says not_finite: "Find the intersection points of the ray l on the cylinder and return these in enter and exit." (SbCylinder::intersect)
// says any: "The cylinder has no length/height value, which means it is treated as of infinite length." (SbCylinder)
#include <Inventor/SbLine.h>
#include <Inventor/SbCylinder.h>
#include <cstdio>
int main() {
  SbLine line;
  line.setPosDir(SbVec3f(@ox@, @oy@, @oz@), SbVec3f(@dx@, @dy@, @dz@));
  const SbLine axis(SbVec3f(@ax@, @ay@, @az@), SbVec3f(@bx@, @by@, @bz@));
  const SbCylinder cylinder(axis, @r@);
  SbVec3f enter, exit;
  if (!cylinder.intersect(line, enter, exit)) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", enter[0], enter[1], enter[2]);
}
