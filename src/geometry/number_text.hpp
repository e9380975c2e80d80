#pragma once

#include <string>
#include <string_view>

#include "geometry/quotation.hpp"
#include "geometry/real.hpp"

/// Numbers as text, exactly: C hex floats or decimals, inf and nan.
namespace rayaudit {

/// What a number is: the radius of a sphere, the x of its centre.
struct NumberPlace {
  std::string_view owner, label;
  char component = 0;

  std::string owned() const { return std::string(owner) + ": "; }
  std::string name() const {
    return component == 0 ? std::string(label) : std::string(label) + " " + component;
  }
};

/// A word as it stands in a sentence about it; an empty one is the end of its line.
inline std::string told_word(std::string_view word) {
  return word.empty() ? "the end of the line" : quotation(word);
}

/// The number that a word is: a hex float exactly, a decimal rounded to the nearest double. Throws
/// Error, which tells its place, where it is none, or one that three doubles do not hold.
Real read_real(std::string_view word, const NumberPlace& place);
/// The nearest double; throws Error where a finite number overflows it, too.
double read_double(std::string_view word, const NumberPlace& place);

/// Append a number to a line, exactly, as a hex float; no space before or after.
void write(std::string& line, double number);
void write(std::string& line, const Real& number);

}  // namespace rayaudit
