// OGRE 1.12.10, Math::intersects
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs OGRE) -o PROGRAM
// case: disk 0x0p+0 0x0p+0 0x0p+0 0x1p-17 -0x1.8p-17 0x1.8p-17 0x1p+0 unbounded ray 0x1p+0 0x0p+0 0x0p+0 0x1p-4 0x1p-4 0x1p-6
// exact: hit 128
// observed: miss
// wrong by: rayaudit judge --format float --convention inside=start,ray=line,extent=unbounded,t_min=0
#include <Ogre.h>
#include <cstdio>
int main() {
  const Ogre::Ray ray(Ogre::Vector3(1.0f, 0.0f, 0.0f), Ogre::Vector3(0.0625f, 0.0625f, 0.015625f));
  const Ogre::Plane plane(Ogre::Vector3(7.6293945e-06f, -1.1444092e-05f, 1.1444092e-05f), Ogre::Vector3(0.0f, 0.0f, 0.0f));
  const Ogre::RayTestResult result = Ogre::Math::intersects(ray, plane);
  if (!result.first) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(result.second));
}
