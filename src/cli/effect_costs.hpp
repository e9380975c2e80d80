#pragma once

#include <string>

#include "cli/renderers.hpp"
#include "scenes/effect.hpp"

namespace rayaudit {

/// Which effects a scene calls for, because of what, which of them are left on, and what share of
/// rays and time each takes: traced once for that, small, on one thread. Lines for people.
std::string effect_costs(const Scene& scene, const Renderer& renderer, Effects on,
                         std::uint64_t seed);

}  // namespace rayaudit
