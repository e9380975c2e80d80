#pragma once

#include <cstdlib>
#include <stdexcept>
#include <string>

/// What ctest names to a test by a variable of the environment.
inline std::string from_environment(const char* name) {
  const char* value = std::getenv(name);
  if (value == nullptr) throw std::runtime_error(std::string(name) + " is not in the environment");
  return value;
}
