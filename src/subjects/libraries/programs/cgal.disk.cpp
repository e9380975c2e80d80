// build: c++ -O2 -std=c++17 -frounding-math FILE -lmpfr -lgmp -o PROGRAM
// says any: "The intersection region of those two objects is defined as the set of all points p that are part of both obj1 and obj2." (manual, 2D and 3D Linear Geometry Kernel, do_intersect)
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <cstdio>
using Real = @real@;
using Kernel = CGAL::Simple_cartesian<Real>;
int main() {
  const Kernel::Point_3 origin(@ox@, @oy@, @oz@), centre(@cx@, @cy@, @cz@);
  const Kernel::Ray_3 line(origin, Kernel::Point_3(@ox@ + @dx@, @oy@ + @dy@, @oz@ + @dz@));
  const Kernel::Plane_3 plane(centre, Kernel::Vector_3(@nx@, @ny@, @nz@));
  const auto common = CGAL::intersection(line, plane);
  if (!common) return std::puts("miss"), 0;
  const auto* at = boost::get<Kernel::Point_3>(&*common);
  if (!at) return std::puts("yes"), 0;  // all of the line lies in the plane
  std::printf("at %.17g %.17g %.17g\n", double(at->x()), double(at->y()), double(at->z()));
}
