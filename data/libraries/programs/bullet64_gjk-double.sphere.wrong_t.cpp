// Bullet 3.24, rayTestSingle with kF_UseGjkConvexCastRaytest
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs bullet-float64) -o PROGRAM
// case: sphere 0x1.ep+0 0x0p+0 0x0p+0 0x1.cp+1 ray 0x0p+0 0x0p+0 0x1.8p+1 0x1p+0 0x0p+0 0x0p+0 range 0x0p+0 0x1p+0
// exact: hit (15 - 4 sqrt(13)) / 8 = 0.07222436226800535344...
// observed: hit 0.07121320756037729
// wrong by: rayaudit judge --format double --convention inside=any,ray=segment,stand=upright_z
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
int main() {
  const btVector3 from(0.0, 0.0, 3.0), to = from + btVector3(1.0, 0.0, 0.0);
  btSphereShape shape(3.5);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  met.m_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  const auto at = [](const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(btVector3(1.875, 0.0, 0.0)), met);
  if (!met.hasHit()) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(met.m_closestHitFraction));
}
