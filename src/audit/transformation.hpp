#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "audit/cause.hpp"

namespace rayaudit {

/// A changed case, and the t of which are 2^t_exponent times those of the case, where they are.
struct Changed {
  Case question;
  int t_exponent = 0;
};

/// A change of a case that leaves its truth alone, but for what becomes of t.
struct Transformation {
  /// What of an answer that it changes is shown by that.
  enum class Shows {
    /// An assumption: every operation of floating point that does not overflow or underflow goes
    /// along, so that the answer must be the same to the last bit.
    to_the_bit,
    by_mending,  ///< an assumption, where the answer is mended
    from_afar,   ///< the same where the case is far from any other truth, else rounding
    /// The same, and nearer nothing, for it is no exact change; and nothing where the next change
    /// mends it as well, which is as inexact and leaves out what this is about.
    only_afar,
    control,
    in_whole_numbers,  ///< an assumption where no sum is rounded in any order, else rounding
    rounding,
  };

  std::string_view about;  ///< what answers depend on where it changes them
  /// The changed case; nothing where the format does not hold its numbers, or there is no such.
  std::optional<Changed> (*change)(const Case& question, const Format& format);
  Shows shows;
};

/// What hangs on the length of a direction that may be of any is told to be.
inline constexpr std::string_view length_of_direction = "the length of the direction";

/// Every one there is.
std::span<const Transformation> transformations();

/// The cause of a wrong answer of a subject that cannot be replayed. What it takes for granted is
/// the first transformation that changes its answer; where rounding may be what changes it, only
/// cases far from any other truth count, and nearer ones show that it is rounding. A case in whole
/// numbers so small that no rounding matters, and far from any other truth, shows the formula.
Diagnosis diagnosis_from_outside(const Wrong& wrong, const Subject& subject,
                                 const Convention& convention);

}  // namespace rayaudit
