#pragma once

#include "rayaudit/convention.h"
#include "subjects/convention.hpp"

namespace rayaudit {

/// What is declared in plain C. Throws Error, in a sentence about the subject, where a stance or a
/// word for inside is none that there is, or the range holds no t.
Convention from_flat(const rayaudit_convention& said);

}  // namespace rayaudit
