// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs bullet) -o PROGRAM
// says false_miss: "GjkConvexCast performs a raycast on a convex object using support mapping." (BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h)
// says false_hit: "The btSphereShape implements an implicit sphere, centered around a local origin with radius." (BulletCollision/CollisionShapes/btSphereShape.h), and "approximate" is said only of the other algorithm (btRaycastCallback.h)
// says wrong_root: "The btSphereShape implements an implicit sphere, centered around a local origin with radius." (BulletCollision/CollisionShapes/btSphereShape.h), and "approximate" is said only of the other algorithm (btRaycastCallback.h)
// says wrong_t: "The btSphereShape implements an implicit sphere, centered around a local origin with radius." (BulletCollision/CollisionShapes/btSphereShape.h), and "approximate" is said only of the other algorithm (btRaycastCallback.h)
#include <btBulletCollisionCommon.h>
#include <BulletCollision/NarrowPhaseCollision/btRaycastCallback.h>
#include <cstdio>
int main() {
  const btVector3 from(@ox@, @oy@, @oz@), to = from + btVector3(@dx@, @dy@, @dz@);
  btSphereShape shape(@r@);
  btCollisionObject object;
  btCollisionWorld::ClosestRayResultCallback met(from, to);
  met.m_flags = btTriangleRaycastCallback::kF_UseGjkConvexCastRaytest;
  const auto at = [](const btVector3& place) { return btTransform(btQuaternion::getIdentity(), place); };
  btCollisionWorld::rayTestSingle(at(from), at(to), &object, &shape, at(btVector3(@cx@, @cy@, @cz@)), met);
  if (!met.hasHit()) return std::puts("miss"), 0;
  std::printf("hit %.17g\n", double(met.m_closestHitFraction));
}
