#pragma once

#include <cstdint>
#include <type_traits>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"

/// What program and child say to each other. Both are the same program, so all of it goes as it
/// lies in memory.
namespace rayaudit {

static_assert(std::is_trivially_copyable_v<Case> && std::is_trivially_copyable_v<Answer>);

/// Comes before the cases, as many as are told.
struct ModuleRequest {
  char subject[64];
  std::uint64_t shape;
  std::uint64_t count;
};

/// Comes before the answers; or, refused, before a sentence about why there are none. One comes
/// unasked, as soon as the module is loaded.
struct ModuleReply {
  static constexpr std::uint64_t sign = 0x796c706572796172;  ///< by which garbage is told apart

  std::uint64_t signed_by = sign;
  std::uint64_t refused = 0;
  std::uint64_t bytes = 0;  ///< that follow
  double nanoseconds = 0;   ///< that the answers took
};

}  // namespace rayaudit
