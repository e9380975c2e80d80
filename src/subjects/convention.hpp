#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include "geometry/case.hpp"
#include "geometry/format.hpp"
#include "oracle/truth.hpp"

namespace rayaudit {

/// What a subject declares of the choices that mathematics leaves open, and of what it is to be
/// asked. What is not declared is either, and never counted as wrong.
struct Convention {
  enum class Stance : std::uint8_t { either, hit, miss };
  /// What a hit is told as at which the ray comes from inside the body: that hit, a miss, or a hit
  /// where the ray starts. A disk has no inside.
  enum class Inside : std::uint8_t { hit, miss, start };

  std::array<Stance, 7> stances = {};  ///< for every kind of touch, by oracle::Kind
  Inside inside = Inside::hit;
  bool unit_direction = false;  ///< it is given directions normalised in its format
  bool line = false;            ///< it answers for the whole line, both ways
  /// It answers within these only, whatever the ray has.
  double t_min = -std::numeric_limits<double>::infinity();
  double t_max = std::numeric_limits<double>::infinity();

  Stance of(oracle::Kind kind) const { return stances[static_cast<std::size_t>(kind)]; }
  Stance& of(oracle::Kind kind) { return stances[static_cast<std::size_t>(kind)]; }

  friend bool operator==(const Convention&, const Convention&) = default;
};

/// Is there room for any t in the range?
bool has_range(const Convention& convention);

/// The range of one that has no room, in words: `the empty range from 2 to 1 for t`.
std::string empty_range(const Convention& convention);

/// What either declares; where both do, the first. Throws Error where their ranges have no t in
/// common.
Convention joined(const Convention& first, const Convention& second);

/// Is any case asked otherwise under the convention than it was drawn?
bool poses(const Convention& convention);

/// The case as it is asked under the convention: with a direction normalised in the format, and a
/// range that the subject answers in.
Case posed(const Case& question, const Convention& convention, const Format& format);

/// The case in numbers of a format that cases are drawn in: floats for float, else as it is.
Case rounded(const Case& question, const Format& format);

/// Any case as a subject is asked it whose cases are drawn in the format: rounded, then posed. What
/// was asked so already stays as it is.
Case asked(const Case& question, const Convention& convention, const Format& format);

}  // namespace rayaudit
