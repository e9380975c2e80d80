// build: c++ -O2 -std=c++17 -frounding-math FILE -lmpfr -lgmp -o PROGRAM
// says false_hit: "It provides exact geometric predicates, but inexact geometric constructions." (manual, 2D and 3D Linear Geometry Kernel, Exact_predicates_inexact_constructions_kernel)
// says false_miss: "It provides exact geometric predicates, but inexact geometric constructions." (manual, 2D and 3D Linear Geometry Kernel, Exact_predicates_inexact_constructions_kernel)
// says any: "Two objects obj1 and obj2 intersect if there is a point p that is part of both obj1 and obj2." (manual, 2D and 3D Linear Geometry Kernel, do_intersect)
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/intersections.h>
#include <cstdio>
using Real = double;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
int main() {
  const Kernel::Point_3 origin(@ox@, @oy@, @oz@), centre(@cx@, @cy@, @cz@);
  const Kernel::Ray_3 line(origin, Kernel::Point_3(@ox@ + @dx@, @oy@ + @dy@, @oz@ + @dz@));
  const Real radius = @r@;
  const Kernel::Sphere_3 sphere(centre, radius * radius);
  std::puts(CGAL::do_intersect(line, sphere) ? "yes" : "miss");
}
