// build: c++ -O2 -std=c++17 FILE -lCoin -o PROGRAM
// says false_miss: "The SoRayPickAction class does ray intersection with scene graphs." (SoRayPickAction)
// says false_hit: "The SoRayPickAction class does ray intersection with scene graphs." (SoRayPickAction)
// says wrong_root: "Returns whether only the closest object or all the objects the ray intersects with is picked." (SoRayPickAction::isPickAll; the closest by default)
// says wrong_t: "Use this method if you want to send any ray through the scene to detect intersections" (SoRayPickAction::setRay)
// says not_finite: "Use this method if you want to send any ray through the scene to detect intersections" (SoRayPickAction::setRay)
#include <Inventor/SbViewportRegion.h>
#include <Inventor/SoDB.h>
#include <Inventor/SoPickedPoint.h>
#include <Inventor/actions/SoRayPickAction.h>
#include <Inventor/nodes/SoSeparator.h>
#include <Inventor/nodes/SoSphere.h>
#include <Inventor/nodes/SoTranslation.h>
#include <cmath>
#include <cstdio>
int main() {
  SoDB::init();
  auto* scene = new SoSeparator;
  auto* place = new SoTranslation;
  auto* sphere = new SoSphere;
  scene->ref(), scene->addChild(place), scene->addChild(sphere);
  place->translation.setValue(@cx@, @cy@, @cz@);
  sphere->radius.setValue(@r@);
  SoRayPickAction action(SbViewportRegion(100, 100));
  // Near and far are distances, none where they are below 0.
  const long double dx = @dx@, dy = @dy@, dz = @dz@;
  const long double length = std::sqrt(dx * dx + dy * dy + dz * dz);
  const double near = @t_min@, far = @t_max@;
  action.setRay(SbVec3f(@ox@, @oy@, @oz@), SbVec3f(@dx@, @dy@, @dz@),
                std::isfinite(near) ? float(near * length) : -1,
                std::isfinite(far) ? float(far * length) : -1);
  action.apply(scene);
  const SoPickedPoint* point = action.getPickedPoint();
  if (point == nullptr) return std::puts("miss"), 0;
  const SbVec3f& at = point->getPoint();
  std::printf("at %.17g %.17g %.17g\n", at[0], at[1], at[2]);
}
