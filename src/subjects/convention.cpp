#include "subjects/convention.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "geometry/error.hpp"
#include "subjects/posing.hpp"

namespace rayaudit {
namespace {

using posing::in_format;

/// Brings a vector as near to length 1 as the format has it, and tells how long it was; one without
/// a length stays as it is.
long double normalise(Vec3<double>& v, const Format& format) {
  const auto [x, y, z] = in<long double>(v);
  // The largest component is brought near 1 first: a square must neither overflow nor underflow.
  const long double size = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (!(size > 0) || !std::isfinite(size)) return 1;
  const Vec3<long double> part = {x / size, y / size, z / size};
  const long double length = std::sqrt(part.x * part.x + part.y * part.y + part.z * part.z);
  const auto scaled = [&](long double component) { return in_format(component / length, format); };
  v = {scaled(part.x), scaled(part.y), scaled(part.z)};
  return size * length;
}

std::string figure(double x) {
  std::string text(32, '\0');
  text.resize(static_cast<std::size_t>(std::snprintf(text.data(), text.size(), "%g", x)));
  return text;
}

/// Is the length as near to 1 as normalising in the format brings it?
bool is_unit(const Vec3<double>& direction, const Format& format) {
  const auto [x, y, z] = in<long double>(direction);
  return std::fabs(x * x + y * y + z * z - 1) <= std::ldexp(2.0L, format.unit_exponent());
}

/// Direction, with t in its units, and the normal of a disk; what has length 1 stays, for
/// normalised again, one vector in a hundred would become another.
void normalise(Case& question, const Format& format) {
  Ray<double>& ray = question.ray;
  if (!is_unit(ray.direction, format)) {
    const long double length = normalise(ray.direction, format);
    for (double* t : {&ray.t_min, &ray.t_max})
      if (std::isfinite(*t)) *t = in_format(*t * length, format);
  }
  auto* const disk = std::get_if<Disk<double>>(&question.shape);
  if (disk != nullptr && !is_unit(disk->normal, format)) normalise(disk->normal, format);
}

/// The range that the subject answers in; a NaN stays, for it makes the case invalid.
void cut_range(Ray<double>& ray, const Convention& convention) {
  if (convention.line) {
    ray.t_min = -std::numeric_limits<double>::infinity();
    ray.t_max = std::numeric_limits<double>::infinity();
  }
  if (ray.t_min < convention.t_min) ray.t_min = convention.t_min;
  if (ray.t_max > convention.t_max) ray.t_max = convention.t_max;
}

/// Is it what a subject is asked that takes two points: of their segment, or of the line through
/// them?
bool is_of_points(const Ray<double>& ray, const Convention& convention, const Format& format) {
  return convention.line ? posing::is_between_points(ray, format) : posing::is_segment(ray, format);
}

/// What cases are drawn in for who works in the format.
const Format& drawn_in(const Format& format) {
  return format == float_format ? float_format : double_format;
}

/// Null where a shape is no cone.
template <class S>
auto* cone_radius(S& any) {
  return std::visit(
      [](auto& shape) {
        auto* radius = &shape.radius;
        if constexpr (!requires { shape.apex; }) radius = nullptr;
        return radius;
      },
      any);
}

/// Where there is only one nappe, both are one.
Extent extent_of(const Shape& shape, Extent extent) {
  if (!has_extent(shape)) return Extent::bounded;
  const bool is_cone = std::holds_alternative<Cone<double>>(shape);
  return extent == Extent::both_nappes && !is_cone ? Extent::unbounded : extent;
}

}  // namespace

std::string_view word(Convention::Stand stand) {
  return std::array{"anywhere", "upright_y", "upright_z"}[static_cast<std::size_t>(stand)];
}
std::string_view word(Convention::Opening opening) {
  return std::array{"radius", "angle", "cosine"}[static_cast<std::size_t>(opening)];
}

std::string_view name(Convention::Inside inside) {
  constexpr std::array<std::string_view, 4> names = {"hit", "miss", "start", "any"};
  return names[static_cast<std::size_t>(inside)];
}

bool has_range(const Convention& convention) { return convention.t_min < convention.t_max; }

std::string contradiction(const Convention& convention) {
  if (!has_range(convention)) return empty_range(convention);
  if (convention.opening != Convention::Opening::radius &&
      convention.stand == Convention::Stand::anywhere)
    return "an opening that is no radius, but no stand that is upright";
  if (convention.segment && convention.unit_direction)
    return "a segment, whose direction is as long as it is, with a direction of length 1";
  return {};
}

std::string empty_range(const Convention& convention) {
  return "the empty range from " + figure(convention.t_min) + " to " + figure(convention.t_max) +
         " for t";
}

Convention joined(const Convention& first, const Convention& second) {
  Convention made = first;
  for (std::size_t i = 0; i < made.stances.size(); ++i)
    if (made.stances[i] == Convention::Stance::either) made.stances[i] = second.stances[i];
  if (made.inside == Convention::Inside::hit) made.inside = second.inside;
  made.unit_direction |= second.unit_direction;
  if (!made.line && !made.segment) made.line = second.line, made.segment = second.segment;
  if (made.extent == Extent::bounded) made.extent = second.extent;
  if (made.stand == Convention::Stand::anywhere) made.stand = second.stand;
  if (made.opening == Convention::Opening::radius) made.opening = second.opening;
  made.t_min = std::max(made.t_min, second.t_min);
  made.t_max = std::min(made.t_max, second.t_max);
  if (const std::string wrong = contradiction(made); !wrong.empty())
    throw Error("--convention leaves, with what a subject declares itself, " + wrong);
  return made;
}

bool poses(const Convention& convention) {
  return convention.unit_direction || convention.line || convention.segment ||
         convention.extent != Extent::bounded || convention.stand != Convention::Stand::anywhere ||
         convention.opening != Convention::Opening::radius || std::isfinite(convention.t_min) ||
         std::isfinite(convention.t_max);
}

Case posed(const Case& question, const Convention& convention, const Format& format) {
  using Stand = Convention::Stand;
  using Opening = Convention::Opening;
  const Format& in = drawn_in(format);
  Case made = question;
  if (convention.extent != Extent::bounded) made.extent = extent_of(made.shape, convention.extent);
  if (convention.stand != Stand::anywhere) made = posing::stood(made, convention.stand, in);
  if (convention.opening != Opening::radius) made = posing::opened(made, convention.opening, in);
  if (convention.unit_direction) normalise(made, in);
  const bool is_made = is_of_points(made.ray, convention, in);
  if (convention.segment && !convention.line) {
    if (is_made) return made;
    cut_range(made.ray, convention);
    return posing::cut(made, in);
  }
  if (convention.segment && !is_made) {
    // Of a line no range is left, whatever it was.
    made.ray.t_min = 0, made.ray.t_max = std::numeric_limits<double>::infinity();
    made = posing::cut(made, in);
  }
  cut_range(made.ray, convention);
  return made;
}

Case rounded(const Case& question, const Format& format) {
  Case made = question;
  const auto round = [&](double& x) { x = in_format(x, format); };
  each_number(made, round);
  round(made.ray.t_min), round(made.ray.t_max);
  return made;
}

Case asked(const Case& question, const Convention& convention, const Format& format) {
  Case made = rounded(question, format);
  // What posing makes of floats need not be floats.
  if (convention.segment && is_of_points(question.ray, convention, drawn_in(format)))
    made.ray = question.ray;
  if (convention.opening != Convention::Opening::radius)
    if (const double* radius = cone_radius(question.shape)) *cone_radius(made.shape) = *radius;
  made.extent = extent_of(made.shape, convention.extent);
  return posed(made, convention, format);
}

}  // namespace rayaudit
