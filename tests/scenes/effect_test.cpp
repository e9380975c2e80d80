#include "scenes/effect.hpp"

#include <boost/test/unit_test.hpp>

#include "by_hand.hpp"

using namespace rayaudit;
using namespace rayaudit::by_hand;

namespace {

const Sphere<double> ball = {{0, 0, 0}, 1};
const Disk<double> floor_disk = {{0, -1, 0}, {0, 1, 0}, 8};

Scene scene_of(std::vector<Primitive> primitives, std::vector<Light> lights = {}) {
  Scene scene = seen_straight(4, 4, std::move(primitives));
  scene.lights = std::move(lights);
  int line = 1;
  for (Light& light : scene.lights) light.place = {"made.pbrt", line++, 1};
  for (Primitive& primitive : scene.primitives) primitive.material.place = {"made.pbrt", line++, 1};
  return scene;
}

const Calling& calling(const std::array<Calling, effect_count>& all, Effect effect) {
  return all[static_cast<std::size_t>(effect)];
}

}  // namespace

BOOST_AUTO_TEST_CASE(primary_rays_are_always_there) {
  const auto all = callings(Scene{.name = "empty.pbrt"});
  BOOST_TEST(calling(all, Effect::primary).is_on);
  BOOST_TEST(calling(all, Effect::primary).place.file == "empty.pbrt");
  BOOST_TEST((effects(Scene{}) == Effects{}));
  BOOST_TEST(Effects{}.has(Effect::primary));
}

BOOST_AUTO_TEST_CASE(matte_shapes_without_a_light_call_for_nothing) {
  const Scene scene = scene_of({matte(ball)});
  BOOST_TEST((effects(scene) == Effects{}));
  BOOST_TEST(calling(callings(scene), Effect::shadow).because == "no light");
}

BOOST_AUTO_TEST_CASE(the_first_light_that_shines_on_something_matte_calls_for_shadow_rays) {
  const Scene scene = scene_of({mirror(ball), matte(floor_disk)},
                               {point_light({0, 5, 0}, {1, 1, 1}), point_light({}, {1, 1, 1})});
  const Calling shadow = calling(callings(scene), Effect::shadow);
  BOOST_TEST(shadow.is_on);
  BOOST_TEST(told(shadow.place) == "made.pbrt:1:1");
  BOOST_TEST(shadow.because == "a point light shines on a matte disk");
}

BOOST_AUTO_TEST_CASE(dark_lights_call_for_nothing) {
  const Light dark = point_light({0, 5, 0}, {0, 0, 0}), lit = point_light({0, 5, 0}, {0, 0, 1});
  const Scene unlit = scene_of({matte(ball)}, {dark});
  BOOST_TEST((effects(unlit) == Effects{}));
  BOOST_TEST(calling(callings(unlit), Effect::shadow).because == "every light is dark");
  const Calling shadow = calling(callings(scene_of({matte(ball)}, {dark, lit})), Effect::shadow);
  BOOST_TEST(shadow.is_on);
  BOOST_TEST(told(shadow.place) == "made.pbrt:2:1");
}

BOOST_AUTO_TEST_CASE(a_light_on_mirrors_alone_casts_no_shadow) {
  const Scene scene = scene_of({mirror(ball)}, {point_light({0, 5, 0}, {1, 1, 1})});
  BOOST_TEST((effects(scene) == Effects{.reflection = true}));
  BOOST_TEST(calling(callings(scene), Effect::shadow).because ==
             "nothing matte that a light shines on");
}

BOOST_AUTO_TEST_CASE(a_ball_that_is_a_light_does_not_shine_on_itself) {
  Scene scene = scene_of({matte(ball)}, {Light{.kind = Light::Kind::sphere, .primitive = 0}});
  scene.primitives[0].emitted = Colour{1, 1, 1};
  BOOST_TEST(!effects(scene).shadow);
  scene.primitives.push_back(matte(floor_disk));
  BOOST_TEST(effects(scene).shadow);
  BOOST_TEST(calling(callings(scene), Effect::shadow).because ==
             "a sphere that is a light shines on a matte disk");
}

BOOST_AUTO_TEST_CASE(a_mirror_calls_for_reflection_only) {
  const Scene scene = scene_of({matte(ball), mirror(floor_disk)});
  BOOST_TEST((effects(scene) == Effects{.reflection = true}));
  const Calling reflection = calling(callings(scene), Effect::reflection);
  BOOST_TEST(told(reflection.place) == "made.pbrt:2:1");
  BOOST_TEST(reflection.because == "a disk is a mirror");
}

BOOST_AUTO_TEST_CASE(glass_calls_for_reflection_and_refraction) {
  const Scene scene = scene_of({matte(floor_disk), glass(ball)});
  BOOST_TEST((effects(scene) == Effects{.reflection = true, .refraction = true}));
  BOOST_TEST(calling(callings(scene), Effect::refraction).because == "a sphere is dielectric");
  BOOST_TEST(told(calling(callings(scene), Effect::refraction).place) == "made.pbrt:2:1");
}

BOOST_AUTO_TEST_CASE(glass_that_lets_nothing_through_does_not_call_for_refraction) {
  Scene scene = scene_of({glass(ball)});
  scene.primitives[0].material.refracted = {0, 0, 0};
  BOOST_TEST((effects(scene) == Effects{.reflection = true}));
}

BOOST_AUTO_TEST_CASE(without_bounces_nothing_is_reflected) {
  Scene scene = scene_of({mirror(ball), glass(floor_disk)});
  scene.bounces = 0;
  BOOST_TEST((effects(scene) == Effects{}));
  BOOST_TEST(calling(callings(scene), Effect::reflection).because == "no bounce is allowed");
}

BOOST_AUTO_TEST_CASE(each_effect_is_had_by_its_own_name) {
  BOOST_TEST((Effects{.shadow = true}.has(Effect::shadow)));
  BOOST_TEST((!Effects{.shadow = true}.has(Effect::reflection)));
  BOOST_TEST((Effects{.reflection = true}.has(Effect::reflection)));
  BOOST_TEST((!Effects{.reflection = true}.has(Effect::refraction)));
  BOOST_TEST((Effects{.refraction = true}.has(Effect::refraction)));
  BOOST_TEST((!Effects{.refraction = true}.has(Effect::shadow)));
}
