#pragma once

#include <optional>

#include "subjects/subject.hpp"

namespace rayaudit {

/// What the textbook's routine says of a case in a format (float, double or long double), and
/// whether that is beyond any doubt of rounding.
struct Peer {
  Answer answer = {};
  /// Would every comparison go the same way, were each of its operations that rounds 2^8 times less
  /// exact (numbers/worn.hpp)?
  bool is_sure = false;
  double bound = 0;  ///< of the error of t, then
};

/// What a library is held beside: nobody need do better than the textbook's formula in the same
/// arithmetic. Of shapes without ends the side conditions are left out.
Peer by_textbook(const Case& question, const Format& format);

}  // namespace rayaudit
