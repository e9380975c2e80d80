#include "scenes/tracer.hpp"

#include <algorithm>
#include <chrono>

#include "geometry/error.hpp"
#include "scenes/asking.hpp"
#include "scenes/bend.hpp"
#include "scenes/camera_ray.hpp"
#include "scenes/light_falls.hpp"
#include "scenes/lots.hpp"

namespace rayaudit {
namespace {

using Clock = std::chrono::steady_clock;

/// So many primary rays are followed at once: their waves stay in a processor's cache.
constexpr std::size_t most_at_once = 2048;

Colour operator*(const Colour& a, const Colour& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
[[maybe_unused]] bool is_above(const Colour& colour, double least) {
  return colour.x > least || colour.y > least || colour.z > least;
}

std::vector<Shape> shapes_of(const Scene& scene) {
  std::vector<Shape> shapes;
  shapes.reserve(scene.primitives.size());
  for (const Primitive& primitive : scene.primitives) shapes.push_back(primitive.shape);
  return shapes;
}

/// Rays to follow, and beside each the path that its lots are drawn by.
struct Queue {
  Wave wave;
  std::vector<std::uint64_t> paths;

  void begin(Effect effect, int bounce) {
    wave.effect = effect, wave.bounce = bounce;
    wave.rays.clear(), paths.clear();
  }
};
struct NoQueue {};

/// Where a ray first meets something.
template <class N>
struct Met {
  const Primitive& primitive;
  const SceneRay& by;
  std::uint64_t path;
  int bounce;
  Vec3<N> outward;
  Departure departure;
};

}  // namespace

struct Tracer::Prepared {
  Tracing tracing;
  BoundingTree tree;
  /// The loop that has just the effects: see Follower.
  void (*trace)(const Prepared&, std::uint32_t first, std::span<Colour>, const Observe&) = nullptr;

  template <class N, bool Shadow, bool Reflection, bool Refraction>
  class Follower;
  template <class N, bool Shadow, bool Reflection, bool Refraction>
  static void trace_with(const Prepared& prepared, std::uint32_t first, std::span<Colour> pixels,
                         const Observe& observe) {
    Follower<N, Shadow, Reflection, Refraction>(prepared, first, pixels, observe).trace();
  }
  template <class N>
  void choose();
};

/// Follows the rays of some pixels, wave by wave: those of a bounce, then the shadow rays of where
/// they end, then the next bounce. Of an effect that is off there is nothing here.
template <class N, bool Shadow, bool Reflection, bool Refraction>
class Tracer::Prepared::Follower {
 public:
  Follower(const Prepared& prepared, std::uint32_t first, std::span<Colour> pixels,
           const Observe& observe)
      : tracing_(prepared.tracing),
        tree_(prepared.tree),
        first_(first),
        pixels_(pixels),
        observe_(observe),
        least_weight_(0x1p-10 / tracing_.scene.samples) {}

  /// Whole pixels at once, as far as they fit; else samples of one. So the order in which a pixel's
  /// colours are added is the same whatever other pixels there are.
  void trace() {
    std::fill(pixels_.begin(), pixels_.end(), Colour{0, 0, 0});
    const auto samples = static_cast<std::size_t>(tracing_.scene.samples);
    const std::size_t width = std::max(most_at_once / samples, std::size_t{1});
    const std::size_t depth = std::min(most_at_once, samples);
    for (std::size_t pixel = 0; pixel < pixels_.size(); pixel += width)
      for (std::size_t sample = 0; sample < samples; sample += depth)
        trace(pixel, std::min(pixel + width, pixels_.size()), sample,
              std::min(sample + depth, samples));
  }

 private:
  static constexpr bool bounces = Reflection || Refraction;
  template <bool Is>
  using QueueIf = std::conditional_t<Is, Queue, NoQueue>;

  void trace(std::size_t pixel, std::size_t end, std::size_t sample, std::size_t samples_end) {
    now_[0].begin(Effect::primary, 0);
    for (; pixel < end; ++pixel)
      for (std::size_t i = sample; i < samples_end; ++i)
        begin_path(first_ + static_cast<std::uint32_t>(pixel), i);
    if constexpr (!bounces) {
      follow(now_[0]);
    } else {
      now_[1].begin(Effect::refraction, 0);
      while (!now_[0].wave.rays.empty() || !now_[1].wave.rays.empty()) follow_bounce();
    }
  }

  void begin_path(std::uint32_t pixel, std::size_t sample) {
    const Scene& scene = tracing_.scene;
    const auto width = static_cast<std::uint32_t>(scene.film.width);
    std::array<double, 2> place = {0.5, 0.5};
    if (scene.samples > 1)
      place = lots(tracing_.seed, {LotKey::Purpose::place_in_pixel, pixel, sample});
    const std::uint32_t row = pixel / width;
    place[0] += pixel % width, place[1] += row;
    const double share = 1.0 / scene.samples;
    now_[0].wave.rays.push_back({.ray = in<double>(camera_ray<N>(scene.camera, scene.film, place)),
                                 .pixel = pixel,
                                 .weight = {share, share, share}});
    now_[0].paths.push_back(sample);
  }

  /// Follows what is reflected and refracted at once, then turns to what comes of both.
  void follow_bounce() {
    const int next = now_[0].wave.bounce + 1;
    next_[0].begin(Effect::reflection, next);
    next_[1].begin(Effect::refraction, next);
    for (Queue& queue : now_)
      if (!queue.wave.rays.empty()) follow(queue);
    std::swap(now_, next_);
  }

  void follow(Queue& queue) {
    const Clock::time_point begun = Clock::now();
    answer(queue.wave);
    find_first(queue.wave, first_met_);
    const Clock::duration aside = prove(queue.wave);
    if constexpr (Shadow) shadows_.begin(Effect::shadow, queue.wave.bounce);
    for (std::size_t i = 0; i < first_met_.size(); ++i)
      if (first_met_[i].primitive != SceneRay::nothing) shade(queue, i);
    tell(queue.wave, Clock::now() - begun - aside);
    if constexpr (Shadow)
      if (!shadows_.wave.rays.empty()) follow_shadows();
  }

  void answer(Wave& wave) {
    gather(tracing_.scene, tree_, wave);
    ask(tracing_.subject, wave);
  }

  void tell(Wave& wave, Clock::duration took) {
    wave.nanoseconds = std::chrono::duration<double, std::nano>(took).count();
    if (observe_) observe_(wave);
  }

  /// The time that it took to prove what only the observer needs.
  Clock::duration prove(const Wave& wave) {
    if constexpr (Shadow || bounces) {
      const bool is_needed = tracing_.offset.kind == Offset::Kind::proved;
      if (!is_needed && !observe_) return {};
      const Clock::time_point begun = Clock::now();
      proofs_.prove(tracing_.scene, tracing_.subject, wave, first_met_);
      if (!is_needed) return Clock::now() - begun;
    }
    return {};
  }

  void add(std::uint32_t pixel, const Colour& colour) {
    Colour& sum = pixels_[pixel - first_];
    sum = sum + colour;
  }

  /// Adds what a surface sends back, and queues the rays that tell the rest of it.
  void shade(const Queue& queue, std::size_t place) {
    const SceneRay& by = queue.wave.rays[place];
    const auto index = static_cast<std::size_t>(first_met_[place].primitive);
    const Primitive& primitive = tracing_.scene.primitives[index];
    const Vec3<N> d = in<N>(by.ray.direction);
    const Vec3<N> point = in<N>(by.ray.origin) + first_met_[place].t * d;
    const Vec3<N> outward = outward_normal(primitive.shape, point);
    if (!is_finite(point) || !is_finite(outward)) return;
    if (primitive.emitted && dot(outward, d) < N(0)) add(by.pixel, by.weight * *primitive.emitted);

    Departure departure = {in<double>(point), in<double>(outward),
                           std::numeric_limits<double>::quiet_NaN()};
    if (!proofs_.bounds().empty()) departure.proved = proofs_.bounds()[place];
    const Met<N> met = {primitive, by, queue.paths[place], queue.wave.bounce, outward, departure};
    if (primitive.material.finish == Finish::matte)
      shade_matte(met, d);
    else if constexpr (bounces)
      shade_shining(met, d);
  }

  void shade_matte(const Met<N>& met, const Vec3<N>& d) {
    if constexpr (Shadow) {
      queue_shadows(met, dot(met.outward, d) < N(0) ? met.outward : -met.outward);
    } else if (!met.primitive.emitted) {
      const double faced = std::fabs(static_cast<double>(dot(met.outward, d)));
      add(met.by.pixel, faced * (met.by.weight * met.primitive.material.reflected));
    }
  }

  void shade_shining(const Met<N>& met, const Vec3<N>& d) requires(bounces) {
    if (met.bounce >= tracing_.scene.bounces) return;
    const Material& material = met.primitive.material;
    if (material.finish == Finish::mirror) {
      if constexpr (Reflection) queue_reflection(met, d, 1);
      return;
    }
    const Bend<N> bent = bend(unit(d), met.outward, static_cast<N>(material.index));
    if constexpr (Reflection) queue_reflection(met, d, bent.reflected_share);
    if constexpr (Refraction)
      if (!bent.is_total) queue_refraction(met, bent);
  }

  [[gnu::noinline]] void queue_reflection(const Met<N>& met, const Vec3<N>& d,
                                          double share) requires(Reflection) {
    queue_bounce(next_[0], met, mirrored(d, met.outward),
                 share * (met.by.weight * met.primitive.material.reflected));
  }

  [[gnu::noinline]] void queue_refraction(const Met<N>& met,
                                          const Bend<N>& bent) requires(Refraction) {
    queue_bounce(next_[1], met, bent.refracted,
                 (1 - bent.reflected_share) * (met.by.weight * met.primitive.material.refracted));
  }

  void queue_bounce(Queue& queue, const Met<N>& met, const Vec3<N>& direction,
                    const Colour& weight) requires(bounces) {
    if (!is_above(weight, least_weight_)) return;
    const std::uint64_t branch = queue.wave.effect == Effect::refraction ? 1 : 0;
    queue_ray(queue, met, direction, weight, 2 * met.path + branch);
  }

  /// The new ray, or null where rounding left none.
  SceneRay* queue_ray(Queue& queue, const Met<N>& met, const Vec3<N>& direction,
                      const Colour& weight, std::uint64_t path) {
    const Ray<double> ray =
        departing(met.departure, in<double>(direction), tracing_.offset, format_of<N>);
    if (!is_finite(ray.origin) || !is_finite(ray.direction)) return nullptr;
    const Primitive* const first = tracing_.scene.primitives.data();
    queue.wave.rays.push_back({.ray = ray,
                               .pixel = met.by.pixel,
                               .from = static_cast<std::int32_t>(&met.primitive - first),
                               .departure = met.departure,
                               .weight = weight});
    queue.paths.push_back(path);
    return &queue.wave.rays.back();
  }

  /// One ray to each light that falls on the side of the surface that is seen.
  [[gnu::noinline]] void queue_shadows(const Met<N>& met, const Vec3<N>& facing) requires(Shadow) {
    const Scene& scene = tracing_.scene;
    const Colour sent = (1 / pi) * (met.by.weight * met.primitive.material.reflected);
    const Vec3<N> point = in<N>(met.departure.point);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
      const Light& light = scene.lights[i];
      const bool is_sphere = light.kind == Light::Kind::sphere;
      if (is_sphere && &scene.primitives[light.primitive] == &met.primitive) continue;
      std::array<double, 2> lot = {};
      if (is_sphere)
        lot = lots(tracing_.seed, {LotKey::Purpose::point_of_light, met.by.pixel, met.path,
                                   static_cast<std::uint64_t>(met.bounce), i});
      const Falling<N> fall = falling(light, scene, point, lot);
      const N faced = dot(facing, fall.direction);
      if (!(fall.distance > N(0)) || !(faced > N(0))) continue;
      const Colour brought = static_cast<double>(faced) * (sent * fall.colour);
      if (!is_above(brought, 0)) continue;
      SceneRay* const ray = queue_ray(shadows_, met, fall.direction, brought, met.path);
      if (!ray) continue;
      ray->ray.t_max = static_cast<double>(fall.distance);
      if (is_sphere) ray->light = static_cast<std::int32_t>(light.primitive);
    }
  }

  /// Adds the light of those that meet nothing.
  [[gnu::noinline]] void follow_shadows() requires(Shadow) {
    const Clock::time_point begun = Clock::now();
    Wave& wave = shadows_.wave;
    answer(wave);
    find_first(wave, first_met_);
    for (std::size_t i = 0; i < first_met_.size(); ++i)
      if (first_met_[i].primitive == SceneRay::nothing)
        add(wave.rays[i].pixel, wave.rays[i].weight);
    tell(wave, Clock::now() - begun);
  }

  const Tracing& tracing_;
  const BoundingTree& tree_;
  std::uint32_t first_;
  std::span<Colour> pixels_;
  const Observe& observe_;
  double least_weight_;  ///< below which no branch goes on

  /// Primary or reflected rays, and refracted ones.
  std::array<Queue, bounces ? 2 : 1> now_ = {};
  std::conditional_t<bounces, std::array<Queue, 2>, NoQueue> next_ = {};
  [[no_unique_address]] QueueIf<Shadow> shadows_ = {};
  std::vector<FirstMeeting<N>> first_met_ = {};
  PointProofs proofs_ = {};
};

template <class N>
void Tracer::Prepared::choose() {
  const auto& [shadow, reflection, refraction] = tracing.effects;
#ifdef RAYAUDIT_NO_EFFECTS  // what a renderer is that was never built with any
  trace = trace_with<N, false, false, false>;
  static_cast<void>(shadow), static_cast<void>(reflection), static_cast<void>(refraction);
#else
  constexpr std::array loops = {
      trace_with<N, false, false, false>, trace_with<N, false, false, true>,
      trace_with<N, false, true, false>,  trace_with<N, false, true, true>,
      trace_with<N, true, false, false>,  trace_with<N, true, false, true>,
      trace_with<N, true, true, false>,   trace_with<N, true, true, true>};
  trace = loops[std::size_t{shadow} * 4 + std::size_t{reflection} * 2 + std::size_t{refraction}];
#endif
}

Tracer::Tracer(const Tracing& tracing) {
  for (const Primitive& primitive : tracing.scene.primitives)
    if (!tracing.subject.answers(primitive.shape.index()))
      throw Error("the scene has a " + std::string(name(primitive.shape)) + ", which " +
                  tracing.subject.name + " does not answer");
  auto prepared =
      std::make_unique<Prepared>(Prepared{tracing, BoundingTree(shapes_of(tracing.scene))});
  if (tracing.subject.format == float_format)
    prepared->choose<float>();
  else
    prepared->choose<double>();
  prepared_ = std::move(prepared);
}

Tracer::~Tracer() = default;

void Tracer::rows(int first, int last, std::span<Colour> pixels, const Observe& observe) const {
  const auto width = static_cast<std::size_t>(prepared_->tracing.scene.film.width);
  const std::size_t begin = width * static_cast<std::size_t>(first);
  const std::size_t count = width * static_cast<std::size_t>(last - first);
  prepared_->trace(*prepared_, static_cast<std::uint32_t>(begin), pixels.first(count), observe);
}

std::vector<std::uint32_t> Tracer::candidates(const Ray<double>& ray) const {
  std::vector<std::uint32_t> found;
  prepared_->tree.each_candidate(ray, [&](std::uint32_t i) { found.push_back(i); });
  return found;
}

}  // namespace rayaudit
