#pragma once

#include <string_view>

#include "subjects/convention.hpp"

namespace rayaudit {

/// What a subject declares, as an option has it: `tangent=hit,rim=miss`; a kind of touch that is
/// not named, or is `either`, is left open. Throws Error where it cannot be read.
Convention read_convention(std::string_view text);

}  // namespace rayaudit
