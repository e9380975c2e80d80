#pragma once

#include <string_view>

#include "audit/audit.hpp"
#include "cli/audit_end.hpp"

namespace rayaudit {

/// Part of a run: the i-th of n, from 0.
struct ShardOfRun {
  std::uint64_t shard, shards;
};

/// Reads `i/n`, i from 1 to n; throws Error where it is none.
ShardOfRun read_shard_of_run(std::string_view text);

/// Runs the plan's shard and writes it to the one place that is asked for. Throws Error where
/// something is asked for that needs all shards.
int run_shard(const Plan& plan, const AuditEnd& end, const std::string& command);

}  // namespace rayaudit
