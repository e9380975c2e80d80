#include "reports/picture_files.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace rayaudit {
namespace {

using Pixel = PngFile::Pixel;

constexpr int brightest = 255;

/// A channel as a byte; NaN is black.
std::uint8_t shown_channel(double linear) {
  if (!(linear > 0)) return 0;
  if (linear >= 1) return brightest;
  const double curved =
      linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(brightest * curved));
}

/// How bright a pixel looks, from 0 to 255.
int brightness(const Pixel& pixel) { return (2 * pixel.red + 5 * pixel.green + pixel.blue) / 8; }

/// What of a picture is right recedes to this and above.
constexpr int darkest_right = 190;

// Colours that are told apart by those too who are blind to red or green (Okabe and Ito, "Color
// Universal Design", 2008); what does not harm is paler than all
// that does, and nothing is black, as rows are that were not traced.
constexpr std::array<LegendEntry, verdict_count> colours = {{
    {Verdict::right, {222, 222, 222}},
    {Verdict::touch, {174, 214, 241}},
    {Verdict::false_hit, {213, 94, 0}},
    {Verdict::false_miss, {0, 114, 178}},
    {Verdict::wrong_root, {0, 158, 115}},
    {Verdict::wrong_t, {230, 159, 0}},
    {Verdict::not_finite, {204, 70, 150}},
    {Verdict::crashed, {110, 0, 30}},
    {Verdict::timed_out, {70, 70, 70}},
    {Verdict::invalid_handled, {240, 232, 170}},
    {Verdict::invalid_mishandled, {90, 0, 140}},
}};

static_assert(
    [] {
      for (std::size_t i = 0; i < verdict_count; ++i)
        if (colours[i].verdict != static_cast<Verdict>(i)) return false;
      return true;
    }(),
    "the verdicts in their order");

/// The pixels from 0 on, each as it is shown.
template <class Show>
std::vector<Pixel> pixels(std::size_t count, const Show& show) {
  std::vector<Pixel> all(count);
  for (std::size_t i = 0; i < count; ++i) all[i] = show(i);
  return all;
}

}  // namespace

Pixel shown(const Colour& colour) {
  return {shown_channel(colour.x), shown_channel(colour.y), shown_channel(colour.z)};
}

Pixel shown_difference(const Colour& a, const Colour& b) {
  const Pixel first = shown(a), second = shown(b);
  const int most = std::max({std::abs(first.red - second.red), std::abs(first.green - second.green),
                             std::abs(first.blue - second.blue)});
  constexpr int least_bright = 64;
  const int bright =
      most == 0 ? 0 : least_bright + (brightest - least_bright) * (most - 1) / (brightest - 1);
  const auto grey = static_cast<std::uint8_t>(bright);
  return {grey, grey, grey};
}

Pixel shown(const Sight& sight, const Colour& colour) {
  if (sight.met_again && !is_wrong(sight.worst)) return met_again_colour;
  if (sight.worst != Verdict::right) return colours[static_cast<std::size_t>(sight.worst)].colour;
  const int pale =
      darkest_right + (brightest - darkest_right) * brightness(shown(colour)) / brightest;
  const auto grey = static_cast<std::uint8_t>(pale);
  return {grey, grey, grey};
}

std::span<const LegendEntry> legend() { return colours; }

PictureFiles::PictureFiles(const std::filesystem::path& folder, const std::string& name,
                           const PicturePlan& plan)
    : paths_(4) {
  const auto add = [&](std::size_t i, const char* end) {
    paths_[i] = folder / (name + end);
    files_.emplace_back(paths_[i], plan.scene.film.width, plan.scene.film.height);
  };
  files_.reserve(paths_.size());
  add(0, ".png");
  if (plan.exact) add(1, "-exact.png"), add(2, "-difference.png");
  if (plan.audited) add(3, "-verdicts.png");
}

void PictureFiles::write(const Band& band) {
  const std::vector<Colour>&picture = band.pixels, &exact = band.exact;
  std::size_t next = 0;
  const auto add = [&](const auto& show) { files_[next++].write(pixels(picture.size(), show)); };
  add([&](std::size_t i) { return shown(picture[i]); });
  if (!paths_[1].empty()) {
    add([&](std::size_t i) { return shown(exact[i]); });
    add([&](std::size_t i) { return shown_difference(picture[i], exact[i]); });
  }
  if (!paths_[3].empty()) add([&](std::size_t i) { return shown(band.sights[i], picture[i]); });
}

void PictureFiles::close() {
  for (PngFile& file : files_) file.close();
}

}  // namespace rayaudit
