#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/audit.hpp"
#include "audit/cost.hpp"
#include "audit/environment.hpp"
#include "audit/ladder.hpp"
#include "audit/library_times.hpp"
#include "reports/breach.hpp"

namespace rayaudit {

/// A run that is over: all that its reports are written from. The audits are those of the plan, in
/// its order. Whatever the number of threads, the same run gives the same bytes.
struct Run {
  std::string version;  ///< of the program
  const Plan& plan;
  const std::vector<Audit>& audits;
  Environment environment;
  std::string command = {};  ///< as it was typed, where it was
  FailOn fail_on = {};       ///< what fails it besides bounds
  /// Of a run that is held beside the textbook; not the same from run to run.
  std::vector<TimeBeside> times = {};
};

/// A measurement that is over: what every way to answer costs.
struct CostRun {
  std::string version;
  const CostPlan& plan;
  const Cost& cost;
  Environment environment;
  std::string command = {};
};

/// A ladder that was climbed.
struct LadderRun {
  std::string version;
  const LadderPlan& plan;
  const std::vector<Climb>& climbs;
  Environment environment;
  std::string command = {};
};

/// How the report for people is to look; the others pay no heed to it.
struct Look {
  bool colour = false;      ///< with ANSI escape codes
  bool everything = false;  ///< not only the worst findings, not only the ways on the front
  bool families = false;    ///< of costs: each family alone too
};

std::string write_table(const Run& run, const Look& look);
std::string write_library_table(const Run& run, const Look& look);
std::string write_json(const Run& run, const Look& look);
std::string write_csv(const Run& run, const Look& look);
std::string write_cost_table(const CostRun& run, const Look& look);
std::string write_cost_json(const CostRun& run, const Look& look);
std::string write_cost_html(const CostRun& run, const Look& look);
std::string write_ladder_table(const LadderRun& run, const Look& look);
std::string write_ladder_json(const LadderRun& run, const Look& look);
std::string write_ladder_html(const LadderRun& run, const Look& look);
std::string write_html(const Run& run, const Look& look);
std::string write_junit(const Run& run, const Look& look);
std::string write_markdown(const Run& run, const Look& look);

/// A format that something made is written down in; whole, with the end of its last line.
template <class Made>
struct ReportOf {
  std::string_view name, about;
  std::string (*write)(const Made& made, const Look& look);
  /// Throws Error where this build cannot write it.
  void (*require)() = [] {};
};

/// Every report there is. A new one is a function and a row in its list.
std::span<const ReportOf<Run>> reports();
std::span<const ReportOf<CostRun>> cost_reports();
std::span<const ReportOf<LadderRun>> ladder_reports();

}  // namespace rayaudit
