#include "reports/explain_line.hpp"
#include "reports/json.hpp"
#include "reports/page.hpp"
#include "reports/promise.hpp"
#include "reports/report.hpp"

namespace rayaudit {
namespace {

using namespace json;

Json told(const Errors& errors) {
  return {{"p50", number(errors.half)}, {"p99", number(errors.most)}, {"max", number(errors.all)}};
}

Json margin(const std::optional<int>& exponent) {
  return exponent ? Json(std::ldexp(1.0, *exponent)) : Json(nullptr);
}

Json told(const Rung& rung) {
  return {{"k", rung.k},
          {"cases", rung.cases},
          {"wrong", rung.wrong},
          {"ulp", told(rung.ulps)},
          {"forced", told(rung.forced)},
          {"own", told(rung.own)},
          {"condition", told(rung.condition)},
          {"margin", {{"p10", margin(rung.narrow_margin)}, {"p50", margin(rung.half_margin)}}}};
}

Json told(const std::optional<Break>& broken) {
  if (!broken) return nullptr;
  return {{"k", broken->k},
          {"limit", broken->limit.quantity->name},
          {"seen", number(broken->seen)},
          {"most", number(broken->limit.most)},
          {"case", broken->worst ? Json(answered_line(*broken->worst)) : Json()}};
}

Json told(const Climb& climb) {
  Json rungs = Json::array();
  for (const Rung& rung : climb.rungs) rungs.push_back(told(rung));
  const std::optional<int> holds_to = climb.holds_to();
  return {{"subject", climb.subject->name},
          {"format", climb.subject->format.name},
          {"shape", shape_names[climb.shape]},
          {"held_to", promises(climb.held_to)},
          {"least", climb.rungs.front().k},
          {"most", climb.rungs.back().k},
          {"holds_to", holds_to ? Json(*holds_to) : Json(nullptr)},
          {"broken", told(climb.broken)},
          {"slope",
           {{"ulp", number(climb.slopes.ulps)},
            {"own", number(climb.slopes.own)},
            {"condition", number(climb.slopes.condition)}}},
          {"rungs", rungs}};
}

Json document(const LadderRun& run) {
  const Family& family = *run.plan.family;
  Json climbs = Json::array();
  for (const Climb& climb : run.climbs) climbs.push_back(told(climb));
  return {{"schema", 1},
          {"report", "ladder"},
          {"tool", tool(run.version)},
          {"command", run.command},
          {"seed", run.plan.seed},
          {"cases", run.plan.cases},
          {"environment", json::told(run.environment)},
          {"family",
           {{"id", family.id}, {"about", family.about}, {"difficulty", family.difficulty->about}}},
          {"climbs", climbs}};
}

}  // namespace

std::string write_ladder_json(const LadderRun& run, const Look&) { return written(document(run)); }

std::string write_ladder_html(const LadderRun& run, const Look&) {
  return page("rayaudit ladder of " + std::string(run.plan.family->id),
              compact(shortened(document(run))));
}

}  // namespace rayaudit
