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

/// Reads the orders; throws Error where a format is not known, two go to the same place, or a file
/// cannot be written.
std::vector<ReportOrder> read_report_orders(const std::vector<std::string>& texts);

/// Writes it to its place: a file whole, or not at all.
void deliver(const ReportOrder& order, const std::string& text);

}  // namespace rayaudit
