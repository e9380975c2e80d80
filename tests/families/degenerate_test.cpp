#include <boost/multiprecision/cpp_int.hpp>

#include "families/upright.hpp"
#include "tests/families/drawn.hpp"

using namespace rayaudit;

namespace {

using Exact = boost::multiprecision::cpp_rational;
using ExactVec = Vec3<Exact>;

/// The exact axis or normal; nothing for a sphere.
ExactVec exact_axis(const Case& question) {
  struct {
    ExactVec operator()(const Disk<double>& shape) const { return in<Exact>(shape.normal); }
    ExactVec operator()(const Sphere<double>&) const { return {0, 0, 0}; }
    ExactVec operator()(const Cylinder<double>& shape) const {
      return in<Exact>(shape.top) - in<Exact>(shape.base);
    }
    ExactVec operator()(const Cone<double>& shape) const {
      return in<Exact>(shape.apex) - in<Exact>(shape.base);
    }
    ExactVec operator()(const CappedCylinder<double>& shape) const {
      return in<Exact>(shape.top) - in<Exact>(shape.base);
    }
    ExactVec operator()(const CappedCone<double>& shape) const {
      return in<Exact>(shape.apex) - in<Exact>(shape.base);
    }
  } of;
  return std::visit(of, question.shape);
}

bool is_zero(const ExactVec& v) { return v == ExactVec{0, 0, 0}; }
bool has_zero(const ExactVec& v) { return v.x == 0 || v.y == 0 || v.z == 0; }
bool is_sphere(const Case& question) {
  return std::holds_alternative<Sphere<double>>(question.shape);
}

double radius_of(const Case& question) {
  return std::visit([](const auto& shape) { return shape.radius; }, question.shape);
}

/// The coefficient of t^2 in the cone's field is |w|^2 |d x w|^2 - (r d.w)^2.
bool is_along_generator(const Case& question) {
  const ExactVec d = in<Exact>(question.ray.direction), w = exact_axis(question);
  const ExactVec across = cross(d, w);
  const Exact along = Exact(radius_of(question)) * dot(d, w);
  return dot(w, w) * dot(across, across) == along * along;
}
bool is_square_to_axis(const Case& question) {
  return dot(in<Exact>(question.ray.direction), exact_axis(question)) == 0;
}
bool is_along_axis(const Case& question) {
  return is_zero(cross(in<Exact>(question.ray.direction), exact_axis(question)));
}

/// Does the line pass through the edge of a cap with the centre?
bool is_through_edge(const Case& question, const ExactVec& centre) {
  const ExactVec d = in<Exact>(question.ray.direction), w = exact_axis(question);
  const ExactVec v = in<Exact>(question.ray.origin) - centre;
  const Exact r = radius_of(question);
  if (dot(d, w) == 0) return false;
  const Exact t = -dot(v, w) / dot(d, w);
  const ExactVec p = v + t * d;
  return dot(p, p) == r * r;
}
bool is_in_plane(const Case& question, const ExactVec& centre) {
  const ExactVec d = in<Exact>(question.ray.direction), w = exact_axis(question);
  return dot(d, w) == 0 && dot(in<Exact>(question.ray.origin) - centre, w) == 0;
}
bool begins_on_cap(const Case& question, const ExactVec& centre) {
  const Ray<double>& ray = question.ray;
  const ExactVec from = in<Exact>(ray.origin) + Exact(ray.t_min) * in<Exact>(ray.direction);
  const ExactVec p = from - centre;
  const Exact r = radius_of(question);
  return dot(p, exact_axis(question)) == 0 && dot(p, p) < r * r;
}

/// Does it hold for the centre of a cap?
template <class H>
bool at_cap(const Case& question, H&& holds) {
  if (const auto* cone = std::get_if<CappedCone<double>>(&question.shape))
    return holds(question, in<Exact>(cone->base));
  const auto& cylinder = std::get<CappedCylinder<double>>(question.shape);
  return holds(question, in<Exact>(cylinder.base)) || holds(question, in<Exact>(cylinder.top));
}

constexpr std::size_t disk = 0, cylinder = 2, cone = 3, few = 256;
constexpr std::array<std::size_t, 2> closed_shapes = {4, 5};

template <class H>
void require_all(std::string_view id, std::size_t shape, H&& holds) {
  const Family& family = family_of(id);
  for (const Format& format : {float_format, double_format})
    require_each(family, shape, format, drawn(family, shape, format, {}, 0, few), holds);
}

}  // namespace

BOOST_AUTO_TEST_CASE(frames_are_three_orthogonal_vectors_of_the_length_they_say) {
  Random random(1, "", "", double_format, {}, 0);
  for (int i = 0; i < 100; ++i) {
    const auto axes = drawing::frame(random, 1023);
    const Exact square = Exact(axes.length) * axes.length;
    const auto u = in<Exact>(axes.u), v = in<Exact>(axes.v), w = in<Exact>(axes.w);
    BOOST_TEST(((dot(u, v) == 0) && (dot(v, w) == 0) && (dot(w, u) == 0)));
    BOOST_TEST(((dot(u, u) == square) && (dot(v, v) == square) && (dot(w, w) == square)));
  }
}

BOOST_AUTO_TEST_CASE(at_least_half_of_the_degenerate_cases_are_in_general_position) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (family.strength != Strength::degenerate) return;
    const double general = share(drawn(family, shape, format), [](const Case& question) {
      const bool along_coordinates = !is_sphere(question) && has_zero(exact_axis(question));
      return !along_coordinates && !has_zero(in<Exact>(question.ray.direction));
    });
    BOOST_TEST(general > 0.5, family.id << ' ' << shape_names[shape] << ' ' << format.name);
  });
}

BOOST_AUTO_TEST_CASE(some_degenerate_cases_lie_along_the_coordinate_axes) {
  const auto aligned = [](const Case& question) {
    const ExactVec w = exact_axis(question);
    return (w.x == 0) + (w.y == 0) + (w.z == 0) == 2;
  };
  BOOST_TEST(share(drawn(family_of("tangent"), cylinder, float_format), aligned) > 0.08);
}

BOOST_AUTO_TEST_CASE(perpendicular_rays_are_exactly_so) {
  require_all("perpendicular", disk, is_along_axis);
  require_all("perpendicular", cylinder, is_square_to_axis);
  require_all("perpendicular", cone, is_square_to_axis);
}

BOOST_AUTO_TEST_CASE(parallel_rays_are_exactly_so) {
  require_all("parallel", disk, is_square_to_axis);
  require_all("parallel", cylinder, is_along_axis);
  require_all("parallel", cone, [](const Case& question) {
    return is_along_generator(question) || is_along_axis(question);
  });
}

BOOST_AUTO_TEST_CASE(most_rays_parallel_to_a_cone_are_along_a_generator) {
  const auto cases = drawn(family_of("parallel"), cone, double_format, {}, 0, few);
  const double along = share(cases, is_along_generator);
  BOOST_TEST(along > 0.6);
  BOOST_TEST(along < 0.9);
}

BOOST_AUTO_TEST_CASE(rays_within_are_exactly_along_the_surface) {
  require_all("within", disk, is_square_to_axis);
  require_all("within", cylinder, is_along_axis);
  require_all("within", cone, is_along_generator);
}

BOOST_AUTO_TEST_CASE(rays_to_the_rim_of_a_closed_shape_pass_exactly_through_an_edge) {
  for (const std::size_t shape : closed_shapes)
    require_all("rim", shape,
                [](const Case& question) { return at_cap(question, is_through_edge); });
}

BOOST_AUTO_TEST_CASE(a_quarter_of_them_come_from_inside) {
  const auto begins_inside = [](const Case& question) {
    const auto& shape = std::get<CappedCylinder<double>>(question.shape);
    const ExactVec v = in<Exact>(question.ray.origin) - in<Exact>(shape.base);
    const ExactVec w = exact_axis(question);
    const ExactVec across = cross(v, w);
    const Exact height = dot(v, w), r = shape.radius;
    return 0 < height && height < dot(w, w) && dot(across, across) < r * r * dot(w, w);
  };
  const double inside =
      share(drawn(family_of("rim"), closed_shapes[0], double_format), begins_inside);
  BOOST_TEST(inside > 0.2);
  BOOST_TEST(inside < 0.3);
}

BOOST_AUTO_TEST_CASE(half_of_what_has_to_do_with_surfaces_has_to_do_with_caps) {
  const auto along_cap = [](const Case& question) { return at_cap(question, is_in_plane); };
  const auto on_cap = [](const Case& question) { return at_cap(question, begins_on_cap); };
  for (const std::size_t shape : closed_shapes)
    for (const Format& format : {float_format, double_format}) {
      const std::array shares = {
          share(drawn(family_of("within"), shape, format), along_cap),
          share(drawn(family_of("surface"), shape, format), on_cap),
          share(drawn(family_of("parallel"), shape, format), is_square_to_axis)};
      for (const double each : shares) {
        BOOST_TEST(each > 0.4, shape_names[shape]);
        BOOST_TEST(each < 0.6, shape_names[shape]);
      }
    }
}

BOOST_AUTO_TEST_CASE(some_rays_within_a_cap_run_along_its_edge) {
  const auto along_edge = [](const Case& question) {
    return at_cap(question, [](const Case& each, const ExactVec& centre) {
      const ExactVec d = in<Exact>(each.ray.direction), v = in<Exact>(each.ray.origin) - centre;
      const ExactVec across = cross(v, d);
      const Exact r = radius_of(each);
      return is_in_plane(each, centre) && dot(across, across) == r * r * dot(d, d);
    });
  };
  for (const std::size_t shape : closed_shapes)
    BOOST_TEST(share(drawn(family_of("within"), shape, float_format), along_edge) > 0.03);
}
