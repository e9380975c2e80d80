#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "geometry/case.hpp"
#include "geometry/format.hpp"
#include "oracle/truth.hpp"

namespace rayaudit {

/// What a subject declares of the choices that mathematics leaves open, and of what it is to be
/// asked. What is not declared is either, and never counted as wrong.
struct Convention {
  enum class Stance : std::uint8_t { either, hit, miss };
  /// What a hit is told as at which the ray comes from inside the body: that hit, a miss, a hit
  /// where the ray starts, or whatever it likes. A disk has no inside.
  enum class Inside : std::uint8_t { hit, miss, start, any };

  enum class Stand : std::uint8_t { anywhere, upright_y, upright_z };
  enum class Opening : std::uint8_t { radius, angle, cosine };

  std::array<Stance, 7> stances = {};  ///< for every kind of touch, by oracle::Kind
  Inside inside = Inside::hit;
  bool unit_direction = false;      ///< it is given directions normalised in its format
  bool line = false;                ///< it answers for the whole line, both ways
  Extent extent = Extent::bounded;  ///< how much of disk, cylinder and cone it knows
  /// How cylinder and cone, capped or not, stand for it: as they come, or with the middle of the
  /// axis at the world origin and the axis along +y or +z, to the top or apex. Where the case has
  /// its axis along a coordinate axis only coordinates change places; else the ray is turned, and
  /// rounded.
  Stand stand = Stand::anywhere;
  /// What it is told of a cone's opening. What is asked is the cone that it is told, of height 1:
  /// its radius is the tangent of an angle, or of the angle of a cosine, that the format has.
  Opening opening = Opening::radius;
  /// It takes two points: where the range begins, and where it ends or, if it goes on for long,
  /// lies beyond the shape. The direction is their exact difference, the range from 0 to 1; or
  /// that of the whole line through them, of a line.
  bool segment = false;
  /// It answers within these only, whatever the ray has.
  double t_min = -std::numeric_limits<double>::infinity();
  double t_max = std::numeric_limits<double>::infinity();

  Stance of(oracle::Kind kind) const { return stances[static_cast<std::size_t>(kind)]; }
  Stance& of(oracle::Kind kind) { return stances[static_cast<std::size_t>(kind)]; }

  friend bool operator==(const Convention&, const Convention&) = default;
};

/// Their words, as `--convention` takes them.
std::string_view word(Convention::Stand stand);
std::string_view word(Convention::Opening opening);

std::string_view name(Convention::Inside inside);

/// Is there room for any t in the range?
bool has_range(const Convention& convention);

/// The range of one that has no room, in words: `the empty range from 2 to 1 for t`.
std::string empty_range(const Convention& convention);

/// What it cannot mean, in words after `has`: an empty range, or a segment of length 1; or nothing.
std::string contradiction(const Convention& convention);

/// What either declares; where both do, the first. Throws Error where together they have a
/// contradiction: ranges that have no t in common, say.
Convention joined(const Convention& first, const Convention& second);

/// Is any case asked otherwise under the convention than it was drawn?
bool poses(const Convention& convention);

/// The case as it is asked under the convention: with the extent that the subject knows, upright,
/// with the opening that it is told, a direction normalised in the format or a segment, and a range
/// that it answers in (posing.hpp). What was posed so already stays as it is.
Case posed(const Case& question, const Convention& convention, const Format& format);

/// The case in numbers of a format that cases are drawn in: floats for float, else as it is.
Case rounded(const Case& question, const Format& format);

/// Any case as a subject is asked it whose cases are drawn in the format: rounded, then posed. What
/// was asked so already stays as it is.
Case asked(const Case& question, const Convention& convention, const Format& format);

}  // namespace rayaudit
