#pragma once

#include <cstddef>
#include <cstdint>

#include "geometry/answer.hpp"
#include "geometry/case.hpp"

namespace rayaudit {

/// What a loaded module says of itself: the subjects that it brings. It must come from the same
/// source as the program, for cases and answers pass between them as they lie in memory.
extern "C" {

/// Answers count cases, all of one shape.
using ModuleBatch = void (*)(const Case* cases, std::size_t count, Answer* answers);

struct ModuleSubject {
  const char* name;
  const char* format;
  ModuleBatch answer[shape_count];  ///< by shape; null where it does not answer the shape
};

struct Module {
  std::uint32_t version;  ///< module_version; comes first in every version
  std::uint32_t case_size, answer_size;
  std::uint32_t count;
  const ModuleSubject* subjects;
};

/// The one symbol of a module, under the name module_entry.
using ModuleEntry = const Module* (*)();
}

inline constexpr std::uint32_t module_version = 1;
inline constexpr const char* module_entry = "rayaudit_module";

}  // namespace rayaudit
