#pragma once

#include <boost/test/unit_test.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "tests/watched.hpp"

namespace rayaudit {

inline const Family& family_of(std::string_view id) {
  for (const Family& family : families())
    if (family.id == id) return family;
  throw Error("no family " + std::string(id));
}

/// The first cases of a family for a shape in a format.
inline std::vector<Case> drawn(const Family& family, std::size_t shape, const Format& format,
                               std::optional<int> difficulty = {}, std::uint64_t chunk = 0,
                               std::size_t count = chunk_cases) {
  std::vector<Case> cases(count);
  draw(family, shape, format, difficulty, 1, chunk, cases);
  return cases;
}

/// Calls visit(family, shape, format) for all there is to draw.
template <class V>
void each_drawing(V&& visit) {
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      for (const Format& format : {float_format, double_format})
        if (family.draw[shape]) visit(family, shape, format);
}

/// Requires holds(question) of every case, and prints the first for which it does not.
template <class H>
void require_each(const Family& family, std::size_t shape, const Format& format,
                  const std::vector<Case>& cases, H&& holds) {
  for (const Case& question : cases) {
    if (holds(question)) continue;
    BOOST_ERROR(family.id << ' ' << shape_names[shape] << ' ' << format.name << ": "
                          << case_line(question));
    return;
  }
}

/// The share of cases for which holds(question).
template <class H>
double share(const std::vector<Case>& cases, H&& holds) {
  std::size_t count = 0;
  for (const Case& question : cases) count += holds(question) ? 1 : 0;
  return static_cast<double>(count) / static_cast<double>(cases.size());
}

}  // namespace rayaudit
