#include "cli/shard_option.hpp"

#include "cli/exit_code.hpp"
#include "cli/progress_bar.hpp"
#include "cli/whole_number.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "reports/shard.hpp"

namespace rayaudit {
namespace {

/// Throws Error unless the one thing asked for is a shard.
void require_shard_alone(const AuditEnd& end) {
  const auto refuse = [](bool asked, const std::string& option) {
    if (asked) throw Error(option + " needs the cases of all shards: give it to `rayaudit merge`");
  };
  refuse(end.fail_on.asks_anything(), "--fail-on");
  refuse(!end.written_bounds.empty(), "--write-bounds");
  refuse(!end.baseline.empty(), "--baseline");
  refuse(!end.saved_cases.empty(), "--save-cases");
  for (const std::string& report : end.reports)
    refuse(report != "shard" && !report.starts_with("shard="), "--report " + report);
  if (end.reports.size() != 1)
    throw Error("--shard needs one --report shard=FILE, for `rayaudit merge`");
}

}  // namespace

ShardOfRun read_shard_of_run(std::string_view text) {
  constexpr std::int64_t most_shards = 100'000;
  const std::size_t slash = text.find('/');
  if (slash == text.npos)
    throw Error("--shard: expected i/n, as 1/3 for the first of three, got " + quotation(text));
  const std::int64_t shards = whole_number("--shard", text.substr(slash + 1), 1, most_shards);
  const std::int64_t shard = whole_number("--shard", text.substr(0, slash), 1, shards);
  return {static_cast<std::uint64_t>(shard - 1), static_cast<std::uint64_t>(shards)};
}

int run_shard(const Plan& plan, const AuditEnd& end, const std::string& command) {
  require_shard_alone(end);
  const std::vector<ReportOrder> orders = orders_of(end.reports, shard_reports());
  require_places(orders);
  ProgressBar bar;
  const std::vector<Audit> audits =
      gathered(plan, [&](const Progress& progress) { bar.tell(progress); });
  const Run run = {RAYAUDIT_VERSION, plan, audits, environment(), command};
  for (const bool to_stdout : {false, true}) deliver(orders, shard_reports(), run, {}, to_stdout);
  return all_held;
}

}  // namespace rayaudit
