#pragma once

#include <cstddef>

/// Sanitizers take their time, and watch the paths that cases go, not the numbers: of so many cases
/// one is put.
namespace rayaudit {

#ifdef RAYAUDIT_SANITIZED
inline constexpr std::size_t one_in = 4;
#else
inline constexpr std::size_t one_in = 1;
#endif

}  // namespace rayaudit
