#pragma once

#include "oracle/truth.hpp"

namespace rayaudit::oracle {

/// Calls visit(kind, part) for every parameter of the shape.
template <class S, class V>
void each_part(S& shape, V&& visit) {
  std::apply(
      [&](auto&... part) {
        std::size_t i = 0;
        (visit(S::kinds[i++], part), ...);
      },
      shape.parts());
}

/// Are all numbers of the case 0 or within 2^-64 .. 2^64? Then no field, discriminant or side sign
/// of ours overflows or underflows in double.
bool is_moderate(const Case& question);

/// Why a case is no question of truth, or Invalid::no. Moderate cases are spared the search for
/// numbers that are not finite.
Invalid invalid(const Case& question, bool moderate);

/// A valid case with powers of two taken out, so that its exponents are near 0: lengths are divided
/// by 2^length, the direction by 2^direction, t (and the range) by 2^(length - direction). A normal
/// is scaled on its own. Signs and the order of roots stay as they are.
struct Scaled {
  Case question;
  int length = 0, direction = 0;
  bool exact = true;  ///< false where a number would have lost bits: then the case is unscaled

  int t_exponent() const { return length - direction; }
};
Scaled scaled(const Case& question);

}  // namespace rayaudit::oracle
