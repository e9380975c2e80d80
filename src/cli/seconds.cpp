#include "cli/seconds.hpp"

#include <cmath>
#include <cstdlib>

#include "geometry/error.hpp"
#include "geometry/quotation.hpp"

namespace rayaudit {

std::chrono::milliseconds seconds(std::string_view option, const std::string& text) {
  constexpr double least = 0.01, most = 3600;
  char* end = nullptr;
  const double time = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(time >= least && time <= most))
    throw Error(std::string(option) + " must be a time from 0.01 to 3600 seconds, got " +
                quotation(text));
  return std::chrono::milliseconds(std::lround(1000 * time));
}

}  // namespace rayaudit
