#pragma once

#include <string>

#include "reports/scene_run.hpp"
#include "tests/reports/hand_made.hpp"

namespace rayaudit {

/// A scene that was made by hand, with a picture and an account that nothing was traced for.
struct HandMadeScene {
  Scene scene = {.name = "planet.pbrt",
                 .primitives = {{.shape = Sphere<double>{{0, 0, 5}, 1}}},
                 .lights = {{}}};
  Subject subject = {"mine/float", float_format, {}};
  PicturePlan plan = {.scene = scene,
                      .subject = subject,
                      .effects = {.shadow = true, .reflection = false, .refraction = true},
                      .offset = {Offset::Kind::t_min, 1e-3, "t_min=1e-3"},
                      .seed = 0xfedcba9876543210};
  Picture picture = {};
  std::array<Calling, effect_count> callings = {
      {{Effect::primary, true, {"planet.pbrt", 1, 1}, "every picture has them"},
       {Effect::shadow, true, {"planet.pbrt", 12, 1}, "a point light shines on a matte sphere"},
       {Effect::reflection, true, {"planet.pbrt", 20, 3}, "a sphere is a mirror"},
       {Effect::refraction, false, {}, "nothing is dielectric"}}};

  HandMadeScene() = default;
  HandMadeScene(const HandMadeScene&) = delete;
  HandMadeScene& operator=(const HandMadeScene&) = delete;

  /// Something in a file, at its line 3, that there is no use for.
  void skip(const std::string& file, const std::string& what) {
    Skipped& skipped = scene.skipped.emplace_back();
    skipped.place.file = file, skipped.place.line = 3;
    skipped.what = what;
  }

  /// Rays of one effect and bounce that asked as many questions, all answered rightly.
  WaveAccount& add(Effect effect, int bounce, std::uint64_t rays) {
    WaveAccount& wave = picture.account.waves.emplace_back(WaveAccount{effect, bounce});
    wave.rays = wave.questions = rays;
    wave.tally.cases = wave.tally.decided_by[2] = wave.tally.verdicts[0] = rays;
    return wave;
  }

  SceneRun run() const {
    return {.version = "1.2.3",
            .plan = plan,
            .picture = picture,
            .callings = callings,
            .environment = HandMade().environment};
  }
};

/// What happened so often, worst to a known case.
inline Trouble trouble(std::uint64_t count, double severity, double x) {
  return {count, severity, known_case(x)};
}

}  // namespace rayaudit
