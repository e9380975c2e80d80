#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/names.hpp"
#include "cli/output.hpp"
#include "reports/report.hpp"

namespace rayaudit {

/// A report that was asked for: `FORMAT=FILE`, or `FORMAT` for standard output.
struct ReportOrder {
  std::size_t report;  ///< its place in the list of reports
  std::string file;    ///< empty: standard output
};

/// Reads the orders; throws Error where a format is none of the names.
std::vector<ReportOrder> read_report_orders(const std::vector<std::string>& texts,
                                            std::span<const std::string_view> names);

/// Throws Error where two of the files are the same, or one cannot be written. An empty one is
/// standard output.
void require_places(const std::vector<std::string>& files);
void require_places(const std::vector<ReportOrder>& orders);

/// Writes it to its place: a file whole, or not at all.
void deliver(const std::string& file, const std::string& text);

/// The orders that texts name, of the reports in a list. Throws Error where one is not known or
/// cannot be had in this build.
template <class Made>
std::vector<ReportOrder> orders_of(const std::vector<std::string>& texts,
                                   std::span<const ReportOf<Made>> reports) {
  std::vector<ReportOrder> orders =
      read_report_orders(texts, names_of(reports, &ReportOf<Made>::name));
  for (const ReportOrder& order : orders) reports[order.report].require();
  return orders;
}

/// Writes the reports that go to standard output, or those that do not.
template <class Made>
void deliver(const std::vector<ReportOrder>& orders, std::span<const ReportOf<Made>> reports,
             const Made& made, Look look, bool to_stdout) {
  look.colour = to_stdout && is_colour_welcome();
  for (const auto& [report, file] : orders)
    if (file.empty() == to_stdout) deliver(file, reports[report].write(made, look));
}

}  // namespace rayaudit
