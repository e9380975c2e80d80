// Coin 4.0.0, SoRayPickAction
// build: c++ -O2 -std=c++17 FILE -lCoin -o PROGRAM
// case: sphere 0x0p+0 0x1.8p+23 0x0p+0 0x1p+22 ray 0x1.8p+23 0x0p+0 0x1.8p+23 -0x1.6p+0 0x1.4p+0 -0x1.cp-1
// exact: hit 436207616 / 45 = 9693502.5777777777778...
// observed: miss
// wrong by: rayaudit judge --format float --convention stand=upright_y,t_min=0
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
  place->translation.setValue(0.0f, 12582912.0f, 0.0f);
  sphere->radius.setValue(4194304.0f);
  SoRayPickAction action(SbViewportRegion(100, 100));
  // Near and far are distances, none where they are below 0.
  const long double dx = -1.375f, dy = 1.25f, dz = -0.875f;
  const long double length = std::sqrt(dx * dx + dy * dy + dz * dz);
  const double near = 0.0f, far = INFINITY;
  action.setRay(SbVec3f(12582912.0f, 0.0f, 12582912.0f), SbVec3f(-1.375f, 1.25f, -0.875f),
                std::isfinite(near) ? float(near * length) : -1,
                std::isfinite(far) ? float(far * length) : -1);
  action.apply(scene);
  const SoPickedPoint* point = action.getPickedPoint();
  if (point == nullptr) return std::puts("miss"), 0;
  const SbVec3f& at = point->getPoint();
  std::printf("at %.17g %.17g %.17g\n", at[0], at[1], at[2]);
}
