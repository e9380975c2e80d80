// geometric_shapes 0.7.3, Body::intersectsRay
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs geometric_shapes) -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p+0 ray 0x1p+1 0x0p+0 0x0p+0 -0x1p-1 0x0p+0 0x0p+0
// exact: hit 2
// observed: miss
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <geometric_shapes/bodies.h>
#include <cstdio>
int main() {
  const shapes::Sphere shape(1.0);
  bodies::Sphere body(&shape);
  body.setPose(Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.0)));
  const Eigen::Vector3d from(2.0, 0.0, 0.0), along(-0.5, 0.0, 0.0);
  EigenSTL::vector_Vector3d points;
  if (!body.intersectsRay(from, along, &points)) return std::puts("miss"), 0;
  if (points.empty()) return std::puts("yes"), 0;
  std::printf("at %.17g %.17g %.17g\n", points[0].x(), points[0].y(), points[0].z());
}
