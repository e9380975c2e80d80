#pragma once

#include <string_view>

#include "geometry/case.hpp"
#include "geometry/format.hpp"

namespace rayaudit {

/// The format of a name: float, double or long_double; throws Error where it is none of these.
const Format& known_format(std::string_view name);

/// Is every number of the case one of the format?
bool is_in(const Case& question, const Format& format);

}  // namespace rayaudit
