#include <nlohmann/json.hpp>

#include "geometry/case_line.hpp"
#include "reports/explain_line.hpp"
#include "reports/json.hpp"
#include "reports/scene_run.hpp"
#include "reports/scene_words.hpp"

namespace rayaudit {
namespace {

using namespace json;

Json told(const std::optional<Case>& question) {
  return question ? Json(case_line(*question)) : Json(nullptr);
}

/// How often, how bad, and the case that shows it worst, with the command for that.
Json told(const Trouble& trouble, const Subject& subject) {
  Json all = {{"count", trouble.count},
              {"largest", trouble.count > 0 ? number(trouble.severity) : Json(nullptr)},
              {"case", told(trouble.example)}};
  if (trouble.example) all["explain"] = scenes::explain_line(*trouble.example, subject);
  return all;
}

Json told(const Worst& worst, const Subject& subject) {
  return {{"margin", number(worst.severity)},
          {"cause", rayaudit::told(worst.diagnosis)},
          {"case", answered_line(worst)},
          {"explain", explain_line(worst, subject)}};
}

/// The wrong verdicts, each claim apart, with the worst case of each.
Json outcomes(const Tally& tally, const Subject& subject) {
  Json all = Json::array();
  for (const Outcome& outcome : tally.outcomes)
    if (is_wrong(outcome.verdict) && outcome.worst) {
      Json each = {{"verdict", name(outcome.verdict)},
                   {"claim", name(outcome.claim)},
                   {"count", outcome.count}};
      each.update(told(*outcome.worst, subject));
      all.push_back(std::move(each));
    }
  return all;
}

/// The worst of errors that are no matter of a verdict, where there are any.
Json largest_error(const std::optional<Worst>& worst, const Subject& subject) {
  if (!worst) return nullptr;
  return {{"error", number(worst->severity)},
          {"case", answered_line(*worst)},
          {"explain", explain_line(*worst, subject)}};
}

/// The counts that are not 0, by side; not of those that are unknown.
Json sides(const Tally& tally) {
  Json all = Json::object();
  for (std::size_t i = 1; i < side_count; ++i)
    if (tally.sides[i] > 0) all[std::string(name(static_cast<Side>(i)))] = tally.sides[i];
  return all;
}

/// Exponent of the margin, cases, wrong ones.
Json curve(const MarginCurve& curve) {
  Json all = Json::array();
  for (int exponent = MarginCurve::least; exponent <= MarginCurve::most; ++exponent)
    if (const auto& [cases, wrong] = curve.at(exponent); cases > 0)
      all.push_back({exponent, cases, wrong});
  return all;
}

Json told(const WaveAccount& wave, const Subject& subject) {
  const Tally& tally = wave.tally;
  Json all = {{"effect", name(wave.effect)},
              {"bounce", wave.bounce},
              {"rays", wave.rays},
              {"questions", wave.questions},
              {"wrong", tally.wrong()}};
  for (std::size_t i = 0; i < verdict_count; ++i)
    all[std::string(name(static_cast<Verdict>(i)))] = tally.verdicts[i];
  const Worst* widest = tally.widest();
  all["largest_margin"] = widest != nullptr ? number(widest->severity) : Json(nullptr);
  all["ulp"] = errors(tally.ulps);
  all["forced"] = errors(tally.forced);
  all["own"] = errors(tally.own);
  all["distance"] = errors(tally.distance);
  all["sides"] = sides(tally);
  all["margin_curve"] = curve(tally.curve);
  all["worst_ulp"] = largest_error(tally.worst_ulps, subject);
  all["worst_forced"] = largest_error(tally.worst_forced, subject);
  all["self_intersections"] = told(wave.self_intersections, subject);
  all["leaks"] = told(wave.leaks, subject);
  all["outcomes"] = outcomes(tally, subject);
  return all;
}

Json told(const OffsetAccount& account, const Subject& subject) {
  return {{"offset", account.offset.name},
          {"rays", account.rays},
          {"acne", told(account.acne, subject)},
          {"lost_contact", told(account.lost_contact, subject)}};
}

Json told(const SafeOffset& safe) {
  return {{"t_min", number(safe.t_min)},
          {"t_min_case", told(safe.t_min_case)},
          {"ulps", number(safe.ulps)},
          {"ulps_case", told(safe.ulps_case)},
          {"nearest_contact", number(safe.contact)},
          {"nearest_contact_case", told(safe.contact_case)}};
}

Json told(const scenes::EffectUse& use) {
  const Calling& calling = *use.calling;
  const bool has_place = calling.is_on && !calling.place.file.empty();
  return {{"effect", name(calling.effect)},
          {"called", calling.is_on},
          {"on", use.is_on},
          {"place", has_place ? Json(rayaudit::told(calling.place)) : Json(nullptr)},
          {"because", calling.because},
          {"rays", use.rays}};
}

Json told(const scenes::Finding& finding, const Subject& subject) {
  Json effects = Json::object();
  for (const auto& [effect, count] : finding.parts) effects[std::string(name(effect))] = count;
  Json all = {{"verdict", name(finding.verdict)},
              {"claim", name(finding.claim)},
              {"count", finding.count},
              {"effects", effects},
              {"shape", name(finding.worst->question.shape)}};
  all.update(told(*finding.worst, subject));
  return all;
}

Json told(const Scene& scene) {
  Json skipped = Json::array();
  for (const Skipped& each : scene.skipped)
    skipped.push_back({{"place", rayaudit::told(each.place)}, {"what", each.what}});
  return {{"name", scene.name},
          {"width", scene.film.width},
          {"height", scene.film.height},
          {"samples", scene.samples},
          {"bounces", scene.bounces},
          {"shapes", scene.primitives.size()},
          {"lights", scene.lights.size()},
          {"seams", scene.seams.size()},
          {"skipped", skipped}};
}

template <class List>
Json list(const List& of, const Subject& subject) {
  Json all = Json::array();
  for (const auto& each : of) all.push_back(told(each, subject));
  return all;
}

/// What the audit of a picture tells; null of one that was not audited.
Json audit(const SceneRun& run) {
  if (!run.plan.audited) return nullptr;
  const SceneAccount& account = run.picture.account;
  const Subject& subject = run.plan.subject;
  const Culling& culling = account.culling;
  return {{"thorough", run.plan.thorough},
          {"waves", list(account.waves, subject)},
          {"findings", list(scenes::findings(account), subject)},
          {"offsets", list(account.offsets, subject)},
          {"safe_offset", told(account.safe)},
          {"culling",
           {{"asked", culling.asked},
            {"settled", culling.settled},
            {"wrong", told(culling.wrong, subject)}}}};
}

Json effects(const SceneRun& run) {
  Json all = Json::array();
  for (const scenes::EffectUse& use : scenes::uses(run)) all.push_back(told(use));
  return all;
}

Json files(const SceneRun& run) {
  const auto file = [](const std::string& name) {
    return name.empty() ? Json(nullptr) : Json(name);
  };
  return {{"picture", file(run.picture_file)},
          {"exact", file(run.exact_file)},
          {"difference", file(run.difference_file)},
          {"verdicts", file(run.verdict_file)}};
}

}  // namespace

std::string write_scene_json(const SceneRun& run, const Look&) {
  const PicturePlan& plan = run.plan;
  const Subject& subject = plan.subject;
  const bool has_moved = !run.moved_shape.empty();
  return written({{"schema", 1},
                  {"report", "scene"},
                  {"tool", tool(run.version)},
                  {"scene", told(plan.scene)},
                  {"subject", {{"name", subject.name}, {"format", subject.format.name}}},
                  {"offset", plan.offset.name},
                  {"seed", plan.seed},
                  {"limits", {{"wrong_t", wrong_t_limit}}},
                  {"environment", told(run.environment)},
                  {"whole", run.picture.whole},
                  {"rounding",
                   {{"most_moved", number(run.most_moved)},
                    {"shape", has_moved ? Json(run.moved_shape) : Json(nullptr)}}},
                  {"effects", effects(run)},
                  {"files", files(run)},
                  {"audit", audit(run)}});
}

}  // namespace rayaudit
