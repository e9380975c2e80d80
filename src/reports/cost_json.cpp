#include "reports/json.hpp"
#include "reports/page.hpp"
#include "reports/report.hpp"
#include "reports/steps.hpp"

namespace rayaudit {
namespace {

using namespace json;

Json told(const Spread& spread) {
  return {number(spread.low), number(spread.median), number(spread.high)};
}

Json told(const Way& way) {
  const Accuracy& accuracy = way.accuracy;
  Json by_verdict = Json::object();
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (const auto verdict = static_cast<Verdict>(i); is_wrong(verdict))
      by_verdict[std::string(name(verdict))] = accuracy.per_million(verdict);
  return {{"subject", way.subject->name},
          {"format", way.subject->format.name},
          {"ns", told(way.nanoseconds)},
          {"timed", way.timed},
          {"cases", accuracy.cases},
          {"wrong", accuracy.wrong},
          {"wrong_per_million", 1e6 * accuracy.share()},
          {"per_million", by_verdict},
          {"wrong_margin", number(accuracy.wrong_margin)},
          {"max_ulp", number(accuracy.ulps)},
          {"max_forced", number(accuracy.forced)},
          {"error", number(accuracy.error)},
          {"front", way.on_front}};
}

Json told(const Cell& cell) {
  Json ways = Json::array(), steps = Json::array();
  for (const Way& way : cell.ways) ways.push_back(told(way));
  for (const Step& step : cell.steps())
    steps.push_back({{"from", step.from->subject->name},
                     {"to", step.to->subject->name},
                     {"times", told(step.times)},
                     {"text", rayaudit::told(step)}});
  return {{"shape", shape_names[cell.shape]},
          {"family", cell.family != nullptr ? Json(cell.family->id) : Json(nullptr)},
          {"group", name(cell.scope)},
          {"ways", ways},
          {"steps", steps}};
}

Json prices(const CostRun& run) {
  Json told_prices = Json::array();
  for (const std::size_t shape : run.plan.shapes)
    for (const auto& [easy, hard, times] : run.cost.prices(shape))
      told_prices.push_back({{"shape", shape_names[shape]},
                             {"subject", easy->subject->name},
                             {"easy", told(easy->nanoseconds)},
                             {"hard", told(hard->nanoseconds)},
                             {"times", told(times)}});
  return told_prices;
}

/// What could not be measured: what is not here, and what failed.
Json absent(const CostRun& run) {
  Json missing = Json::array();
  for (const auto& [subjects, why] : absent_subjects())
    missing.push_back({{"subjects", subjects}, {"why", why}});
  for (const auto& [subject, why] : run.cost.untimed)
    missing.push_back({{"subjects", subject->name}, {"why", why}});
  return missing;
}

Json document(const CostRun& run) {
  Json cells = Json::array();
  for (const Cell& cell : run.cost.cells) cells.push_back(told(cell));
  return {{"schema", 1},
          {"report", "cost"},
          {"tool", tool(run.version)},
          {"command", run.command},
          {"seed", run.plan.seed},
          {"cases", run.plan.cases},
          {"rounds", run.plan.rounds},
          {"timed_cases", std::min<std::uint64_t>(run.plan.cases, chunk_cases)},
          {"environment", json::told(run.environment)},
          {"absent", absent(run)},
          {"apart", apart},
          {"idle_ns", told(run.cost.idle)},
          {"cells", cells},
          {"prices", prices(run)}};
}

}  // namespace

std::string write_cost_json(const CostRun& run, const Look&) { return written(document(run)); }

std::string write_cost_html(const CostRun& run, const Look&) {
  return page("rayaudit cost", compact(shortened(document(run))));
}

}  // namespace rayaudit
