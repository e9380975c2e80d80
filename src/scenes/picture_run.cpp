#include "scenes/picture_run.hpp"

#include <algorithm>
#include <condition_variable>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

#include "audit/on_threads.hpp"
#include "scenes/tracer.hpp"

namespace rayaudit {
namespace {

/// So many rows make a band, fewer where they would take more rays from the camera than this: who
/// stops a run does not wait long.
constexpr int most_rows = 16;
constexpr std::int64_t rays_a_band = 1 << 16;

int rows_a_band(const Scene& scene) {
  const std::int64_t rays_a_row = std::int64_t{scene.film.width} * scene.samples;
  return static_cast<int>(
      std::clamp(rays_a_band / rays_a_row, std::int64_t{1}, std::int64_t{most_rows}));
}

/// No band is begun that is so many for each thread below the first unfinished one: what waits to
/// be handed over stays few.
constexpr std::size_t most_ahead = 4;

struct Finished {
  Band band;
  SceneAccount account;
};

/// Gives out bands from the top, and passes on what is finished in the same order.
class Order {
 public:
  Order(std::size_t bands, std::size_t threads, const std::atomic<bool>* stop,
        const std::function<void(Finished&&)>& pass_on)
      : bands_(bands), window_(most_ahead * threads), stop_(stop), pass_on_(pass_on) {}

  /// The next band to begin; nothing where there is none, or none is to be begun any more.
  std::optional<std::size_t> next() {
    std::unique_lock lock(mutex_);
    passed_on_.wait(lock, [&] { return begun_ < done_ + window_ || is_over(); });
    if (is_over()) return {};
    return begun_++;
  }

  void finish(std::size_t band, Finished&& finished) {
    const std::lock_guard lock(mutex_);
    waiting_.emplace(band, std::move(finished));
    for (; !waiting_.empty() && waiting_.begin()->first == done_; ++done_)
      pass_on_(std::move(waiting_.extract(waiting_.begin()).mapped()));
    passed_on_.notify_all();
  }

  /// Nothing more is to be begun.
  void break_off() {
    const std::lock_guard lock(mutex_);
    is_broken_ = true;
    passed_on_.notify_all();
  }

  bool is_whole() const { return done_ == bands_; }

 private:
  bool is_over() const {
    return begun_ == bands_ || is_broken_ || (stop_ != nullptr && stop_->load());
  }

  const std::size_t bands_, window_;
  const std::atomic<bool>* const stop_;
  const std::function<void(Finished&&)>& pass_on_;
  std::mutex mutex_;
  std::condition_variable passed_on_;
  std::map<std::size_t, Finished> waiting_;
  std::size_t begun_ = 0, done_ = 0;
  bool is_broken_ = false;
};

const Subject& exact_for(const Subject& subject) {
  return exact_subject(subject.format == float_format ? float_format : double_format);
}

/// Traces and audits single bands.
class Bands {
 public:
  explicit Bands(const PicturePlan& plan)
      : plan_(plan),
        tracer_(tracing(plan.subject)),
        auditing_{plan.scene, plan.subject,
                  [this](const Ray<double>& ray) { return tracer_.candidates(ray); }, plan.offsets,
                  plan.thorough} {
    if (plan.exact) exact_.emplace(tracing(exact_for(plan.subject)));
  }
  Bands(const Bands&) = delete;
  Bands& operator=(const Bands&) = delete;

  std::size_t count() const {
    const int rows = rows_a_band(plan_.scene);
    return static_cast<std::size_t>((plan_.scene.film.height + rows - 1) / rows);
  }
  const SceneAuditing& auditing() const { return auditing_; }
  Finished made(std::size_t band) const;

 private:
  Tracing tracing(const Subject& subject) const {
    return {plan_.scene, subject, plan_.effects, plan_.offset, plan_.seed};
  }

  const PicturePlan& plan_;
  const Tracer tracer_;
  std::optional<const Tracer> exact_;
  const SceneAuditing auditing_;
};

Finished Bands::made(std::size_t number) const {
  const Film& film = plan_.scene.film;
  Finished finished;
  Band& band = finished.band;
  const int rows = rows_a_band(plan_.scene);
  band.first = static_cast<int>(number) * rows;
  band.last = std::min(band.first + rows, film.height);
  const auto width = static_cast<std::size_t>(film.width);
  const std::size_t pixels = width * static_cast<std::size_t>(band.last - band.first);
  const auto first_pixel = static_cast<std::uint32_t>(static_cast<std::size_t>(band.first) * width);
  band.pixels.resize(pixels);
  Observe observe;
  if (plan_.audited) {
    band.sights.resize(pixels);
    observe = [&](const Wave& wave) {
      audit_wave(auditing_, wave, finished.account, first_pixel, band.sights);
    };
  }
  tracer_.rows(band.first, band.last, band.pixels, observe);
  if (exact_) {
    band.exact.resize(pixels);
    exact_->rows(band.first, band.last, band.exact);
  }
  return finished;
}

std::size_t processors() { return std::max(std::thread::hardware_concurrency(), 1U); }

std::uint64_t pixels_of(const Film& film, int rows) {
  return static_cast<std::uint64_t>(film.width) * static_cast<std::uint64_t>(rows);
}

}  // namespace

Picture run_picture(const PicturePlan& plan, const std::function<void(const Band&)>& finished,
                    const std::function<void(Progress)>& tell, const std::atomic<bool>* stop) {
  const Bands bands(plan);
  const Film& film = plan.scene.film;
  Picture picture;
  const std::function<void(Finished &&)> pass_on = [&](Finished&& made) {
    picture.account.merge(made.account);
    if (finished) finished(made.band);
    if (tell) tell({pixels_of(film, made.band.last), pixels_of(film, film.height)});
  };
  const int threads = plan.subject.is_elsewhere ? 1 : plan.threads;
  Order order(bands.count(), threads > 0 ? static_cast<std::size_t>(threads) : processors(), stop,
              pass_on);
  on_threads(threads, bands.count(), [&](std::size_t) {
    try {
      if (const auto band = order.next()) order.finish(*band, bands.made(*band));
    } catch (...) {
      order.break_off();
      throw;
    }
  });
  picture.whole = order.is_whole();
  if (plan.audited) conclude(bands.auditing(), picture.account);
  return picture;
}

}  // namespace rayaudit
