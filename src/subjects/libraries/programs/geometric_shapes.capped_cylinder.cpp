// build: c++ -O2 -std=c++17 FILE $(pkg-config --cflags --libs geometric_shapes) -o PROGRAM
// says length: "Passing dir as a unit vector will result in faster computation." (Body::intersectsRay, geometric_shapes/bodies.h: a direction of any length will do)
// says false_hit: "Check if a ray intersects the body, and find the set of intersections, in order, along the ray." (Body::intersectsRay, geometric_shapes/bodies.h)
// says false_miss: "Check if a ray intersects the body, and find the set of intersections, in order, along the ray." (Body::intersectsRay, geometric_shapes/bodies.h)
// says wrong_root: "find the set of intersections, in order, along the ray" (Body::intersectsRay, geometric_shapes/bodies.h)
// says wrong_t: "find the set of intersections, in order, along the ray" (Body::intersectsRay, geometric_shapes/bodies.h)
// says behind: "find the set of intersections, in order, along the ray" (Body::intersectsRay, geometric_shapes/bodies.h)
// says not_finite: "find the set of intersections, in order, along the ray" (Body::intersectsRay, geometric_shapes/bodies.h)
#include <geometric_shapes/bodies.h>
#include <cstdio>
int main() {
  const shapes::Cylinder shape(@r@, 2 * @h@);
  const bodies::Cylinder body(&shape);
  const Eigen::Vector3d from(@ox@, @oy@, @oz@), along(@dx@, @dy@, @dz@);
  EigenSTL::vector_Vector3d points;
  if (!body.intersectsRay(from, along, &points)) return std::puts("miss"), 0;
  if (points.empty()) return std::puts("yes"), 0;
  std::printf("at %.17g %.17g %.17g\n", points[0].x(), points[0].y(), points[0].z());
}
