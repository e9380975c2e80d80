#include "geometry/unknown_name.hpp"

#include <algorithm>
#include <numeric>
#include <vector>

#include "geometry/quotation.hpp"

namespace rayaudit {
namespace {

/// How many letters must be put in, left out or changed (Levenshtein), or neighbours swapped.
std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    before.swap(above);
    above.swap(row);
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
      const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
      if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string unknown_name(std::string_view what, std::string_view name,
                         std::span<const std::string_view> known) {
  std::string sentence = std::string(what) + " " + quotation(name) + " is not known; ";
  const auto nearest =
      std::min_element(known.begin(), known.end(), [&](std::string_view a, std::string_view b) {
        return distance(name, a) < distance(name, b);
      });
  if (nearest != known.end() &&
      distance(name, *nearest) <= std::max<std::size_t>(name.size() / 3, 1))
    return sentence + "did you mean " + quotation(*nearest) + "?";
  sentence += "known are";
  for (std::size_t i = 0; i < known.size(); ++i)
    sentence += (i == 0 ? " " : ", ") + quotation(known[i]);
  return sentence;
}

}  // namespace rayaudit
