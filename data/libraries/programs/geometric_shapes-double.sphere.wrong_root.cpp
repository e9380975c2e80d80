// geometric_shapes 0.7.3, Body::intersectsRay
// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs geometric_shapes) -o PROGRAM
// case: sphere 0x0p+0 0x0p+0 0x0p+0 0x1p-15 ray 0x1.4p-8 0x0p+0 0x1p-9 -0x1.4p+2 0x0p+0 -0x1p+1
// exact: hit (928 - sqrt(29)) / 950272 = 0.00097089552800973352468..., at 2.833486e-05 0 1.1333944e-05
// observed: at -8.673617379884035e-19 0 0
// wrong by: rayaudit judge --format double --convention ray=line,stand=upright_z,t_min=0
#include <geometric_shapes/bodies.h>
#include <cstdio>
int main() {
  const shapes::Sphere shape(3.0517578125e-05);
  bodies::Sphere body(&shape);
  body.setPose(Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.0)));
  const Eigen::Vector3d from(0.0048828125, 0.0, 0.001953125), along(-5.0, 0.0, -2.0);
  EigenSTL::vector_Vector3d points;
  if (!body.intersectsRay(from, along, &points)) return std::puts("miss"), 0;
  if (points.empty()) return std::puts("yes"), 0;
  std::printf("at %.17g %.17g %.17g\n", points[0].x(), points[0].y(), points[0].z());
}
