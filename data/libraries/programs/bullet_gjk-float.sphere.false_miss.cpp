// Bullet 3.24, rayTestSingle with kF_UseGjkConvexCastRaytest
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs bullet) -o PROGRAM
// case: sphere 0x1p-23 0x0p+0 0x0p+0 0x1p-24 ray 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 0x0p+0 range 0x0p+0 0x1p+0
// exact: hit 1 / 16777216 = 5.9604644775390625e-8
// observed: miss
// wrong by: rayaudit judge --format float --convention inside=any,ray=segment,stand=upright_z
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
int main() {
  const btVector3 from(0.0f, 0.0f, 0.0f), to = from + btVector3(1.0f, 0.0f, 0.0f);
  btSphereShape shape(5.9604645e-08f);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  met.m_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  const auto at = [](const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(btVector3(1.1920929e-07f, 0.0f, 0.0f)), met);
  if (!met.hasHit()) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(met.m_closestHitFraction));
}
