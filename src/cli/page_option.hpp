#pragma once

#include <string>

#include "reports/report.hpp"

namespace rayaudit {

/// Throws Error where the folder cannot be made, or not be written to.
void require_page_folder(const std::string& folder);

/// Writes the page of findings and their programs to a folder: README.md, times.md, programs/*,
/// trackers/*, where what was in those before is gone. Only what was confirmed is on it: each
/// program is built and run, and must say what the audit saw. Which could not be confirmed, and
/// why, is told on standard error, in a sentence each.
void write_page_folder(const std::string& folder, const Run& run);

}  // namespace rayaudit
