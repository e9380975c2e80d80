#include "scenes/asking.hpp"

#include <limits>

#include "scenes/surface.hpp"

namespace rayaudit {
namespace {

double size(const Vec3<double>& v) { return std::hypot(v.x, v.y, v.z); }

/// At least how far o + t d in N can be from the same without rounding: each of its two operations
/// is off by at most u of what it gives, and by half the smallest number (Higham, "Accuracy and
/// Stability of Numerical Algorithms", 2nd ed., sec. 2.2, Theorem 2.3); the factor is for the
/// doubles in which this is reckoned.
template <class N>
double rounding_of_point(const Ray<double>& ray, N t) {
  using Limits = std::numeric_limits<N>;
  constexpr double u = double{Limits::epsilon()} / 2;
  const Vec3<N> way = t * in<N>(ray.direction), point = in<N>(ray.origin) + way;
  const auto off = [](N moved, N sum) {
    return u * (std::fabs(double{moved}) + std::fabs(double{sum})) + double{Limits::denorm_min()};
  };
  return size({off(way.x, point.x), off(way.y, point.y), off(way.z, point.z)}) * (1 + 0x1p-40);
}

/// What rounding a subject's t to N takes; only a hit's own t is proved.
template <class N>
double bound_of_t(const Subject& subject, const Proved& proved, N t) {
  if (!proved.certified || proved.answer.form != Answer::Form::hit)
    return std::numeric_limits<double>::quiet_NaN();
  const bool is_rounded = subject.format.precision > std::numeric_limits<N>::digits;
  const double rounding = is_rounded ? std::fabs(double{t}) * std::numeric_limits<N>::epsilon() +
                                           std::numeric_limits<N>::denorm_min()
                                     : 0;
  return proved.bound + rounding;
}

}  // namespace

void gather(const Scene& scene, const BoundingTree& tree, Wave& wave) {
  for (auto& pairs : wave.pairs) pairs.clear();
  for (auto& cases : wave.cases) cases.clear();
  for (std::uint32_t i = 0; i < wave.rays.size(); ++i) {
    const SceneRay& asked = wave.rays[i];
    if (!(asked.ray.t_min < asked.ray.t_max)) continue;
    tree.each_candidate(asked.ray, [&](std::uint32_t primitive) {
      if (static_cast<std::int32_t>(primitive) == asked.light) return;
      const Shape& shape = scene.primitives[primitive].shape;
      wave.pairs[shape.index()].push_back({i, primitive});
      wave.cases[shape.index()].push_back({asked.ray, shape});
    });
  }
}

void ask(const Subject& subject, Wave& wave) {
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    const std::span<const Case> cases = wave.cases[shape];
    wave.answers[shape].resize(cases.size());
    const std::span<Answer> answers = wave.answers[shape];
    for (std::size_t begin = 0; begin < cases.size(); begin += batch_elsewhere) {
      const std::size_t count = std::min(batch_elsewhere, cases.size() - begin);
      subject.answer[shape](cases.subspan(begin, count), answers.subspan(begin, count));
    }
  }
}

double told_t(const Answer& answer, const Ray<double>& ray) {
  const Real& t = answer.t;
  if (answer.form == Answer::Form::hit)
    return t.middle == 0 && t.low == 0 && t.exponent == 0 ? t.high : nearest<double>(t);
  if (answer.form != Answer::Form::at) return std::numeric_limits<double>::quiet_NaN();
  const Vec3<double> point = {nearest<double>(answer.point.x), nearest<double>(answer.point.y),
                              nearest<double>(answer.point.z)};
  return dot(point - ray.origin, ray.direction) / dot(ray.direction, ray.direction);
}

template <class N>
void find_first(const Wave& wave, std::vector<FirstMeeting<N>>& found) {
  found.assign(wave.rays.size(), {});
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    const std::vector<Wave::Pair>& pairs = wave.pairs[shape];
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Ray<double>& ray = wave.rays[pairs[i].ray].ray;
      const double said = told_t(wave.answers[shape][i], ray);
      if (!(said > ray.t_min && said < ray.t_max)) continue;
      const N t = static_cast<N>(said);
      const auto primitive = static_cast<std::int32_t>(pairs[i].primitive);
      FirstMeeting<N>& first = found[pairs[i].ray];
      if (first.primitive == SceneRay::nothing || t < first.t ||
          (t == first.t && primitive < first.primitive))
        first = {t, primitive};
    }
  }
}
template void find_first(const Wave&, std::vector<FirstMeeting<float>>&);
template void find_first(const Wave&, std::vector<FirstMeeting<double>>&);

template <class N>
void PointProofs::prove(const Scene& scene, const Subject& subject, const Wave& wave,
                        const std::vector<FirstMeeting<N>>& found) {
  bounds_.assign(found.size(), std::numeric_limits<double>::quiet_NaN());
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    if (!subject.prove[shape]) continue;
    cases_.clear(), places_.clear();
    for (std::uint32_t i = 0; i < found.size(); ++i) {
      if (found[i].primitive == SceneRay::nothing) continue;
      const Shape& met = scene.primitives[static_cast<std::size_t>(found[i].primitive)].shape;
      if (met.index() != shape) continue;
      cases_.push_back({wave.rays[i].ray, met});
      places_.push_back(i);
    }
    proved_.assign(cases_.size(), {});
    if (!cases_.empty()) subject.prove[shape](cases_, proved_);
    for (std::size_t i = 0; i < places_.size(); ++i) {
      const N t = found[places_[i]].t;
      const Ray<double>& ray = cases_[i].ray;
      bounds_[places_[i]] =
          (bound_of_t(subject, proved_[i], t) * size(ray.direction) + rounding_of_point(ray, t)) *
          (1 + 0x1p-40);
    }
  }
}
template void PointProofs::prove(const Scene&, const Subject&, const Wave&,
                                 const std::vector<FirstMeeting<float>>&);
template void PointProofs::prove(const Scene&, const Subject&, const Wave&,
                                 const std::vector<FirstMeeting<double>>&);

}  // namespace rayaudit
