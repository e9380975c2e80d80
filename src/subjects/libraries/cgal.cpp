#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/intersections.h>
#include <CGAL/version_macros.h>

#include <limits>

#include "rayaudit/plugin.h"

/// CGAL's kernels whose numbers round, as a plugin: rays and lines against spheres and planes. What
/// is relied on is quoted from its manual (2D and 3D Linear Geometry Kernel).
namespace {

using InexactConstructions = CGAL::Exact_predicates_inexact_constructions_kernel;

template <class Kernel>
typename Kernel::Point_3 point(const rayaudit_vec3& of) {
  using Number = typename Kernel::FT;
  return {static_cast<Number>(of.x), static_cast<Number>(of.y), static_cast<Number>(of.z)};
}

template <class Kernel>
typename Kernel::Vector_3 vector(const rayaudit_vec3& of) {
  using Number = typename Kernel::FT;
  return {static_cast<Number>(of.x), static_cast<Number>(of.y), static_cast<Number>(of.z)};
}

/// A ray from one point through another, which is all it keeps (RayC3.h): what it is told of a
/// direction it adds to the point, and rounds.
template <class Kernel>
struct Rays {
  static constexpr bool is_line = false;
  static typename Kernel::Ray_3 made(const rayaudit_ray& ray) {
    const rayaudit_vec3 &from = ray.origin, &way = ray.direction;
    return {point<Kernel>(from), point<Kernel>({from.x + way.x, from.y + way.y, from.z + way.z})};
  }
};

/// A line, which keeps a point and a direction as they are (LineC3.h).
template <class Kernel>
struct Lines {
  static constexpr bool is_line = true;
  static typename Kernel::Line_3 made(const rayaudit_ray& ray) {
    return {point<Kernel>(ray.origin), vector<Kernel>(ray.direction)};
  }
};

/// "checks whether obj1 and obj2 intersect" (do_intersect), of a sphere that is told the square of
/// its radius, rounded as the product of two numbers of the kernel is.
template <class Kernel, template <class> class Line>
rayaudit_answer sphere(const rayaudit_ray& ray, const rayaudit_sphere& sphere) {
  const auto radius = static_cast<typename Kernel::FT>(sphere.radius);
  const typename Kernel::Sphere_3 ball(point<Kernel>(sphere.centre), radius * radius);
  return CGAL::do_intersect(Line<Kernel>::made(ray), ball) ? rayaudit_yes() : rayaudit_miss();
}

/// "The intersection region of those two objects is defined as the set of all points p that are
/// part of both" (do_intersect): a point, or all of a line that lies in the plane.
template <class Kernel, template <class> class Line>
rayaudit_answer plane(const rayaudit_ray& ray, const rayaudit_disk& disk) {
  const typename Kernel::Plane_3 plane(point<Kernel>(disk.centre), vector<Kernel>(disk.normal));
  const auto common = CGAL::intersection(Line<Kernel>::made(ray), plane);
  if (!common) return rayaudit_miss();
  const auto* at = boost::get<typename Kernel::Point_3>(&*common);
  return at ? rayaudit_at(at->x(), at->y(), at->z()) : rayaudit_yes();
}

template <auto hit, auto shape>
void batch(const rayaudit_case* cases, std::size_t count, rayaudit_answer* answers) {
  for (std::size_t i = 0; i < count; ++i) answers[i] = hit(cases[i].ray, cases[i].is.*shape);
}

using Shapes = decltype(rayaudit_case::is);

/// Of touches: "Two objects obj1 and obj2 intersect if there is a point p that is part of both"
/// (do_intersect), to which only exact numbers can be held.
template <class Kernel, template <class> class Line>
rayaudit_subject subject(const char* name, const char* format, const char* about) {
  rayaudit_subject made = {};
  made.name = name, made.format = format, made.about = about;
  made.convention.extent = RAYAUDIT_UNBOUNDED;
  // Neither knows a range: whatever it is, a ray goes on from its start, without end.
  made.convention.line = 1;
  if (!Line<Kernel>::is_line) {
    made.convention.segment = 1;
    made.convention.t_min = 0, made.convention.t_max = std::numeric_limits<double>::infinity();
  }
  made.disk = batch<plane<Kernel, Line>, &Shapes::disk>;
  made.sphere = batch<sphere<Kernel, Line>, &Shapes::sphere>;
  return made;
}

template <class Kernel>
rayaudit_subject rays(const char* name, const char* format, const char* about) {
  return subject<Kernel, Rays>(name, format, about);
}
template <class Kernel>
rayaudit_subject lines(const char* name, const char* format, const char* about) {
  return subject<Kernel, Lines>(name, format, about);
}

constexpr auto in_float = "CGAL " CGAL_VERSION_STR ", Simple_cartesian<float>";
constexpr auto in_double = "CGAL " CGAL_VERSION_STR ", Simple_cartesian<double>";
constexpr auto filtered =
    "CGAL " CGAL_VERSION_STR ", Exact_predicates_inexact_constructions_kernel";

const rayaudit_subject subjects[] = {
    rays<CGAL::Simple_cartesian<float>>("cgal", "float", in_float),
    rays<CGAL::Simple_cartesian<double>>("cgal", "double", in_double),
    rays<InexactConstructions>("cgal_epick", "double", filtered),
    lines<CGAL::Simple_cartesian<float>>("cgal_line", "float", in_float),
    lines<CGAL::Simple_cartesian<double>>("cgal_line", "double", in_double),
    lines<InexactConstructions>("cgal_epick_line", "double", filtered)};

}  // namespace

RAYAUDIT_PLUGIN(subjects)
