#pragma once

#include <string>
#include <vector>

#include "audit/audit.hpp"

namespace rayaudit {

/// Throws Error where a file that cases are to be added to holds what is no case line, or is `-`. A
/// file that is not there is an empty one.
void require_case_file(const std::string& file);

/// Adds the minimal case of every finding to a file, each on a line with its truth and why it is
/// there; none that the file has already. The file is written whole or not at all, and by one
/// program at a time. Throws Error where it cannot be.
void save_cases(const std::string& file, const std::vector<Audit>& audits);

}  // namespace rayaudit
