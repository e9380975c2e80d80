#include "cli/names.hpp"

#include <fnmatch.h>

#include <algorithm>

#include "cli/exit_code.hpp"
#include "geometry/error.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

bool is_glob(std::string_view pattern) { return pattern.find_first_of("*?[") != pattern.npos; }

bool matches(const std::string& glob, std::string_view name) {
  return fnmatch(glob.c_str(), std::string(name).c_str(), 0) == 0;
}

}  // namespace

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
