#include "tests/oracle/second_derivation/spherical_kernel.hpp"

#include "tests/oracle/second_derivation/by_kernel.hpp"

namespace rayaudit {

std::size_t meet_by_spherical_kernel(std::span<const Case> cases) {
  std::size_t met = 0;
  for (const Case& question : cases)
    met += second::meetings(question.ray, *std::get_if<Sphere<double>>(&question.shape)).size();
  return met;
}

}  // namespace rayaudit
