#include "scenes/effect.hpp"

#include <algorithm>
#include <optional>

namespace rayaudit {
namespace {

bool is_dark(const Colour& colour) { return colour == Colour{0, 0, 0}; }

std::string_view name(Light::Kind kind) {
  return kind == Light::Kind::point     ? "a point light"
         : kind == Light::Kind::distant ? "a distant light"
                                        : "a sphere that is a light";
}

bool is_matte(const Primitive& primitive) {
  return primitive.material.finish == Finish::matte && !is_dark(primitive.material.reflected);
}
bool mirrors(const Primitive& primitive) {
  return primitive.material.finish != Finish::matte && !is_dark(primitive.material.reflected);
}
bool refracts(const Primitive& primitive) {
  return primitive.material.finish == Finish::dielectric && !is_dark(primitive.material.refracted);
}

Calling off(Effect effect, std::string because) { return {effect, false, {}, std::move(because)}; }

/// The first light with the first matte shape that is not that light itself: no ball shines on its
/// own outside.
Calling shadow(const Scene& scene) {
  const auto shines = [](const Light& light) { return !is_dark(light.colour); };
  if (std::ranges::none_of(scene.lights, shines))
    return off(Effect::shadow, scene.lights.empty() ? "no light" : "every light is dark");
  for (const Light& light : scene.lights)
    for (std::size_t i = 0; i < scene.primitives.size(); ++i)
      if (shines(light) && is_matte(scene.primitives[i]) &&
          (light.kind != Light::Kind::sphere || light.primitive != i))
        return {Effect::shadow, true, light.place,
                std::string(name(light.kind)) + " shines on a matte " +
                    std::string(rayaudit::name(scene.primitives[i].shape))};
  return off(Effect::shadow, "nothing matte that a light shines on");
}

Calling bounce(Effect effect, const Scene& scene, bool (*calls)(const Primitive&),
               std::string none) {
  const auto found = std::find_if(scene.primitives.begin(), scene.primitives.end(), calls);
  if (found == scene.primitives.end()) return off(effect, std::move(none));
  if (scene.bounces <= 0) return off(effect, "no bounce is allowed");
  const bool is_mirror = found->material.finish == Finish::mirror;
  return {effect, true, found->material.place,
          "a " + std::string(rayaudit::name(found->shape)) +
              (is_mirror ? " is a mirror" : " is dielectric")};
}

}  // namespace

bool Effects::has(Effect effect) const {
  switch (effect) {
    case Effect::shadow:
      return shadow;
    case Effect::reflection:
      return reflection;
    case Effect::refraction:
      return refraction;
    case Effect::primary:
      break;
  }
  return true;
}

std::array<Calling, effect_count> callings(const Scene& scene) {
  return {Calling{Effect::primary, true, {scene.name, 1, 1}, "every picture has them"},
          shadow(scene),
          bounce(Effect::reflection, scene, mirrors, "nothing mirrors or is dielectric"),
          bounce(Effect::refraction, scene, refracts, "nothing is dielectric")};
}

Effects effects(const Scene& scene) {
  const std::array<Calling, effect_count> all = callings(scene);
  return {all[1].is_on, all[2].is_on, all[3].is_on};
}

}  // namespace rayaudit
