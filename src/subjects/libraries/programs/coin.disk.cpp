// build: c++ -O2 -std=c++17 FILE -lCoin -o PROGRAM
// says false_miss: "If the line is parallel to the plane, we return FALSE, otherwise TRUE." (SbPlane::intersect)
// says false_hit: "If the line is parallel to the plane, we return FALSE, otherwise TRUE." (SbPlane::intersect)
// says wrong_root: "Find the point on given line l intersecting the plane and return it in intersection." (SbPlane::intersect)
// says wrong_t: "Find the point on given line l intersecting the plane and return it in intersection." (SbPlane::intersect)
// says not_finite: "Find the point on given line l intersecting the plane and return it in intersection." (SbPlane::intersect)
#include <Inventor/SbLine.h>
#include <Inventor/SbPlane.h>
#include <cstdio>
int main() {
  SbLine line;
  line.setPosDir(SbVec3f(@ox@, @oy@, @oz@), SbVec3f(@dx@, @dy@, @dz@));
  const SbPlane plane(SbVec3f(@nx@, @ny@, @nz@), SbVec3f(@cx@, @cy@, @cz@));
  SbVec3f enter;
  if (!plane.intersect(line, enter)) return std::puts("miss"), 0;
  std::printf("at %.17g %.17g %.17g\n", enter[0], enter[1], enter[2]);
}
