#pragma once

#include <optional>

#include "rayaudit/convention.h"
#include "subjects/convention.hpp"

namespace rayaudit {

/// What is declared in plain C; nothing where a stance or a word for inside is none that there is,
/// or the range holds no t.
std::optional<Convention> from_flat(const rayaudit_convention& convention);

}  // namespace rayaudit
