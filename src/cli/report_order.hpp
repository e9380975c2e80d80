#pragma once

#include <string>
#include <vector>

#include "reports/report.hpp"

namespace rayaudit {

/// A report that was asked for: `FORMAT=FILE`, or `FORMAT` for standard output.
struct ReportOrder {
  const Report* report;
  std::string file;  ///< empty: standard output
};

/// Reads the orders; throws Error where a format is not known.
std::vector<ReportOrder> read_report_orders(const std::vector<std::string>& texts);

/// Throws Error where two of the files are the same, or one cannot be written. An empty one is
/// standard output.
void require_places(const std::vector<std::string>& files);

/// Writes it to its place: a file whole, or not at all.
void deliver(const std::string& file, const std::string& text);

}  // namespace rayaudit
