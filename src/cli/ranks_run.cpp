#include "cli/ranks_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "cli/progress_lines.hpp"

namespace rayaudit {
namespace {

/// Puts together what each rank's shard has told.
ShardSum sum_over(Ranks& ranks, const Plan& plan, const std::vector<Audit>& audits,
                  const std::string& command) {
  const auto subject_named = [&](const std::string& name) -> const Subject* {
    const auto found = std::find_if(plan.subjects.begin(), plan.subjects.end(),
                                    [&](const Subject* each) { return each->name == name; });
    return found == plan.subjects.end() ? nullptr : *found;
  };
  std::string ours;
  ranks.apart([&] {
    ours = write_shard({RAYAUDIT_VERSION, plan, audits, environment(), command}, {});
  });
  ShardSum sum;
  ranks.gather(ours, [&](int rank, const std::string& bytes) {
    sum.add(read_shard(bytes, fmt::format("rank {}", rank), RAYAUDIT_VERSION, subject_named));
  });
  return sum;
}

}  // namespace

ShardSum gathered_by(Ranks& ranks, const Plan& plan, const std::string& command) {
  Plan shard = plan;
  shard.shard = static_cast<std::uint64_t>(ranks.rank());
  shard.shards = static_cast<std::uint64_t>(ranks.size());
  // That all run the same is to be known before, and not after hours.
  sum_over(ranks, shard, planned(shard), command);
  std::vector<Audit> audits;
  ranks.apart([&] {
    ProgressLines lines;
    const auto tell = [&](const Progress& progress) { lines.tell(progress); };
    audits = ranks.is_first() ? gathered(shard, tell) : gathered(shard);
  });
  return sum_over(ranks, shard, audits, command);
}

}  // namespace rayaudit
