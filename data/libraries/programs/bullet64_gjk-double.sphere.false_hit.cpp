// Bullet 3.24, rayTestSingle with kF_UseGjkConvexCastRaytest
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs bullet-float64) -o PROGRAM
// case: sphere 0x0p+0 0x1p-30 0x1p-10 0x1p-11 ray 0x0p+0 0x0p+0 0x0p+0 0x0p+0 0x1p+0 0x0p+0 range 0x0p+0 0x1p+0
// exact: miss
// observed: hit 0
// wrong by: rayaudit judge --format double --convention inside=any,ray=segment,stand=upright_z
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
int main() {
  const btVector3 from(0.0, 0.0, 0.0), to = from + btVector3(0.0, 1.0, 0.0);
  btSphereShape shape(0.00048828125);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  met.m_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  const auto at = [](const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(btVector3(0.0, 9.313225746154785e-10, 0.0009765625)), met);
  if (!met.hasHit()) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(met.m_closestHitFraction));
}
