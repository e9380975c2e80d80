#include "cli/names.hpp"

#include <algorithm>

#include "cli/exit_code.hpp"
#include "geometry/error.hpp"
#include "geometry/glob.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {

std::size_t place_of(std::string_view what, std::string_view name,
                     std::span<const std::string_view> known) {
  const auto found = std::find(known.begin(), known.end(), name);
  if (found == known.end()) throw Error(unknown_name(what, name, known));
  return static_cast<std::size_t>(found - known.begin());
}

std::vector<std::size_t> selected(std::string_view what, const std::vector<std::string>& patterns,
                                  std::span<const std::string_view> known) {
  std::vector<bool> chosen(known.size(), patterns.empty());
  for (const std::string& pattern : patterns) {
    if (!is_glob(pattern)) {
      chosen[place_of(what, pattern, known)] = true;
      continue;
    }
    bool any = false;
    for (std::size_t i = 0; i < known.size(); ++i) {
      if (!matches(pattern, known[i])) continue;
      any = chosen[i] = true;
    }
    if (!any) throw NothingAudited("no " + std::string(what) + " matches `" + pattern + "`");
  }
  std::vector<std::size_t> places;
  for (std::size_t i = 0; i < known.size(); ++i)
    if (chosen[i]) places.push_back(i);
  return places;
}

}  // namespace rayaudit
