#pragma once

#include <string>

namespace rayaudit {

/// What the program found where it ran, for the record: results depend on none of it, or are wrong.
struct Environment {
  std::string compiler, flags, processor;
  bool contraction;  ///< does a * b + c round once where the source says twice?
  bool flush_to_zero;
  std::string rounding;  ///< to nearest, upward, ...
  unsigned processors;   ///< that can run at once
};
Environment environment();

}  // namespace rayaudit
