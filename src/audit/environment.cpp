#include "audit/environment.hpp"

#include <cfenv>
#include <fstream>
#include <thread>

namespace rayaudit {
namespace {

std::string compiler() {
#ifdef __clang__
  return __VERSION__;
#else
  return "gcc " __VERSION__;
#endif
}

/// (1 + u)^2 - (1 + 2u) is u^2, which is lost where the product is rounded.
bool contracts() {
  volatile double one_and_some = 1 + 0x1p-30, square = 1 + 0x1p-29;
  const double a = one_and_some, b = one_and_some, c = square;
  return a * b - c != 0;
}

/// Are subnormal numbers lost, as a result or in a comparison?
bool flushes_to_zero() {
  volatile double least_normal = 0x1p-1022, half = 0.5;
  return least_normal * half == 0;
}

std::string rounding() {
  switch (std::fegetround()) {
    case FE_TONEAREST:
      return "to nearest";
    case FE_UPWARD:
      return "upward";
    case FE_DOWNWARD:
      return "downward";
    case FE_TOWARDZERO:
      return "toward zero";
    default:
      return "unknown";
  }
}

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (!line.starts_with("model name")) continue;
    const std::size_t colon = line.find(':');
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    if (colon != std::string::npos && start != std::string::npos) return line.substr(start);
  }
  return "unknown";
}

}  // namespace

Environment environment() {
  return {.compiler = compiler(),
          .flags = RAYAUDIT_FLAGS,
          .processor = processor(),
          .contraction = contracts(),
          .flush_to_zero = flushes_to_zero(),
          .rounding = rounding(),
          .processors = std::thread::hardware_concurrency()};
}

}  // namespace rayaudit
