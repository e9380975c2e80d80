#pragma once

#include <cstdint>
#include <string_view>

namespace rayaudit {

/// The most that an option can be given.
inline constexpr std::int64_t largest_number = 1'000'000'000'000'000'000;

/// The whole number that an option was given, as people write it: 10000, 10_000, 1e4, 10k (k, M, G:
/// powers of 1000). Throws Error that names the option where it is none, or not in [least, most].
std::int64_t whole_number(std::string_view option, std::string_view text, std::int64_t least,
                          std::int64_t most);

}  // namespace rayaudit
