#pragma once

#include <span>
#include <string>
#include <string_view>

namespace rayaudit {

/// The sentence for a name that is not known: "shape `shpere` is not known; did you mean
/// `sphere`?", or all that are known where none is near.
std::string unknown_name(std::string_view what, std::string_view name,
                         std::span<const std::string_view> known);

}  // namespace rayaudit
