#pragma once

#include <string>
#include <vector>

#include "audit/audit.hpp"
#include "audit/ladder.hpp"
#include "cli/selection.hpp"

namespace rayaudit {

/// Reads the bounds of a file, or of standard input for `-`; loads the libraries whose subjects
/// rows name. Throws Error where it cannot be read, NothingAudited where it holds nobody to
/// anything, or a row of it names no audit there is.
std::vector<Bound> read_bounds_file(const std::string& path, Subjects& subjects);

/// The bound as it stands in a file.
std::string row(const Bound& bound);

/// The bounds in a file's columns, below comment lines: those of the head, and what a row is.
std::string write_bounds(const std::vector<Bound>& bounds, const std::vector<std::string>& head);

/// What is broken by whom, what was seen, and the command that shows it, in one sentence.
std::string told(const Broken& broken, const Convention& convention);
std::string told(const Break& broken, const Climb& climb, const Family& family);

}  // namespace rayaudit
