#pragma once

#include <array>
#include <cstdint>

#include "oracle/truth.hpp"

namespace rayaudit {

/// What a subject declares of the choices that mathematics leaves open: for every kind of touch,
/// whether it is a hit. What is not declared is either, and never counted as wrong.
struct Convention {
  enum class Stance : std::uint8_t { either, hit, miss };

  std::array<Stance, 7> stances = {};  ///< by oracle::Kind

  Stance of(oracle::Kind kind) const { return stances[static_cast<std::size_t>(kind)]; }
  Stance& of(oracle::Kind kind) { return stances[static_cast<std::size_t>(kind)]; }
};

}  // namespace rayaudit
