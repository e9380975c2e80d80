#include "scenes/tracer.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <limits>
#include <mutex>
#include <numbers>
#include <set>
#include <string>

#include "audit/on_threads.hpp"
#include "by_hand.hpp"
#include "geometry/error.hpp"
#include "scenes/bend.hpp"

using namespace rayaudit;
using namespace rayaudit::by_hand;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const Offset aside = read_offset("t_min=1e-3");

Tracing tracing(const Scene& scene, const Subject& by = sound(double_format)) {
  return {scene, by, effects(scene), aside};
}

/// The picture of what is not black, row by row.
std::vector<std::string> seen(const Scene& scene) {
  const std::vector<Colour> pixels = picture(tracing(scene));
  std::vector<std::string> rows;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % static_cast<std::size_t>(scene.film.width) == 0) rows.emplace_back();
    rows.back() += pixels[i] == Colour{0, 0, 0} ? '.' : '#';
  }
  return rows;
}

bool is_near(const Colour& a, const Colour& b, double off = 1e-12) {
  return std::fabs(a.x - b.x) <= off && std::fabs(a.y - b.y) <= off && std::fabs(a.z - b.z) <= off;
}

std::vector<Wave> waves(const Tracing& traced) {
  std::vector<Wave> all;
  picture(traced, [&](const Wave& wave) { all.push_back(wave); });
  return all;
}

/// One ray along z through (0, 0) to what stands at z = 0.
Scene one_pixel(std::vector<Primitive> primitives) {
  return seen_straight(1, 1, std::move(primitives));
}

using Rows = std::vector<std::string>;

}  // namespace

BOOST_AUTO_TEST_CASE(the_silhouette_of_a_sphere_is_a_disk_of_pixels) {
  const Rows rows = {"......", "..##..", ".####.", ".####.", "..##..", "......"};
  BOOST_TEST((seen(seen_straight(6, 6, {matte(Sphere<double>{{0, 0, 0}, 2})})) == rows));
}

BOOST_AUTO_TEST_CASE(x_grows_to_the_right_and_y_upward) {
  const auto dot_at = [](double x, double y) { return matte(Sphere<double>{{x, y, 0}, 0.25}); };
  const Rows rows = {"..#", ".#.", "..."};
  BOOST_TEST((seen(seen_straight(3, 3, {dot_at(1, 1), dot_at(0, 0)})) == rows));
}

BOOST_AUTO_TEST_CASE(a_perspective_camera_sees_its_window_at_distance_1) {
  Scene scene = {.name = "window", .film = {4, 2}};
  scene.camera.half_width = 2, scene.camera.half_height = 1;
  scene.primitives = {matte(Sphere<double>{{15, 5, 10}, 0.5})};
  BOOST_TEST((seen(scene) == Rows{"...#", "...."}));
}

BOOST_AUTO_TEST_CASE(without_lights_matte_is_seen_as_from_the_eye) {
  const std::vector<Colour> pixels = picture(
      tracing(one_pixel({matte(Disk<double>{{0, 0, 0}, {0, 0.6, 0.8}, 1}, {1, 0.5, 0.25})})));
  BOOST_TEST(is_near(pixels[0], {0.8, 0.4, 0.2}));
}

BOOST_AUTO_TEST_CASE(the_nearest_shape_is_seen_and_of_equals_the_first) {
  const auto at = [](double z, const Colour& colour) {
    return matte(Disk<double>{{0, 0, z}, {0, 0, 1}, 1}, colour);
  };
  const Scene scene = one_pixel({at(2, {1, 0, 0}), at(1, {0, 1, 0}), at(1, {0, 0, 1})});
  BOOST_TEST(is_near(picture(tracing(scene))[0], {0, 1, 0}));
}

BOOST_AUTO_TEST_CASE(a_point_light_falls_as_the_cosine_and_the_square_of_its_distance) {
  Scene scene = one_pixel({matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 9}, {1, 0.5, 0.25})});
  scene.lights = {point_light({3, 0, -4}, {100, 100, 100})};
  const double brought = 100.0 / 25 * 0.8 / std::numbers::pi;
  BOOST_TEST(is_near(picture(tracing(scene))[0], brought * Colour{1, 0.5, 0.25}));
  scene.lights[0].where.z = 4;  // behind
  BOOST_TEST(is_near(picture(tracing(scene))[0], {0, 0, 0}, 0));
}

BOOST_AUTO_TEST_CASE(a_distant_light_is_as_bright_everywhere) {
  Scene scene = one_pixel({matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 9})});
  scene.lights = {{Light::Kind::distant, {0.6, 0, -0.8}, {1, 2, 3}}};
  BOOST_TEST(is_near(picture(tracing(scene))[0], 0.8 / std::numbers::pi * Colour{1, 2, 3}));
}

BOOST_AUTO_TEST_CASE(a_sphere_light_brings_what_its_solid_angle_does) {
  // Straight above, so small that every point of it is: its solid angle is pi (r / distance)^2.
  Scene scene = one_pixel({matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 9}),
                           glowing({{30, 0, -40}, 0x1p-10}, {1e6, 2e6, 3e6})});
  scene.lights = {{Light::Kind::sphere, {}, {1e6, 2e6, 3e6}, 1}};
  const double brought = 0.8 * std::pow(0x1p-10 / 50, 2);
  BOOST_TEST(is_near(picture(tracing(scene))[0], brought * Colour{1e6, 2e6, 3e6}, 1e-7));
  for (const Wave& wave : waves(tracing(scene)))
    if (wave.effect == Effect::shadow) {
      BOOST_TEST(wave.rays[0].light == 1);
      BOOST_TEST(std::fabs(wave.rays[0].ray.t_max - 50) <= 0x1p-10);
      BOOST_TEST(wave.pairs[1].empty(), "the light is not asked");
    }
}

BOOST_AUTO_TEST_CASE(a_shadow_lies_where_it_must) {
  // A light far to the left and before, a ball between: its shadow is to the right on the wall.
  Scene scene = seen_straight(
      9, 3,
      {matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 99}), mirror(Sphere<double>{{0, 0, -3}, 0.4})});
  scene.lights = {{Light::Kind::distant, {-std::sqrt(0.5), 0, -std::sqrt(0.5)}, {1, 1, 1}}};
  scene.bounces = 0;
  BOOST_TEST((seen(scene) == Rows{"#########", "####.##.#", "#########"}));
}

BOOST_AUTO_TEST_CASE(what_is_behind_a_light_casts_no_shadow) {
  Scene scene = one_pixel(
      {matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 9}), matte(Sphere<double>{{6, 0, -8}, 1})});
  scene.lights = {point_light({3, 0, -4}, {100, 100, 100})};
  BOOST_TEST(picture(tracing(scene))[0].x > 1);
  scene.lights[0].where = {9, 0, -12};
  BOOST_TEST(picture(tracing(scene))[0].x == 0);
}

BOOST_AUTO_TEST_CASE(a_mirror_shows_what_lies_in_it) {
  // At 45 degrees, seen from -z: it shows what is above.
  Scene scene =
      one_pixel({mirror(Disk<double>{{0, 0, 0}, {0, 1, -1}, 2}), glowing({{0, 5, 0}, 1}, {1, 2, 3}),
                 glowing({{0, -5, 0}, 1}, {9, 9, 9})});
  scene.primitives[0].material.reflected = {1, 0.5, 0.25};
  BOOST_TEST(is_near(picture(tracing(scene))[0], {1, 1, 0.75}));
  scene.bounces = 0;
  BOOST_TEST(is_near(picture(tracing(scene))[0], {0, 0, 0}, 0));
}

BOOST_AUTO_TEST_CASE(two_mirrors_reflect_as_often_as_the_scene_allows) {
  Scene scene = one_pixel({mirror(Disk<double>{{0, 0, 1}, {0, 0, 1}, 2}),
                           mirror(Disk<double>{{0, 0, -11}, {0, 0, 1}, 2})});
  scene.bounces = 7;
  const std::vector<Wave> all = waves(tracing(scene));
  BOOST_REQUIRE(all.size() == 8U);
  for (int i = 0; i < 8; ++i) {
    const Wave& wave = all[static_cast<std::size_t>(i)];
    BOOST_TEST(wave.bounce == i);
    BOOST_TEST((wave.effect == (i == 0 ? Effect::primary : Effect::reflection)));
    BOOST_TEST(wave.rays[0].from == (i == 0 ? SceneRay::nothing : (i + 1) % 2));
    BOOST_TEST(wave.nanoseconds > 0);
  }
  for (Primitive& primitive : scene.primitives) primitive.material.reflected = {0.25, 0.25, 0.25};
  scene.bounces = 99;  // 4^-5 is 1/1024
  BOOST_TEST(waves(tracing(scene)).size() == 5U);
}

BOOST_AUTO_TEST_CASE(glass_bends_as_snell_has_it) {
  const double angle = std::asin(0.75);
  const Vec3<double> down = {std::sin(angle), -std::cos(angle), 0};
  const Bend<double> in = bend<double>(down, {0, 1, 0}, 1.5);
  BOOST_TEST(is_near(in.refracted, {0.5, -std::sqrt(0.75), 0}, 1e-15));
  const Bend<double> out = bend<double>(-in.refracted, {0, 1, 0}, 1.5);
  BOOST_TEST(is_near(out.refracted, -down, 1e-15));
  BOOST_TEST(std::fabs(in.reflected_share - out.reflected_share) < 1e-15);
  BOOST_TEST((bend<double>({std::sqrt(0.75), 0.5, 0}, {0, 1, 0}, 1.5).is_total));
}

BOOST_AUTO_TEST_CASE(fresnel_reflects_what_it_must) {
  for (const double index : {1.5, 2.0, 0.75}) {
    const double straight = std::pow((index - 1) / (index + 1), 2);
    BOOST_TEST(std::fabs(bend<double>({0, -1, 0}, {0, 1, 0}, index).reflected_share - straight) <
               1e-15);
    BOOST_TEST(std::fabs(bend<double>({0, 1, 0}, {0, 1, 0}, index).reflected_share - straight) <
               1e-15);
  }
  // At Brewster's angle, tan = index, only half of the light is reflected: ((n^2-1)/(n^2+1))^2.
  const double n = 1.5, size = std::sqrt(1 + n * n);
  BOOST_TEST(std::fabs(bend<double>({n / size, -1 / size, 0}, {0, 1, 0}, n).reflected_share -
                       std::pow((n * n - 1) / (n * n + 1), 2) / 2) < 1e-15);
  BOOST_TEST(bend<double>({1, -1e-9, 0}, {0, 1, 0}, n).reflected_share > 0.99999);
}

BOOST_AUTO_TEST_CASE(a_pane_of_glass_shows_what_is_before_and_behind_it) {
  // Of a disk the inner side is that from which its normal points away.
  const Scene scene =
      one_pixel({glass(Disk<double>{{0, 0, 0}, {0, 0, -1}, 2}, 3),
                 glowing({{0, 0, 5}, 1}, {1, 0, 0}), glowing({{0, 0, -20}, 1}, {0, 1, 0})});
  BOOST_TEST(is_near(picture(tracing(scene))[0], {0.75, 0.25, 0}));
  Tracing without = tracing(scene);
  without.effects.refraction = false;
  BOOST_TEST(is_near(picture(without)[0], {0, 0.25, 0}));
  without.effects = {.refraction = true};
  BOOST_TEST(is_near(picture(without)[0], {0.75, 0, 0}));
}

BOOST_AUTO_TEST_CASE(a_glass_ball_turns_what_is_behind_it_about) {
  // Through a ball of index 1.5 and radius 1, at 1/2 beside its middle: in by asin(1/2) to
  // asin(1/3), and out again as far: the ray is turned by 2 (asin(1/2) - asin(1/3)) to the middle.
  Scene scene = one_pixel({glass(Sphere<double>{{-0.5, 0, 0}, 1})});
  const std::vector<Wave> all = waves(tracing(scene));
  const double turned = 2 * (std::asin(0.5) - std::asin(1.0 / 3));
  const Wave* out = nullptr;
  for (const Wave& wave : all)
    if (wave.effect == Effect::refraction && wave.bounce == 2) out = &wave;
  BOOST_REQUIRE(out);
  BOOST_TEST(is_near(out->rays[0].ray.direction, {-std::sin(turned), 0, std::cos(turned)}, 1e-14));
}

BOOST_AUTO_TEST_CASE(a_light_is_seen_from_without_alone) {
  const Scene outside = one_pixel({glowing({{0, 0, 0}, 1}, {1, 2, 3})});
  BOOST_TEST(is_near(picture(tracing(outside))[0], {1, 2, 3}));
  const Scene inside = one_pixel({glowing({{0, 0, 0}, 20}, {1, 2, 3})});
  BOOST_TEST(is_near(picture(tracing(inside))[0], {0, 0, 0}, 0));
}

BOOST_AUTO_TEST_CASE(normals_point_to_the_outer_side) {
  const auto is = [](const Shape& shape, const Vec3<double>& point, const Vec3<double>& normal) {
    return is_near(outward_normal(shape, point), normal, 1e-15);
  };
  BOOST_TEST(is(Sphere<double>{{1, 2, 3}, 5}, {4, 6, 3}, {0.6, 0.8, 0}));
  BOOST_TEST(is(Disk<double>{{1, 2, 3}, {0, 0, -4}, 5}, {1, 2, 3}, {0, 0, -1}));
  BOOST_TEST(is(Cylinder<double>{{1, 0, 0}, {1, 9, 0}, 5}, {4, 2, 4}, {0.6, 0, 0.8}));
  BOOST_TEST(is(Cone<double>{{0, 0, 0}, {0, 3, 0}, 4}, {2, 1.5, 0}, {0.6, 0.8, 0}));
  BOOST_TEST(is(Cone<double>{{0, 0, 0}, {0, 3, 0}, 4}, {0, 3, 0}, {0, 1, 0}));
  BOOST_TEST(is(Sphere<double>{{0, 0, 0}, 5e200}, {3e200, 4e200, 0}, {0.6, 0.8, 0}));
}

BOOST_AUTO_TEST_CASE(only_primary_rays_are_traced_where_nothing_calls_for_more) {
  Scene scene = plain(64, 48);
  scene.lights.clear();
  std::uint64_t rays = 0;
  for (const Wave& wave : waves(tracing(scene))) {
    BOOST_TEST((wave.effect == Effect::primary));
    rays += wave.rays.size();
  }
  BOOST_TEST(rays == 64U * 48U);
}

BOOST_AUTO_TEST_CASE(pairs_cases_and_answers_go_together) {
  const Scene scene = plain(32, 24);
  for (const Wave& wave : waves(tracing(scene, subject("textbook/float"))))
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      BOOST_TEST(wave.pairs[shape].size() == wave.cases[shape].size());
      BOOST_TEST(wave.answers[shape].size() == wave.cases[shape].size());
      for (std::size_t i = 0; i < wave.pairs[shape].size(); ++i) {
        const auto& [ray, primitive] = wave.pairs[shape][i];
        const Case& question = wave.cases[shape][i];
        BOOST_TEST((question == Case{wave.rays[ray].ray, scene.primitives[primitive].shape}));
        BOOST_TEST((in<double>(in<float>(question.ray)) == question.ray));
      }
    }
}

BOOST_AUTO_TEST_CASE(a_departure_tells_the_point_and_how_far_it_can_be_off) {
  const Scene scene = plain(64, 48);
  int proved = 0;
  for (const Wave& wave : waves(tracing(scene, sound(float_format)))) {
    if (wave.effect != Effect::shadow) continue;
    for (const SceneRay& ray : wave.rays) {
      if (std::isnan(ray.departure.proved)) continue;
      ++proved;
      BOOST_TEST(ray.departure.proved > 0);
      BOOST_TEST(ray.departure.proved < 1e-4);
      const Shape& left = scene.primitives[static_cast<std::size_t>(ray.from)].shape;
      if (const auto* ball = std::get_if<Sphere<double>>(&left)) {
        const Vec3<double> v = ray.departure.point - ball->centre;
        BOOST_TEST(std::fabs(length(v) - ball->radius) <= ray.departure.proved);
      }
    }
  }
  BOOST_TEST(proved > 500);
}

BOOST_AUTO_TEST_CASE(the_proved_offset_leaves_no_acne_on_a_ball) {
  Scene scene = plain(64, 48);
  scene.primitives.resize(2);
  for (const bool is_exact : {false, true}) {
    const Subject& by = is_exact ? exact_subject(float_format) : sound(float_format);
    std::uint64_t again = 0;
    picture({scene, by, effects(scene), read_offset("proved")}, [&](const Wave& wave) {
      if (wave.effect != Effect::shadow) return;
      for (std::size_t shape = 0; shape < shape_count; ++shape)
        for (std::size_t i = 0; i < wave.pairs[shape].size(); ++i)
          again += wave.answers[shape][i].form == Answer::Form::hit &&
                   wave.rays[wave.pairs[shape][i].ray].from ==
                       static_cast<std::int32_t>(wave.pairs[shape][i].primitive);
    });
    BOOST_TEST(again == 0U);
  }
}

BOOST_AUTO_TEST_CASE(bands_and_threads_change_no_byte) {
  Scene scene = plain(40, 30);
  scene.primitives.push_back(glass(Sphere<double>{{0, 0.75, -2}, 0.5}));
  scene.primitives.push_back(glowing({{-4, 4, -4}, 1}, {5, 5, 5}));
  scene.lights.push_back({Light::Kind::sphere, {}, {5, 5, 5}, 5});
  for (const int samples : {1, 3, 5000}) {
    scene.samples = samples;
    if (samples > 3) scene.film = {2, 2};
    const std::vector<Colour> whole = picture(tracing(scene));
    const Tracer tracer(tracing(scene));
    std::vector<Colour> banded(whole.size());
    const auto width = static_cast<std::size_t>(scene.film.width);
    on_threads(4, static_cast<std::size_t>(scene.film.height), [&](std::size_t row) {
      tracer.rows(static_cast<int>(row), static_cast<int>(row) + 1,
                  std::span(banded).subspan(row * width, width));
    });
    BOOST_TEST((banded == whole));
  }
}

BOOST_AUTO_TEST_CASE(another_seed_is_another_picture_only_where_lots_are_drawn) {
  Scene scene = plain(20, 15);
  Tracing other = tracing(scene);
  other.seed = 2;
  BOOST_TEST((picture(other) == picture(tracing(scene))));
  scene.samples = 2;
  BOOST_TEST((picture(other) != picture(tracing(scene))));
}

BOOST_AUTO_TEST_CASE(more_samples_are_as_bright) {
  Scene scene = seen_straight(3, 3, {matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 99})});
  scene.samples = 7;
  for (const Colour& colour : picture(tracing(scene))) BOOST_TEST(is_near(colour, {1, 1, 1}));
}

BOOST_AUTO_TEST_CASE(the_exact_picture_is_that_of_a_sound_routine_but_for_single_pixels) {
  const Scene scene = plain(64, 48);
  const std::vector<Colour> exact =
      picture({scene, exact_subject(double_format), effects(scene), aside});
  const std::vector<Colour> sound = picture(tracing(scene));
  int off = 0;
  for (std::size_t i = 0; i < exact.size(); ++i) off += !is_near(exact[i], sound[i], 1e-6);
  BOOST_TEST(off <= 3);
}

BOOST_AUTO_TEST_CASE(the_truth_as_a_subject_takes_touches_and_rounds_once) {
  const Sphere<double> ball = {{0, 0, 0}, 1};
  const auto said = [&](const Ray<double>& ray, const Format& format) {
    return answer_one(exact_subject(format), {ray, ball});
  };
  BOOST_TEST(exact_subject(float_format).name == "exact/float");
  BOOST_TEST(exact_subject(double_format).name == "exact/double");
  BOOST_TEST((said({{-3, 1, 0}, {1, 0, 0}}, float_format) == Answer::hit(real(3.0))));
  BOOST_TEST((said({{-3, 2, 0}, {1, 0, 0}}, float_format) == Answer::miss()));
  // The range is open: from its very surface a ray meets the other side.
  BOOST_TEST((said({{-1, 0, 0}, {1, 0, 0}}, float_format) == Answer::hit(real(2.0))));
  BOOST_TEST((said({{-3, 0, 0}, {1, 0, 0}, 0, 2}, float_format) == Answer::miss()));
  const Ray<double> third = {{-2, 0, 0}, {3, 0, 0}};
  BOOST_TEST((said(third, float_format) == Answer::hit(real(1.0F / 3))));
  BOOST_TEST((said(third, double_format) == Answer::hit(real(1.0 / 3))));
}

BOOST_AUTO_TEST_CASE(a_shape_that_the_subject_does_not_answer_is_told) {
  Subject lame = subject("textbook/float");
  lame.name = "lame";
  lame.answer[3] = nullptr;
  const Scene scene = plain(4, 3);
  BOOST_CHECK_EXCEPTION(Tracer({scene, lame, {}, aside}), Error, [](const Error& error) {
    return std::string(error.what()) == "the scene has a cone, which lame does not answer";
  });
}

BOOST_AUTO_TEST_CASE(answers_that_tell_no_place_or_one_beyond_the_range_are_misses) {
  const Scene scene = one_pixel({matte(Sphere<double>{{0, 0, 0}, 1})});
  Subject planted = {.name = "planted", .format = double_format, .answer = {}};
  const auto shown = [&](const Answer& answer) {
    planted.answer.fill([&](std::span<const Case>, std::span<Answer> answers) {
      std::fill(answers.begin(), answers.end(), answer);
    });
    return picture({scene, planted, {}, aside})[0] != Colour{0, 0, 0};
  };
  BOOST_TEST(shown(Answer::hit(real(9.0))));
  BOOST_TEST(shown(Answer::at({real(0.0), real(0.0), real(-1.0)})));
  for (const double t : {-9.0, 0.0, infinity, std::nan("")})
    BOOST_TEST(!shown(Answer::hit(real(t))));
  for (const Answer& none : {Answer::yes(), Answer::miss(), Answer::crashed(11), Answer::garbage(),
                             Answer::timed_out(), Answer::unasked()})
    BOOST_TEST(!shown(none));
}

BOOST_AUTO_TEST_CASE(an_answer_beyond_the_light_casts_no_shadow) {
  Scene scene = one_pixel({matte(Disk<double>{{0, 0, 0}, {0, 0, 1}, 9})});
  Subject planted = {.name = "planted", .format = double_format, .answer = {}};
  planted.answer.fill([](std::span<const Case>, std::span<Answer> answers) {
    std::fill(answers.begin(), answers.end(), Answer::hit(real(10.0)));
  });
  const auto brought = [&](double distance) {
    scene.lights = {point_light({0, 0, -distance}, {100, 100, 100})};
    return picture({scene, planted, {.shadow = true}, {}})[0].x;
  };
  BOOST_TEST(brought(9) > 0);
  BOOST_TEST(brought(11) == 0);
}

BOOST_AUTO_TEST_CASE(candidates_are_those_that_a_ray_is_asked_for) {
  const Scene scene = plain(8, 6);
  const Tracer tracer(tracing(scene));
  BOOST_TEST(tracer.candidates({{0, 50, 0}, {0, 1, 0}}).empty());
  BOOST_TEST((tracer.candidates({{-1.5, 50, 0}, {0, -1, 0}}).size() == 2U));
}

BOOST_AUTO_TEST_CASE(every_format_traces_the_picture) {
  const Scene scene = plain(32, 24);
  const std::vector<Colour> in_double = picture(tracing(scene));
  for (const Format& format : {float_format, long_double_format}) {
    const std::vector<Colour> other = picture(tracing(scene, sound(format)));
    int off = 0;
    for (std::size_t i = 0; i < other.size(); ++i) off += !is_near(other[i], in_double[i], 1e-2);
    BOOST_TEST(off <= 8, format.name);
  }
}
