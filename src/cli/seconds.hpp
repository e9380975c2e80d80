#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace rayaudit {

/// The time that an option was given in seconds, from 0.01 to 3600: 2, 0.5. Throws Error that names
/// the option where it is none.
std::chrono::milliseconds seconds(std::string_view option, const std::string& text);

}  // namespace rayaudit
