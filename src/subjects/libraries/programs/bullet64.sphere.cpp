// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs bullet-float64) -o PROGRAM
// says false_hit: "since, a large epsilon can cause an early termination with false positive results (ray intersections that shouldn't be there)" (BulletCollision/NarrowPhaseCollision/btConvexCast.h)
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
int main() {
  const btVector3 from(@ox@, @oy@, @oz@), to = from + btVector3(@dx@, @dy@, @dz@);
  btSphereShape shape(@r@);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  const auto at = [](const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(btVector3(@cx@, @cy@, @cz@)), met);
  if (!met.hasHit()) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(met.m_closestHitFraction));
}
