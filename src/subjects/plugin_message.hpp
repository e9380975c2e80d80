#pragma once

#include <cstdint>
#include <type_traits>

#include "geometry/shapes.hpp"
#include "rayaudit/plugin.h"

/// What program and child say to each other. Both are the same program, so all of it goes as it
/// lies in memory.
namespace rayaudit {

static_assert(std::is_trivially_copyable_v<rayaudit_case> &&
              std::is_trivially_copyable_v<rayaudit_answer>);

/// What a plugin says of one of its subjects.
struct PluginSubject {
  char name[64];
  char format[16];
  char about[160];  ///< or nothing
  rayaudit_convention convention;
  bool answers[shape_count];  ///< by shape
};

/// Comes before the cases, as many as are told.
struct PluginRequest {
  char subject[sizeof PluginSubject::name + sizeof PluginSubject::format];  ///< name/format
  std::uint64_t shape;
  std::uint64_t count;
  bool one_by_one;  ///< each case is put to it alone, and each answer is sent when it is there
};

/// Comes before the answers; or, refused, before a sentence about why there are none. One comes
/// unasked, as soon as the plugin is loaded: before its subjects.
struct PluginReply {
  static constexpr std::uint64_t sign = 0x796c706572796172;  ///< by which garbage is told apart

  std::uint64_t signed_by = sign;
  std::uint64_t refused = 0;
  std::uint64_t bytes = 0;  ///< that follow
  double nanoseconds = 0;   ///< that the answers took
};

}  // namespace rayaudit
