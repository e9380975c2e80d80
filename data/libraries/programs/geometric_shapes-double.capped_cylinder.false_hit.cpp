// geometric_shapes 0.7.3, Body::intersectsRay
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs geometric_shapes) -o PROGRAM
// case: capped_cylinder 0x0p+0 0x0p+0 -0x1.882p-22 0x0p+0 0x0p+0 0x1.882p-22 0x1p+0 ray 0x0p+0 0x0p+0 0x1.89p-22 0x0p+0 0x1p+0 0x0p+0
// exact: miss
// observed: at 0 1 3.6600977182388306e-07
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <geometric_shapes/bodies.h>
#include <cstdio>
int main() {
  const shapes::Cylinder shape(1.0, 2 * 3.651948645710945e-07);
  const bodies::Cylinder body(&shape);
  const Eigen::Vector3d from(0.0, 0.0, 3.6600977182388306e-07), along(0.0, 1.0, 0.0);
  EigenSTL::vector_Vector3d points;
  if (!body.intersectsRay(from, along, &points)) return std::puts("miss"), 0;
  if (points.empty()) return std::puts("yes"), 0;
  std::printf("at %.17g %.17g %.17g\n", points[0].x(), points[0].y(), points[0].z());
}
