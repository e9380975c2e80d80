// OGRE 1.12.10, Math::intersects
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs OGRE) -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x0p+0 0x0p+0 0x1p+1 0x0p+0 0x0p+0 0x1p+0
// exact: miss
// observed: hit -1
// wrong by: rayaudit judge --format float --convention inside=start,ray=line,extent=unbounded,t_min=0
#include <Ogre.h>
#include <cstdio>
int main() {
  const Ogre::Ray ray(Ogre::Vector3(0.0f, 0.0f, 2.0f), Ogre::Vector3(0.0f, 0.0f, 1.0f));
  const Ogre::Sphere sphere(Ogre::Vector3(0.0f, 0.0f, 0.0f), 1.0f);
  const Ogre::RayTestResult result = Ogre::Math::intersects(ray, sphere);
  if (!result.first) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(result.second));
}
