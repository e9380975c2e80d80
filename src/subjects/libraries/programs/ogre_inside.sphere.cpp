// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs OGRE) -o PROGRAM
// says false_hit: "A pair structure where the first element indicates whether an intersection occurs" (RayTestResult, OgreMath.h)
// says false_miss: "A pair structure where the first element indicates whether an intersection occurs" (RayTestResult, OgreMath.h)
// says behind: "the second element will indicate the distance along the ray at which it intersects" (RayTestResult, OgreMath.h), and for a plane the same class has "return RayTestResult(t >= 0, (Real)t);" (OgreRay.h)
// says wrong_root: "the second element will indicate the distance along the ray at which it intersects" (RayTestResult, OgreMath.h)
// says wrong_t: "the second element will indicate the distance along the ray at which it intersects" (RayTestResult, OgreMath.h)
// says not_finite: "the second element will indicate the distance along the ray at which it intersects" (RayTestResult, OgreMath.h)
#include <Ogre.h>
#include <cstdio>
int main() {
  const Ogre::Ray ray(Ogre::Vector3(@ox@, @oy@, @oz@), Ogre::Vector3(@dx@, @dy@, @dz@));
  const Ogre::Sphere sphere(Ogre::Vector3(@cx@, @cy@, @cz@), @r@);
  const Ogre::RayTestResult result = Ogre::Math::intersects(ray, sphere, false);
  if (!result.first) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(result.second));
}
