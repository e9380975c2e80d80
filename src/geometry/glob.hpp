#pragma once

#include <fnmatch.h>

#include <string>
#include <string_view>

namespace rayaudit {

/// Does a pattern stand for more names than itself: has it `*`, `?` or `[...]`?
inline bool is_glob(std::string_view pattern) {
  return pattern.find_first_of("*?[") != pattern.npos;
}

/// Is it the name, or a glob that matches it?
inline bool matches(const std::string& pattern, std::string_view name) {
  return pattern == name || fnmatch(pattern.c_str(), std::string(name).c_str(), 0) == 0;
}

}  // namespace rayaudit
