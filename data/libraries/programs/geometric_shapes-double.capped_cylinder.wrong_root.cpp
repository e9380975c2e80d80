// geometric_shapes 0.7.3, Body::intersectsRay
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs geometric_shapes) -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1.cff0560ep-2 0x0p+0 0x0p+0 0x1.cff0560ep-2 0x1.fd2c3fcp-1 ray 0x1.140e176p+0 -0x1.4412664p-1 0x1.35cd588p-1 -0x1.c456c4p+0 0x1.53582fp+1 -0x1.a61d624p+0
// exact: hit 1305816441 / 14163821696 = 0.09219379268017580105..., at 0.915438292 -0.388535271 0.453065247
// observed: at 0.9154382931118126 -0.3885352726497274 0.45306524800480774
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <geometric_shapes/bodies.h>
#include <cstdio>
int main() {
  const shapes::Cylinder shape(0.9944782182574272, 2 * 0.4530652471585199);
  const bodies::Cylinder body(&shape);
  const Eigen::Vector3d from(1.0783400163054466, -0.6329528763890266, 0.6050822883844376), along(-1.766948938369751, 2.651128649711609, -1.6488858610391617);
  EigenSTL::vector_Vector3d points;
  if (!body.intersectsRay(from, along, &points)) return std::puts("miss"), 0;
  if (points.empty()) return std::puts("yes"), 0;
  std::printf("at %.17g %.17g %.17g\n", points[0].x(), points[0].y(), points[0].z());
}
