#include "subjects/convention.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "geometry/error.hpp"

namespace rayaudit {
namespace {

double in_format(long double x, const Format& format) {
  return format == float_format ? static_cast<double>(static_cast<float>(x))
                                : static_cast<double>(x);
}

/// The direction as near to length 1 as the format has it, t in its units; one without a length
/// stays as it is.
void normalise(Ray<double>& ray, const Format& format) {
  const auto [x, y, z] = in<long double>(ray.direction);
  // The largest component is brought near 1 first: a square must neither overflow nor underflow.
  const long double size = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
  if (!(size > 0) || !std::isfinite(size)) return;
  const Vec3<long double> part = {x / size, y / size, z / size};
  const long double length = std::sqrt(part.x * part.x + part.y * part.y + part.z * part.z);
  const auto scaled = [&](long double component) { return in_format(component / length, format); };
  ray.direction = {scaled(part.x), scaled(part.y), scaled(part.z)};
  for (double* t : {&ray.t_min, &ray.t_max})
    if (std::isfinite(*t)) *t = in_format(*t * size * length, format);
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

}  // namespace

bool has_range(const Convention& convention) { return convention.t_min < convention.t_max; }

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
  made.line |= second.line;
  made.t_min = std::max(made.t_min, second.t_min);
  made.t_max = std::min(made.t_max, second.t_max);
  if (!has_range(made))
    throw Error("--convention leaves, with what a subject declares itself, " + empty_range(made));
  return made;
}

bool poses(const Convention& convention) {
  return convention.unit_direction || convention.line || std::isfinite(convention.t_min) ||
         std::isfinite(convention.t_max);
}

Case posed(const Case& question, const Convention& convention, const Format& format) {
  Case made = question;
  if (convention.unit_direction) normalise(made.ray, format);
  if (convention.line) {
    made.ray.t_min = -std::numeric_limits<double>::infinity();
    made.ray.t_max = std::numeric_limits<double>::infinity();
  }
  // A NaN in the range stays, for it makes the case invalid.
  if (made.ray.t_min < convention.t_min) made.ray.t_min = convention.t_min;
  if (made.ray.t_max > convention.t_max) made.ray.t_max = convention.t_max;
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
  const Case made = rounded(question, format);
  Convention left = convention;
  // Normalised again, one direction in a hundred would become another.
  if (is_unit(made.ray.direction, format)) left.unit_direction = false;
  return posed(made, left, format);
}

}  // namespace rayaudit
