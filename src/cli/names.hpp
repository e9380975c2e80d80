#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rayaudit {

/// The place of a name in a list of known ones; throws Error with the nearest where it is not
/// there.
std::size_t place_of(std::string_view what, std::string_view name,
                     std::span<const std::string_view> known);

/// The places of all known names that one of the patterns names, in the order of the list; all
/// where there are no patterns. A pattern is a name, or a glob with `*`, `?` and `[...]`. Throws
/// Error where a plain name is not known, NothingAudited where a glob matches nothing.
std::vector<std::size_t> selected(std::string_view what, const std::vector<std::string>& patterns,
                                  std::span<const std::string_view> known);

/// The names of a list of things, told by one of their members.
template <class List, class Name>
std::vector<std::string_view> names_of(const List& list, Name name) {
  std::vector<std::string_view> names(std::size(list));
  std::transform(std::begin(list), std::end(list), names.begin(),
                 [&](const auto& each) -> std::string_view { return each.*name; });
  return names;
}

}  // namespace rayaudit
