#include "scenes/line_roots.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "oracle/position.hpp"

namespace rayaudit {
namespace {

bool lies_within(const oracle::Truth& truth) {
  return std::ranges::any_of(truth.crossings(), [](const oracle::Crossing& crossing) {
    return crossing.kind == oracle::Kind::within;
  });
}

}  // namespace

int LineRoots::nearest(double to) const {
  int found = none;
  for (int i = 0; i < count; ++i)
    if (found == none || std::fabs(t[i] - to) < std::fabs(t[found] - to)) found = i;
  return found;
}

LineRoots line_roots(const Case& question, const oracle::Truth& truth) {
  LineRoots found;
  if (truth.invalid != oracle::Invalid::no || lies_within(truth)) return found;
  const auto add = [&](const Real& t) { found.t[found.count++] = nearest<double>(t); };
  if (!truth.others_known) {
    const oracle::Roots roots = oracle::roots(question);
    for (const oracle::Root& root : roots.roots()) add(root.t);
    return found;
  }
  for (const oracle::Crossing& crossing : truth.crossings()) add(crossing.t);
  for (const Real& other : truth.others()) add(other);
  if (found.count == 2 && found.t[0] > found.t[1]) std::swap(found.t[0], found.t[1]);
  return found;
}

std::optional<double> claimed_t(const Case& question, const Answer& answer) {
  if (answer.form == Answer::Form::hit) return nearest<double>(answer.t);
  if (answer.form != Answer::Form::at) return {};
  const auto& [x, y, z] = answer.point;
  if (!is_finite(x) || !is_finite(y) || !is_finite(z)) return {};
  return nearest<double>(oracle::projection(question.ray, answer.point, 60));
}

double world_length(const Ray<double>& ray, double t) {
  const Vec3<double>& d = ray.direction;
  return std::fabs(t) * std::hypot(d.x, d.y, d.z);
}

std::optional<double> self_intersection(const Case& question, const oracle::Truth& truth,
                                        const Answer& answer) {
  const std::optional<double> t = claimed_t(question, answer);
  if (!t || !(*t > question.ray.t_min && *t < question.ray.t_max) ||
      truth.invalid != oracle::Invalid::no || lies_within(truth))
    return {};
  const LineRoots roots = line_roots(question, truth);
  if (roots.nearest(*t) != roots.departure()) return {};
  return world_length(question.ray, *t);
}

}  // namespace rayaudit
