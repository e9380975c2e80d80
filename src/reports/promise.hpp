#pragma once

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "audit/bound.hpp"

namespace rayaudit {

/// A limit in six digits where these are the number, as 1.2e+07, else in as many as it takes.
inline std::string promise(double most) {
  const std::string text = fmt::format("{:g}", most);
  return std::strtod(text.c_str(), nullptr) == most ? text : fmt::format("{}", most);
}

/// Limits as a file of bounds has them: `wrong 0 max_ulp 8`.
inline std::string promise(const std::vector<Limit>& limits) {
  std::string text;
  for (const auto& [quantity, most] : limits)
    text += fmt::format("{}{} {}", text.empty() ? "" : " ", quantity->name, promise(most));
  return text;
}

inline std::string promises(const std::vector<Bound>& bounds) {
  std::string text;
  for (const Bound& bound : bounds) (text += text.empty() ? "" : "; ") += promise(bound.limits);
  return text;
}

}  // namespace rayaudit
