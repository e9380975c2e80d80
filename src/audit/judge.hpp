#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>

#include "geometry/answer.hpp"
#include "geometry/format.hpp"
#include "oracle/margin.hpp"
#include "oracle/position.hpp"
#include "oracle/truth.hpp"
#include "subjects/convention.hpp"

namespace rayaudit {

/// One answer against one truth.
enum class Verdict : std::uint8_t {
  right,               ///< the first proper hit, or a miss where there is none
  touch,               ///< a matter of convention: a touch taken, or passed by
  false_hit,           ///< a hit where no hit is acceptable
  false_miss,          ///< a miss where there is a proper hit
  wrong_root,          ///< a t nearest to a root of F that is no acceptable answer
  wrong_t,             ///< the right root, off by more than wrong_t_limit
  not_finite,          ///< a t that is NaN, or infinite where the true t is not
  crashed,             ///< no answer: the subject's process ended, or it said what is none
  timed_out,           ///< no answer for as long as it was given
  invalid_handled,     ///< the case is invalid, and the subject says miss
  invalid_mishandled,  ///< the case is invalid, and the subject says hit, or does not answer
};
inline constexpr std::size_t verdict_count = 11;
std::string_view name(Verdict verdict);
/// Is this verdict the subject's fault?
bool is_wrong(Verdict verdict);

/// A t is wrong where it is off by more than this share of the exact t.
inline constexpr double wrong_t_limit = 0x1p-7;

/// What there is at the place that a false hit or a wrong root claims.
enum class Claim : std::uint8_t {
  none,      ///< nothing is claimed wrongly
  no_root,   ///< no root of F is near
  nan,       ///< t is NaN
  infinite,  ///< t is infinite
  behind,    ///< a root before the range
  past,      ///< a root after the range
  clipped,   ///< a root outside a side condition: beside the disk, above or below the shape
  mirrored,  ///< a root on the cone's other nappe
  later,     ///< a crossing, but not the first
  declined,  ///< what the subject declares to be a miss: a touch, or a hit from inside
  parallel,  ///< F is the same all along the ray: no root, near or far
  centre,    ///< the point told is the centre (or base) of the shape itself
  origin,    ///< of a false miss: the hit that is missed lies at the world origin
  garbage,   ///< of no answer: what came has no known form
  ended,     ///< of an invalid case: its process ended
  hung,      ///< of an invalid case: no answer came in time
};
inline constexpr std::size_t claim_count = 16;
std::string_view name(Claim claim);

/// On which side of the surface the rounded point lies, as the ray came. A ray that starts beyond
/// the surface after a reflection meets it again.
enum class Side : std::uint8_t { unknown, before, on, beyond };
inline constexpr std::size_t side_count = 4;
std::string_view name(Side side);

struct Judgement {
  static constexpr double unmeasured = std::numeric_limits<double>::quiet_NaN();

  Verdict verdict = Verdict::right;
  Claim claim = Claim::none;
  /// The touch that was on offer, if one was, and whether it was taken.
  std::optional<oracle::Kind> touch = {};
  bool taken = false;
  /// The crossing that t was held against: its place in the truth's list, or -1.
  int crossing = -1;
  /// Of hits judged right, wrong_t or touch; else unmeasured.
  double ulps = unmeasured;      ///< error of t in ulps of the subject's format at the exact t
  double relative = unmeasured;  ///< |t - exact| / |exact|
  double forced = unmeasured;    ///< error in units of what rounding the inputs once would do to t
  /// Error in units of the larger of that and an ulp: what no rounding of case or answer excuses.
  double own = unmeasured;
  double condition = unmeasured;  ///< what that unit is in ulps, however large the error
  double distance =
      unmeasured;  ///< of the rounded point to the surface, ulps of its largest coordinate
  Side side = Side::unknown;
};

/// A case with its truth, and what more an answer may ask about it, worked out once and only then.
class Settled {
 public:
  Settled(const Case& question, const oracle::Truth& truth) : question_(question), truth_(truth) {}

  const Case& question() const { return question_; }
  const oracle::Truth& truth() const { return truth_; }
  const oracle::Roots& roots();
  const oracle::Sensitivity& sensitivity(int crossing);
  /// How far the numbers must move, relatively, for the truth to change; NaN for an invalid case.
  double reach();
  /// The same where double-word numbers tell it; else it takes exact ones, and up to a millisecond.
  std::optional<double> quick_reach();

 private:
  const Case& question_;
  const oracle::Truth& truth_;
  std::optional<oracle::Roots> roots_;
  std::optional<double> reach_;
  bool is_slow_ = false;  ///< double-word numbers do not tell the reach
  std::array<std::optional<oracle::Sensitivity>, oracle::Truth::most> sensitivities_;
};

/// Does the ray come from inside to its proper hit? The sign of F just before it tells; a disk has
/// no inside.
bool comes_from_inside(Settled& settled);

/// The crossings that an answer may name under a convention: touches up to and including the first
/// that must be taken, a proper one or a touch declared to be a hit. Where none must, a miss will
/// do. Not of a ray from inside where its start is declared to be the hit.
struct Choices {
  std::array<int, oracle::Truth::most> acceptable = {};  ///< places in the truth's list
  int count = 0;
  int must = -1;                                      ///< the one that ends the list, or -1
  std::array<int, oracle::Truth::most> refused = {};  ///< crossings that are not acceptable
  int refused_count = 0;
  std::optional<oracle::Kind> open_touch;  ///< the first touch left open

  Choices(Settled& settled, const Convention& convention);

  bool accepts(int crossing) const;
  std::span<const int> list() const { return {acceptable.data(), static_cast<std::size_t>(count)}; }
};

/// Decides in the order of DESIGN.md, section 5. The truth's t are known to bits_for(format).
Judgement judge(Settled& settled, const Answer& answer, const Format& format,
                const Convention& convention = {});

/// Judges one answer from scratch.
Judgement judge(const Case& question, const Answer& answer, const Format& format,
                const Convention& convention = {});

}  // namespace rayaudit
