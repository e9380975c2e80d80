#pragma once

#include <string>
#include <string_view>

#include "oracle/truth.hpp"

/// What people are shown of a case: what it says, and what is true.
namespace rayaudit {

/// A line of a label and a text.
std::string row(std::string_view label, std::string_view text);

/// In decimals, as many as tell it from its neighbours in the format.
std::string shown(const Real& x, const Format& format);

/// The ray and the shape, in decimals.
std::string question_text(const Case& question);

/// The truth with every crossing and root, in closed forms and digits, and the margin.
std::string truth_text(const Case& question, const oracle::Truth& truth);

}  // namespace rayaudit
