#include "cli/selection.hpp"

#include <fmt/format.h>

#include "geometry/error.hpp"

namespace rayaudit {

std::vector<std::size_t> shapes_of(const Family& family) {
  std::vector<std::size_t> shapes;
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    if (family.draw[shape] != nullptr) shapes.push_back(shape);
  return shapes;
}

void require_difficulty(const Family& family, const Format& format, int difficulty) {
  const int least = family.difficulty->least, most = family.difficulty->most(format);
  if (difficulty < least || difficulty > most)
    throw Error(fmt::format("--difficulty {} is not one of family `{}` in {}: {} to {}", difficulty,
                            family.id, format.name, least, most));
}

}  // namespace rayaudit
