#pragma once

#include "audit/judge.hpp"

namespace rayaudit {

/// A verdict nearer to another truth than so many u may be rounding's, and so may a t that is off
/// by no more than so many times what rounding the case does to it.
inline constexpr double beyond_rounding_margin = 0x1p10;

/// Is a wrong answer, to a case of that margin in u of the format, one that rounding does not
/// excuse? It is where no product of four numbers leaves the range of the format; where the
/// textbook's routine in the same format is right on the very case, and would be were each of its
/// operations 2^8 times less exact (subjects/peer.hpp); and where the margin, or of a wrong t its
/// own error, is above beyond_rounding_margin, and above that times what the opening of a cone
/// moves more than the angle or cosine that it is told by. A wrong t must then be
/// further off than the textbook's, so much less exact, could be, and a point that is told by more
/// than rounding its coordinates does. A t that is not finite, and no answer at all, need no
/// margin; for no answer squares alone must stay in the range. What becomes of invalid cases is
/// conduct, and never is.
bool is_beyond_rounding(Settled& settled, const Answer& answer, const Judgement& judgement,
                        double margin, const Format& format, const Convention& convention);

}  // namespace rayaudit
