#include "reports/picture_files.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <set>
#include <tuple>

#include "geometry/error.hpp"
#include "tests/reports/empty_folder.hpp"
#include "tests/reports/read_png.hpp"

using namespace rayaudit;
using Pixel = PngFile::Pixel;

namespace rayaudit {
bool operator==(const Pixel& a, const Pixel& b) {
  return std::tie(a.red, a.green, a.blue) == std::tie(b.red, b.green, b.blue);
}
std::ostream& operator<<(std::ostream& out, const Pixel& a) {
  return out << int(a.red) << ' ' << int(a.green) << ' ' << int(a.blue);
}
}  // namespace rayaudit

namespace {

const EmptyFolder folder("picture_files_test");

Scene scene() {
  Scene scene = {.name = "plain"};
  scene.film = {3, 4};
  return scene;
}
const Scene small = scene();
const Subject subject = {"mine/float", float_format, {}};

/// Rows of a picture that is white, of an exact one that is grey; of which one pixel is missed.
Band band(int first, int last) {
  const std::size_t count = 3 * static_cast<std::size_t>(last - first);
  Band band = {first, last, std::vector<Colour>(count, {1, 1, 1}),
               std::vector<Colour>(count, {0.2, 0.2, 0.2}), std::vector<Sight>(count)};
  band.sights[1].worst = Verdict::false_miss;
  return band;
}

Pixel grey(int of) {
  const auto byte = static_cast<std::uint8_t>(of);
  return {byte, byte, byte};
}

/// The luminance that a pixel has on a screen, relative to white (IEC 61966-2-1).
double luminance(const Pixel& pixel) {
  const auto linear = [](std::uint8_t channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(pixel.red) + 0.7152 * linear(pixel.green) + 0.0722 * linear(pixel.blue);
}

Pixel colour_of(Verdict verdict) { return shown({verdict}, {0.5, 0.5, 0.5}); }

}  // namespace

BOOST_AUTO_TEST_CASE(what_a_screen_shows_follows_the_curve_of_srgb) {
  BOOST_TEST(shown(Colour{0, 1, 0.5}) == (Pixel{0, 255, 188}));
  BOOST_TEST(shown(Colour{0.001, 0.0031308, 0.2140411}) == (Pixel{3, 10, 127}));
}

BOOST_AUTO_TEST_CASE(what_is_beyond_black_and_white_is_clipped_and_no_number_is_black) {
  const double inf = std::numeric_limits<double>::infinity();
  BOOST_TEST(shown(Colour{-1, 7, inf}) == (Pixel{0, 255, 255}));
  BOOST_TEST(shown(Colour{-inf, std::nan(""), 1e300}) == (Pixel{0, 0, 255}));
}

BOOST_AUTO_TEST_CASE(no_difference_is_black_and_the_least_that_a_screen_shows_is_seen) {
  const Colour middle = {0.5, 0.5, 0.5};
  BOOST_TEST(shown_difference(middle, middle) == grey(0));
  BOOST_TEST(shown_difference(middle, {0.5, 0.5, 0.5000001}) == grey(0));
  BOOST_TEST(shown_difference({7, 7, 7}, {1, 2, 3}) == grey(0));
  const Pixel least = shown_difference(middle, {0.5, 0.5, 0.507});
  BOOST_TEST(shown(Colour{0.5, 0.5, 0.507}).blue == 189);
  BOOST_TEST(least.red >= 48);
  BOOST_TEST(shown_difference({0.5, 0.5, 0.507}, middle) == least);
}

BOOST_AUTO_TEST_CASE(the_larger_a_difference_the_brighter_up_to_white) {
  int last = 0;
  for (int i = 1; i <= 20; ++i) {
    const Pixel pixel = shown_difference({0, 0, 0}, {0, i / 20.0, 0});
    BOOST_TEST(pixel.red > last);
    last = pixel.red;
  }
  BOOST_TEST(last == 255);
  BOOST_TEST(shown_difference({std::nan(""), 0, 0}, {1, 0, 0}) == grey(255));
}

BOOST_AUTO_TEST_CASE(what_is_right_is_the_picture_pale_and_grey) {
  const Pixel dark = shown({Verdict::right}, {0, 0, 0}), red = shown({Verdict::right}, {1, 0, 0}),
              light = shown({Verdict::right}, {1, 1, 1});
  BOOST_TEST(dark == grey(dark.red));
  BOOST_TEST(red == grey(red.red));
  BOOST_TEST(light == grey(255));
  BOOST_TEST(dark.red < red.red);
  BOOST_TEST(dark.red >= 180);
}

BOOST_AUTO_TEST_CASE(no_two_verdicts_look_alike_and_the_picture_beneath_does_not_matter) {
  std::set<std::tuple<int, int, int>> seen;
  for (std::size_t i = 1; i < verdict_count; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    const Pixel pixel = colour_of(verdict);
    BOOST_TEST(shown({verdict}, {1, 0, 1}) == pixel);
    BOOST_TEST(seen.emplace(pixel.red, pixel.green, pixel.blue).second, name(verdict));
  }
}

BOOST_AUTO_TEST_CASE(what_is_wrong_is_stronger_than_all_that_is_not) {
  for (std::size_t i = 0; i < verdict_count; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    if (is_wrong(verdict))
      BOOST_TEST(luminance(colour_of(verdict)) < 0.45, name(verdict));
    else
      BOOST_TEST(luminance(colour_of(verdict)) > 0.6, name(verdict));
  }
}

BOOST_AUTO_TEST_CASE(a_surface_that_is_met_again_shows_where_no_answer_is_wrong) {
  for (std::size_t i = 0; i < verdict_count; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    BOOST_TEST(shown({verdict, true}, {1, 1, 1}) ==
                   (is_wrong(verdict) ? colour_of(verdict) : met_again_colour),
               name(verdict));
    BOOST_TEST(colour_of(verdict) != met_again_colour, name(verdict));
  }
}

BOOST_AUTO_TEST_CASE(the_legend_has_every_verdict_in_its_colour) {
  BOOST_TEST(legend().size() == verdict_count);
  for (const auto& [verdict, colour] : legend())
    if (verdict != Verdict::right) BOOST_TEST(colour == colour_of(verdict), name(verdict));
}

BOOST_AUTO_TEST_CASE(a_whole_plan_has_four_files_each_with_its_picture) {
  const PicturePlan plan = {.scene = small, .subject = subject};
  PictureFiles files(folder.path, "plain", plan);
  files.write(band(0, 2));
  files.write(band(2, 4));
  files.close();
  const ReadPng picture = read_png(folder.path / "plain.png"),
                exact = read_png(folder.path / "plain-exact.png"),
                difference = read_png(folder.path / "plain-difference.png"),
                verdicts = read_png(folder.path / "plain-verdicts.png");
  BOOST_TEST(picture.width == 3);
  BOOST_TEST(picture.height == 4);
  BOOST_TEST(picture.at(2, 3) == grey(255));
  BOOST_TEST(exact.at(2, 3) == grey(124));
  BOOST_TEST(difference.at(2, 3) == shown_difference({1, 1, 1}, {0.2, 0.2, 0.2}));
  BOOST_TEST(verdicts.at(1, 2) == colour_of(Verdict::false_miss));
  BOOST_TEST(verdicts.at(2, 2) == grey(255));
  BOOST_TEST(files.path(0) == folder.path / "plain.png");
  BOOST_TEST(files.path(3) == folder.path / "plain-verdicts.png");
}

BOOST_AUTO_TEST_CASE(a_plan_without_audit_or_exact_picture_has_no_files_of_them) {
  const PicturePlan plain = {.scene = small, .subject = subject, .audited = false, .exact = false};
  PictureFiles files(folder.path, "only", plain);
  files.write({.first = 0, .last = 4, .pixels = std::vector<Colour>(12, {1, 1, 1})});
  files.close();
  BOOST_TEST(read_png(folder.path / "only.png").at(0, 3) == grey(255));
  for (const auto* other : {"only-exact.png", "only-difference.png", "only-verdicts.png"})
    BOOST_TEST(!std::filesystem::exists(folder.path / other), other);
  for (std::size_t i = 1; i < 4; ++i) BOOST_TEST(files.path(i).empty());
  const PicturePlan audited = {.scene = small, .subject = subject, .exact = false};
  BOOST_TEST(PictureFiles(folder.path, "map", audited).path(3) == folder.path / "map-verdicts.png");
}

BOOST_AUTO_TEST_CASE(stopped_between_two_bands_all_are_valid_and_black_below) {
  const PicturePlan plan = {.scene = small, .subject = subject};
  {
    PictureFiles files(folder.path, "stopped", plan);
    files.write(band(0, 2));
  }
  for (const auto* name :
       {"stopped.png", "stopped-exact.png", "stopped-difference.png", "stopped-verdicts.png"}) {
    const ReadPng read = read_png(folder.path / name);
    BOOST_TEST(read.at(0, 1).red > 0, name);
    BOOST_TEST(read.at(0, 2) == grey(0), name);
  }
}

BOOST_AUTO_TEST_CASE(a_missing_folder_is_told_before_anything_is_traced) {
  const PicturePlan plan = {.scene = small, .subject = subject};
  BOOST_CHECK_THROW(PictureFiles(folder.path / "missing", "plain", plan), Error);
}
