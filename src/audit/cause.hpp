#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "audit/judge.hpp"
#include "oracle/replay/replay.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// Why an answer is not the right one.
enum class Cause : std::uint8_t {
  formula,     ///< exact arithmetic does not mend it
  assumption,  ///< exact arithmetic does, once what the routine takes for granted is so
  convention,  ///< of every touch: mathematics leaves it open
  flip,        ///< one comparison that rounding turned; answered rightly, the answer is right
  rounding,    ///< exact arithmetic mends it, but no one comparison does
  unknown,     ///< past the work limit of a replay, or nothing was found from outside
};
inline constexpr std::size_t cause_count = 6;
std::string_view name(Cause cause);

/// A cause, and what the experiment that showed it has to say.
struct Diagnosis {
  Cause cause = Cause::unknown;
  /// Of a formula, the operation without a value, or that it shows in small whole numbers; of an
  /// assumption, what is taken for granted.
  std::string_view about = {};
  /// Of a flip, the comparison that was turned.
  std::optional<replay::Step> turned = {};
};

/// The cause in words, as `flip at routines/stable_roots.hpp:20`.
std::string told(const Diagnosis& diagnosis);

/// What an answer is looked into for.
struct Wrong {
  Settled& settled;
  const Answer& answer;
  const Judgement& judgement;
  /// A right answer is looked into for its error where it has more ulps than this.
  std::optional<double> most_ulps = {};
};

/// The cause of an answer that is wrong, off by more than it may be, or a touch. By replay where
/// there is one, as DESIGN.md has it in section 7, else by exact changes of the case that leave its
/// truth alone.
Diagnosis diagnosis(const Wrong& wrong, const Subject& subject, const replay::Replay* replay,
                    const Convention& convention);

}  // namespace rayaudit
