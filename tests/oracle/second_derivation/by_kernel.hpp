#pragma once

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_spherical_kernel_3.h>

#include <iterator>

#include "tests/oracle/second_derivation/derived.hpp"

/// Disk and sphere by the objects of CGAL's kernels: a line with a plane, a line with a sphere.
namespace rayaudit::second {

template <class K>
typename K::Point_3 point(const Vec3<double>& p) {
  return {typename K::FT(p.x), typename K::FT(p.y), typename K::FT(p.z)};
}

template <class K>
typename K::Vector_3 vector(const Vec3<double>& v) {
  return {typename K::FT(v.x), typename K::FT(v.y), typename K::FT(v.z)};
}

template <class K>
typename K::Line_3 line(const Ray<double>& ray) {
  return {point<K>(ray.origin), vector<K>(ray.direction)};
}

struct Meeting {
  Number t;
  bool touching;
};

/// Where the line of a ray meets a sphere, in order along it.
inline std::vector<Meeting> meetings(const Ray<double>& ray, const Sphere<double>& sphere) {
  using K = CGAL::Exact_spherical_kernel_3;
  using Met = CGAL::SK3_Intersection_traits<K, K::Sphere_3, K::Line_3>::type;
  const K::Sphere_3 around(point<K>(sphere.centre), CGAL::square(K::FT(sphere.radius)));
  std::vector<Met> met;
  K().intersect_3_object()(around, line<K>(ray), std::back_inserter(met));
  const auto t_of = [&](const K::Circular_arc_point_3& p) {
    const Vec3<double>&o = ray.origin, d = ray.direction;
    if (d.x != 0) return K::Root_of_2((p.x() - K::FT(o.x)) / K::FT(d.x));
    if (d.y != 0) return K::Root_of_2((p.y() - K::FT(o.y)) / K::FT(d.y));
    return K::Root_of_2((p.z() - K::FT(o.z)) / K::FT(d.z));
  };
  std::vector<std::pair<K::Root_of_2, bool>> roots;
  for (const Met& one : met) {
    const auto& [p, multiplicity] = boost::get<std::pair<K::Circular_arc_point_3, unsigned>>(one);
    roots.emplace_back(t_of(p), multiplicity == 2);
  }
  if (roots.size() == 2 && roots[1].first < roots[0].first) std::swap(roots[0], roots[1]);
  std::vector<Meeting> in_order;
  for (const auto& [t, touching] : roots)
    in_order.push_back(
        {[t = t](const Rational& q) { return static_cast<int>(CGAL::compare(t, q)); }, touching});
  return in_order;
}

inline Crossings on_line(const Ray<double>& ray, const Sphere<double>& sphere) {
  Crossings found;
  for (const Meeting& meeting : meetings(ray, sphere))
    found.push_back({meeting.touching ? oracle::Kind::tangent : oracle::Kind::proper, meeting.t});
  return found;
}

/// The kernel's exact number, which is GMP's own rational or Boost's around it, as CGAL finds them.
template <class Exact>
Rational as_rational(const Exact& x) {
  if constexpr (requires { x.get_mpq_t(); })
    return Rational(x.get_mpq_t());
  else
    return Rational(x.backend().data());
}

inline Crossings on_line(const Ray<double>& ray, const Disk<double>& disk) {
  using K = CGAL::Exact_predicates_exact_constructions_kernel;
  const K::Plane_3 plane(point<K>(disk.centre), vector<K>(disk.normal));
  const auto met = CGAL::intersection(line<K>(ray), plane);
  if (!met) return {};
  if (const auto* p = boost::get<K::Point_3>(&*met)) {
    const CGAL::Comparison_result reach =
        CGAL::compare_squared_distance(*p, point<K>(disk.centre), CGAL::square(K::FT(disk.radius)));
    if (reach == CGAL::LARGER) return {};
    const K::Vector_3 d = vector<K>(ray.direction);
    const K::FT t = ((*p - point<K>(ray.origin)) * d) / d.squared_length();
    return {{reach == CGAL::EQUAL ? oracle::Kind::rim : oracle::Kind::proper,
             number(as_rational(CGAL::exact(t)))}};
  }
  // The line lies in the plane: the disk is what a sphere of its centre and radius leaves of it.
  const auto ends = meetings(ray, {disk.centre, disk.radius});
  if (ends.empty()) return {};
  return {{oracle::Kind::within, ends.front().t, ends.back().t}};
}

inline Crossings by_kernel(const Case& question) {
  const Ray<double>& ray = question.ray;
  if (const auto* disk = std::get_if<Disk<double>>(&question.shape))
    return cut_to_range(on_line(ray, *disk), ray);
  return cut_to_range(on_line(ray, std::get<Sphere<double>>(question.shape)), ray);
}

}  // namespace rayaudit::second
