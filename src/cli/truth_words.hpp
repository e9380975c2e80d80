#pragma once

#include <string>

#include "oracle/truth.hpp"

namespace rayaudit {

/// Appends the truth of a case to its line, as files of cases have it: the crossings in order, t
/// correctly rounded in the format, then `miss` where the last is no proper one; or why the case is
/// invalid.
void write_truth(std::string& line, const Case& question, const oracle::Truth& truth,
                 const Format& format);

}  // namespace rayaudit
