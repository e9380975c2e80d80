#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/report.hpp"

namespace rayaudit {

/// Part of a run, as its file has it: the plan, and what the cases of its chunks told, exactly.
struct Shard {
  std::string name;     ///< of its file
  std::string command;  ///< of the run, as if it had one shard
  Environment environment;
  Plan plan;
  std::vector<Tally> tallies;  ///< of planned(plan), in order
  std::string settings;        ///< all that shards of one run have in common
};

/// A shard of a run as a file: its audits are gathered(plan), not concluded.
std::string write_shard(const Run& run, const Look& look);

/// The subject of a name; null where there is none.
using SubjectNamed = std::function<const Subject*(const std::string& name)>;

/// Reads what write_shard wrote with the same version of the program. Throws Error where it is
/// something else, not whole or changed, and where a subject is not what it was.
Shard read_shard(std::string_view bytes, const std::string& name, const std::string& version,
                 const SubjectNamed& subject_named);

std::span<const ReportOf<Run>> shard_reports();

/// The shards of one run, put together one after the other, in any order.
class ShardSum {
 public:
  /// Throws Error where it is of another run, or there already.
  void add(const Shard& shard);
  /// Throws Error where one is missing.
  void require_all() const;

  /// The plan of the whole run.
  const Plan& plan() const { return plan_; }
  /// What all shards told; not concluded.
  std::vector<Audit>& audits() { return audits_; }
  const std::string& command() const { return command_; }
  /// Where the shards ran, each way of it that was found.
  const Environment& environment() const { return environment_; }

 private:
  std::vector<std::string> names_;  ///< by shard; empty where it is not there
  std::string first_name_, settings_, command_;
  Plan plan_;
  Environment environment_;
  std::vector<Audit> audits_;
};

}  // namespace rayaudit
