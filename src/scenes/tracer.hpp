#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "scenes/effect.hpp"
#include "scenes/offset.hpp"
#include "scenes/scene.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// A ray of a picture. Its numbers are those of the subject's format.
struct SceneRay {
  static constexpr std::int32_t nothing = -1;

  Ray<double> ray = {};
  std::uint32_t pixel = 0;       ///< row x width + column, from the left upper corner
  std::int32_t from = nothing;   ///< the primitive that it leaves
  std::int32_t light = nothing;  ///< of a shadow ray: the primitive that it goes to, never asked
  Departure departure = {};      ///< what it leaves, where it leaves something
  Colour weight = {1, 1, 1};     ///< of what it sees in its pixel
};

/// Rays of one effect and bounce that are followed at once, what was asked of them and what was
/// said.
struct Wave {
  /// A ray and a primitive that were asked; both are places in their lists.
  struct Pair {
    std::uint32_t ray, primitive;
  };

  Effect effect = Effect::primary;
  int bounce = 0;  ///< of primary rays 0; a shadow ray has that of the point that it leaves
  std::vector<SceneRay> rays = {};
  /// By shape; pairs, cases and answers go together.
  std::array<std::vector<Pair>, shape_count> pairs = {};
  std::array<std::vector<Case>, shape_count> cases = {};
  std::array<std::vector<Answer>, shape_count> answers = {};
  double nanoseconds = 0;  ///< from the rays to the next ones
};
/// Is told each wave when it was answered; from any thread, one call a thread at a time.
using Observe = std::function<void(const Wave&)>;

/// What to trace, and how.
struct Tracing {
  const Scene& scene;  ///< its shapes are numbers of the subject's format: see rounded()
  const Subject& subject;
  Effects effects = {};
  Offset offset = {};
  std::uint64_t seed = 1;
};

/// Traces a scene with a subject that decides every intersection: camera, shading and the points
/// between are worked out in the subject's format (in double, where it is neither float nor
/// double). Answers that say only yes, or come in place of one, count as misses, and so do those
/// outside the ray's range. What is matte is seen by the lights; where no shadow rays are on, as if
/// by a light at the eye.
///
/// The inner side of a dielectric is that of the centre of a sphere and of the axis of a cylinder
/// or cone, and of a disk that which its normal points away from.
class Tracer {
 public:
  explicit Tracer(const Tracing& tracing);
  ~Tracer();

  /// The pixels of rows from first to last - 1, from left to right: linear, not clipped. The same
  /// whoever traces the others. From any thread.
  void rows(int first, int last, std::span<Colour> pixels, const Observe& observe = {}) const;

  /// The shapes that a ray is not asked for cannot meet it: their boxes do not.
  std::vector<std::uint32_t> candidates(const Ray<double>& ray) const;

 private:
  struct Prepared;
  std::unique_ptr<const Prepared> prepared_;
};

/// The truth as a subject: every intersection is decided exactly, touches within the range are
/// hits, and t is rounded once, to nearest in the format (float or double); its proved bound is
/// that of this rounding.
const Subject& exact_subject(const Format& format);

}  // namespace rayaudit
