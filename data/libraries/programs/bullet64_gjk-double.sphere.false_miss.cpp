// Bullet 3.24, rayTestSingle with kF_UseGjkConvexCastRaytest
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs bullet-float64) -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p-53 ray 0x0p+0 0x1p-52 0x0p+0 0x0p+0 -0x1p+0 0x0p+0 range 0x0p+0 0x1p+0
// exact: hit 1 / 9007199254740992 = 1.1102230246251565404e-16...
// observed: miss
// wrong by: rayaudit judge --format double --convention inside=any,ray=segment,stand=upright_z
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
int main() {
  const btVector3 from(0.0, 2.220446049250313e-16, 0.0), to = from + btVector3(0.0, -1.0, 0.0);
  btSphereShape shape(1.1102230246251565e-16);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  met.m_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  const auto at = [](const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(btVector3(0.0, 0.0, 0.0)), met);
  if (!met.hasHit()) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(met.m_closestHitFraction));
}
