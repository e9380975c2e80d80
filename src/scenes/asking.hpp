#pragma once

#include <cmath>
#include <vector>

#include "scenes/bounding_tree.hpp"
#include "scenes/tracer.hpp"

/// A wave put to a subject, and what its answers come to.
namespace rayaudit {

/// Puts together what to ask: of every ray, each shape whose box it may meet.
void gather(const Scene& scene, const BoundingTree& tree, Wave& wave);

/// Has all of it answered, a batch of one shape at a time.
void ask(const Subject& subject, Wave& wave);

/// The t of an answer; NaN where it tells none. Of a point it is its projection to the ray.
double told_t(const Answer& answer, const Ray<double>& ray);

/// Where a ray first meets something, as its answers say.
template <class N>
struct FirstMeeting {
  N t = N(0);
  std::int32_t primitive = SceneRay::nothing;
};

/// Of each ray, the nearest answer within its range; of equals that of the lower primitive.
template <class N>
void find_first(const Wave& wave, std::vector<FirstMeeting<N>>& found);

/// The proved bounds of the points where rays first meet something, each computed as
/// o + t d in N: by their places in the wave, NaN where nothing is proved.
class PointProofs {
 public:
  template <class N>
  void prove(const Scene& scene, const Subject& subject, const Wave& wave,
             const std::vector<FirstMeeting<N>>& found);
  const std::vector<double>& bounds() const { return bounds_; }

 private:
  std::vector<double> bounds_;
  std::vector<Case> cases_;
  std::vector<std::uint32_t> places_;
  std::vector<Proved> proved_;
};

}  // namespace rayaudit
