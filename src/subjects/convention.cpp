#include "subjects/convention.hpp"

#include <algorithm>
#include <cmath>

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

}  // namespace

Convention joined(const Convention& first, const Convention& second) {
  Convention made = first;
  for (std::size_t i = 0; i < made.stances.size(); ++i)
    if (made.stances[i] == Convention::Stance::either) made.stances[i] = second.stances[i];
  if (made.inside == Convention::Inside::hit) made.inside = second.inside;
  made.unit_direction |= second.unit_direction;
  made.line |= second.line;
  made.t_min = std::max(made.t_min, second.t_min);
  made.t_max = std::min(made.t_max, second.t_max);
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

}  // namespace rayaudit
