#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scenes/scene.hpp"

namespace rayaudit {

/// Why a ray is there at all.
enum class Effect : std::uint8_t { primary, shadow, reflection, refraction };
inline constexpr std::size_t effect_count = 4;
inline constexpr std::array<std::string_view, effect_count> effect_names = {
    "primary", "shadow", "reflection", "refraction"};
inline std::string_view name(Effect effect) {
  return effect_names[static_cast<std::size_t>(effect)];
}

/// Which effects are on; primary visibility always is.
struct Effects {
  bool shadow = false, reflection = false, refraction = false;

  bool has(Effect effect) const;
  friend bool operator==(const Effects&, const Effects&) = default;
};

/// Why a scene calls for an effect, or does not.
struct Calling {
  Effect effect;
  bool is_on = false;
  /// What calls for it: the first such thing in the file; without a meaning where it is off.
  Place place = {};
  std::string because = {};  ///< `a point light shines on a matte sphere`; `no light`
};

/// Every effect, in order: shadow rays where a light shines and something is matte, reflection
/// where something mirrors or is dielectric, refraction where something is dielectric.
std::array<Calling, effect_count> callings(const Scene& scene);
Effects effects(const Scene& scene);

}  // namespace rayaudit
