#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "families/family.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {

/// The seed of all that is drawn where no other is asked for.
inline constexpr std::uint64_t default_seed = 1;

/// The most cases that can be drawn: all counts of a run stay far from overflow.
inline constexpr std::int64_t largest_cases = 1'000'000'000'000'000;

/// The subjects that an audit of these names and globs has: without any, those of every audit. A
/// glob stands for these too; where it matches none of them, for any subject there is. Throws Error
/// where a name is not known, NothingAudited where a glob matches nothing.
std::vector<const Subject*> selected_subjects(const std::vector<std::string>& patterns);

/// Throws Error where a name or glob asks for subjects that this build or place does not have.
void require_present(const std::vector<std::string>& patterns);

/// The shapes that a family draws.
std::vector<std::size_t> shapes_of(const Family& family);

/// Throws Error unless the difficulty lies in the range that the family has in the format.
void require_difficulty(const Family& family, const Format& format, int difficulty);

}  // namespace rayaudit
