#include "cli/effect_costs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/figures.hpp"
#include "scenes/tracer.hpp"

namespace rayaudit {
namespace {

/// What the rays of one effect came to.
struct Cost {
  std::uint64_t rays = 0;
  double nanoseconds = 0;
};
using Costs = std::array<Cost, effect_count>;

/// Enough rays from the camera to tell what rays cost, and few enough to tell it at once.
constexpr double most_traced = 320 * 240;

/// The film with its shape kept, and not more pixels than are traced with so many samples each.
Film small(const Film& film, int samples) {
  const double rays = static_cast<double>(film.width) * film.height * samples;
  const double scale = std::min(1.0, std::sqrt(most_traced / rays));
  const auto scaled = [&](int n) { return std::max(1, static_cast<int>(n * scale)); };
  return {scaled(film.width), scaled(film.height)};
}

Costs traced(const Scene& scene, const Renderer& renderer, Effects on, std::uint64_t seed) {
  const Tracer tracer({scene, *renderer.subject, on, renderer.offset, seed});
  Costs costs;
  const auto add = [&](const Wave& wave) {
    Cost& cost = costs[static_cast<std::size_t>(wave.effect)];
    cost.rays += wave.rays.size();
    cost.nanoseconds += wave.nanoseconds;
  };
  std::vector<Colour> row(static_cast<std::size_t>(scene.film.width));
  for (int y = 0; y < scene.film.height; ++y) tracer.rows(y, y + 1, row, add);
  return costs;
}

/// Why an effect is on or off, in the end.
std::string reason(const Calling& calling, bool is_on) {
  if (!calling.is_on) return calling.because;
  if (!is_on) return "taken away by --effects";
  if (calling.effect == Effect::primary) return calling.because;
  return told(calling.place) + ": " + calling.because;
}

std::string line(const Calling& calling, bool is_on, const Costs& costs, double pixels) {
  const Cost& cost = costs[static_cast<std::size_t>(calling.effect)];
  std::uint64_t rays = 0;
  double nanoseconds = 0;
  for (const Cost& each : costs) rays += each.rays, nanoseconds += each.nanoseconds;
  const std::string a_pixel =
      is_on ? fmt::format("{:.2f}", static_cast<double>(cost.rays) / pixels) : "-";
  const std::string time =
      is_on && nanoseconds > 0 ? fmt::format("{:.1f}", 100 * cost.nanoseconds / nanoseconds) : "-";
  return fmt::format("{:<11}{:<5}{:>12}{:>8}{:>8}  {}\n", name(calling.effect),
                     is_on ? "on" : "off", a_pixel, figures::percent(cost.rays, rays), time,
                     reason(calling, is_on));
}

}  // namespace

std::string effect_costs(const Scene& scene, const Renderer& renderer, Effects on,
                         std::uint64_t seed) {
  Scene rounded = rayaudit::rounded(scene, renderer.subject->drawn_in()).scene;
  rounded.film = small(scene.film, scene.samples);
  const Costs costs = traced(rounded, renderer, on, seed);
  const double pixels = static_cast<double>(rounded.film.width) * rounded.film.height;
  std::string text = fmt::format("{} as {} traces it, {} x {} pixels\n", scene.name,
                                 renderer.name(), rounded.film.width, rounded.film.height) +
                     fmt::format("{:<11}{:<5}{:>12}{:>8}{:>8}  {}\n", "effect", "", "rays a pixel",
                                 "rays %", "time %", "because");
  for (const Calling& calling : callings(scene))
    text += line(calling, on.has(calling.effect), costs, pixels);
  return text;
}

}  // namespace rayaudit
