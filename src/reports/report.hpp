#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/audit.hpp"
#include "audit/environment.hpp"

namespace rayaudit {

/// A run that is over: all that its reports are written from. The audits are those of the plan, in
/// its order. Whatever the number of threads, the same run gives the same bytes.
struct Run {
  std::string version;  ///< of the program
  const Plan& plan;
  const std::vector<Audit>& audits;
  Environment environment;
};

/// How the report for people is to look; the others pay no heed to it.
struct Look {
  bool colour = false;        ///< with ANSI escape codes
  bool all_findings = false;  ///< not only the worst of them
};

std::string write_table(const Run& run, const Look& look);
std::string write_json(const Run& run, const Look& look);
std::string write_csv(const Run& run, const Look& look);

/// A format that findings are written down in; whole, with the end of its last line.
struct Report {
  std::string_view name, about;
  std::string (*write)(const Run& run, const Look& look);
};

/// Every report there is. A new one is a function and a row in this list.
std::span<const Report> reports();

}  // namespace rayaudit
