#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/fail_on.hpp"
#include "cli/report_order.hpp"
#include "reports/difference.hpp"
#include "reports/report.hpp"

namespace CLI {
class App;
}

namespace rayaudit {

/// What is to be done with audits that are over, wherever they were run.
struct AuditEnd {
  std::vector<std::string> reports, renamed;
  FailOn fail_on;
  std::string written_bounds;  ///< the file for what is observed, or empty
  std::string saved_cases;     ///< the file that minimal cases are added to, or empty
  std::string baseline;        ///< the json report that the run is held against, or empty
  std::string command;         ///< all of this as it was typed
  int headroom = 1;
  bool all_findings = false;
};

/// Adds the options that an audit and a merge have in common.
void add_audit_end(CLI::App& command, AuditEnd& end);

/// Those options; none of them says what is run.
const std::vector<std::string>& audit_end_options();

/// What an end needs, found to be there before anything is run.
struct ReadyEnd {
  const AuditEnd& asked;
  std::vector<ReportOrder> orders;
  std::optional<std::string> observed_to;  ///< empty: standard output
  std::optional<Record> baseline;
};

/// Throws Error where a report cannot be written, or a baseline is none for the plan.
ReadyEnd ready(const AuditEnd& end, const Plan& plan);

/// Writes what is asked for, and says on standard error what breaks a bound, --fail-on or the
/// baseline; the exit code.
int told(const ReadyEnd& end, const Run& run);

/// Throws NothingAudited where two reports have no audit in common.
void require_compared(const Difference& difference);

}  // namespace rayaudit
