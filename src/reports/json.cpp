#include "reports/json.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "audit/drawn.hpp"
#include "audit/finding.hpp"
#include "geometry/signal_name.hpp"
#include "reports/explain_line.hpp"
#include "reports/report.hpp"

namespace rayaudit {
namespace {

using namespace json;

template <class E>
E nth(std::size_t i) {
  return static_cast<E>(i);
}

Json touches(const Tally& tally) {
  Json told = Json::object();
  for (std::size_t i = 0; i < tally.touches.size(); ++i)
    if (const auto& [taken, passed] = tally.touches[i]; taken + passed > 0)
      told[std::string(name(nth<oracle::Kind>(i)))] = {{"hit", taken}, {"miss", passed}};
  return told;
}

/// The counts that are not 0, by name; not those of the first, which says that there is nothing.
template <class E, std::size_t count>
Json counts(const std::array<std::uint64_t, count>& of) {
  Json told = Json::object();
  for (std::size_t i = 1; i < count; ++i)
    if (of[i] > 0) told[std::string(name(nth<E>(i)))] = of[i];
  return told;
}

Json claims(const Tally& tally) {
  Json told = Json::object();
  for (std::size_t i = 1; i < claim_count; ++i)
    if (const auto count = tally.of(nth<Claim>(i)); count > 0)
      told[std::string(name(nth<Claim>(i)))] = count;
  return told;
}

Json worst(const Tally& tally) {
  Json told = Json::object();
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (const Worst* worst = tally.worst(nth<Verdict>(i)); worst != nullptr)
      told[std::string(name(nth<Verdict>(i)))] = answered_line(*worst);
  if (tally.worst_forced) told["forced"] = answered_line(*tally.worst_forced);
  return told;
}

/// Errors that no rounding of case or answer excuses, and the case that has the largest.
Json own(const Audit& audit, const Convention& stated) {
  Json own = errors(audit.tally.own);
  if (const auto& worst = audit.tally.worst_own) {
    own["case"] = answered_line(*worst);
    own["explain"] = explain_line(*worst, *audit.subject, stated);
  }
  return own;
}

/// The wrong verdicts, each claim apart, with the worst case of each.
Json outcomes(const Audit& audit, const Convention& stated) {
  Json all = Json::array();
  for (const auto& [verdict, claim, count, worst, causes, beyond_rounding] : audit.tally.outcomes) {
    if (!is_wrong(verdict) || !worst) continue;
    all.push_back({{"verdict", name(verdict)},
                   {"claim", name(claim)},
                   {"count", count},
                   {"margin", number(worst->severity)},
                   {"cause", told(worst->diagnosis)},
                   {"case", answered_line(*worst)},
                   {"explain", explain_line(*worst, *audit.subject, stated)}});
    if (beyond_rounding > 0) all.back()["beyond_rounding"] = beyond_rounding;
  }
  return all;
}

Json share(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return nullptr;
  return static_cast<double>(part) / static_cast<double>(whole);
}

Json told(const CauseCount& found) {
  Json told = Json::object();
  for (std::size_t i = 0; i < cause_count; ++i)
    told[std::string(name(nth<Cause>(i)))] = found.counts[i];
  told["replayed"] = found.replayed();
  return told;
}

/// Of the wrong answers that were replayed; every touch is a convention, replayed or not.
Json causes(const Tally& tally) {
  Json counts = told(tally.causes());
  counts["convention"] = tally.of(Verdict::touch);
  return counts;
}

Json margin(const Tally& tally) {
  const Worst* widest = tally.widest();
  Json curve = Json::array();
  for (int exponent = MarginCurve::least; exponent <= MarginCurve::most; ++exponent)
    if (const auto& [cases, wrong] = tally.curve.at(exponent); cases > 0)
      curve.push_back({exponent, cases, wrong});
  return {{"largest_wrong", widest != nullptr ? number(widest->severity) : Json(nullptr)},
          {"case", widest != nullptr ? Json(answered_line(*widest)) : Json(nullptr)},
          {"curve", curve}};
}

Json bound(const Certificate& certificate) {
  const auto& [proved, observed] = std::tie(certificate.proved, certificate.observed);
  const auto ulps = [](const auto& worst) {
    return worst ? number(worst->severity) : Json(nullptr);
  };
  const auto line = [](const auto& worst) {
    return worst ? Json(answered_line(*worst)) : Json(nullptr);
  };
  const Histogram& looseness = certificate.looseness;
  return {{"proved_ulp", ulps(proved)},
          {"observed_ulp", ulps(observed)},
          {"looseness_p50", proved ? number(looseness.quantile(0.5)) : Json(nullptr)},
          {"proved_case", line(proved)},
          {"observed_case", line(observed)}};
}

Json told(const Convention& convention) {
  constexpr std::string_view stances[] = {"either", "hit", "miss"};
  constexpr std::string_view insides[] = {"hit", "miss", "start", "any"};
  Json told = Json::object();
  for (std::size_t i = 1; i < convention.stances.size(); ++i)
    told[std::string(name(nth<oracle::Kind>(i)))] =
        stances[static_cast<std::size_t>(convention.stances[i])];
  told["inside"] = insides[static_cast<std::size_t>(convention.inside)];
  told["direction"] = convention.unit_direction ? "unit" : "any";
  told["ray"] = convention.line ? "line" : convention.segment ? "segment" : "half";
  told["extent"] = convention.extent == Extent::bounded ? "bounded" : word(convention.extent);
  told["stand"] = word(convention.stand);
  told["opening"] = word(convention.opening);
  told["t_min"] = number(convention.t_min);
  told["t_max"] = number(convention.t_max);
  return told;
}

/// By subject, of those that declare anything.
Json declared(const std::vector<Audit>& audits) {
  Json all = Json::object();
  for (const Audit& audit : audits)
    if (audit.subject->convention != Convention{})
      all[audit.subject->name] = told(audit.subject->convention);
  return all;
}

Json told(const Audit& audit, const Plan& plan) {
  const Tally& tally = audit.tally;
  Json told = {{"subject", audit.subject->name},
               {"format", audit.subject->format.name},
               {"shape", shape_names[audit.shape]},
               {"family", audit.family->id},
               {"cases", tally.cases},
               {"unasked", tally.unasked},
               {"wrong", tally.wrong()}};
  // Where none of N is wrong, the share of wrong is below 3/N with 95 % confidence.
  told["wrong_below_95"] =
      tally.wrong() == 0 ? number(3 / static_cast<double>(tally.cases)) : Json(nullptr);
  for (std::size_t i = 0; i < verdict_count; ++i)
    told[std::string(name(nth<Verdict>(i)))] = tally.verdicts[i];
  told["claims"] = claims(tally);
  told["touches"] = touches(tally);
  for (std::size_t i = 0; i < oracle::stage_count; ++i)
    told["decided_by"][std::string(name(nth<oracle::Stage>(i)))] = tally.decided_by[i];
  told["ulp"] = errors(tally.ulps);
  told["forced"] = errors(tally.forced);
  told["own"] = own(audit, plan.convention);
  told["distance"] = errors(tally.distance);
  told["sides"] = counts<Side>(tally.sides);
  told["worst"] = worst(tally);
  told["outcomes"] = outcomes(audit, plan.convention);
  told["causes"] = causes(tally);
  told["margin"] = margin(tally);
  const Certificate& certificate = tally.certificate;
  told["certified"] = {{"share", share(certificate.certified, certificate.cases)},
                       {"cases", certificate.cases},
                       {"compared", certificate.compared},
                       {"wrong", certificate.wrong}};
  told["bound"] = bound(certificate);
  if (tally.stages != decltype(tally.stages){})
    told["stages"] = Json(std::vector(tally.stages.begin() + 1, tally.stages.end()));
  if (const auto cases = drawn(plan, audit)) told["drawn"] = fmt::format("{:016x}", *cases);
  return told;
}

Json families(const Finding& finding) {
  Json told = Json::array();
  for (const auto& [family, wrong, cases] : finding.families)
    told.push_back({{"family", family}, {"wrong", wrong}, {"cases", cases}});
  return told;
}

/// The minimal case of an example; null where none was looked for.
Json minimal(const Worst& example) {
  return example.minimal ? Json(answered_line(told_first(example))) : Json(nullptr);
}

Json told(const Finding& finding) {
  return {{"routine", finding.routine},
          {"shape", shape_names[finding.shape]},
          {"verdict", name(finding.verdict)},
          {"claim", name(finding.claim)},
          {"numbers", finding.numbers},
          {"families", families(finding)},
          {"wrong", finding.wrong},
          {"cases", finding.cases},
          {"share", finding.share},
          {"causes", told(finding.causes)},
          {"margin", number(finding.margin)},
          {"subject", finding.audit->subject->name},
          {"family", finding.audit->family->id},
          {"cause", told(told_first(finding.example).diagnosis)},
          {"minimal", minimal(finding.example)},
          {"example", answered_line(finding.example)},
          {"signal", finding.example.answer.signal != 0
                         ? Json(signal_name(finding.example.answer.signal))
                         : Json(nullptr)},
          {"reproducible", finding.example.repeats}};
}

/// Of how many of each chunk of cases more than the verdict was asked; all, in a thorough run.
Json shares(const Plan& plan) {
  if (plan.thorough) return "all";
  return {{"of", chunk_cases},
          {"margins_and_proofs", close_a_chunk},
          {"wrong_replayed", replays_a_chunk},
          {"margins_in_exact_numbers", slow_margins_a_chunk}};
}

}  // namespace

std::string write_json(const Run& run, const Look&) {
  const Plan& plan = run.plan;
  Json audits = Json::array(), found = Json::array();
  for (const Audit& audit : run.audits) audits.push_back(told(audit, plan));
  for (const Finding& finding : findings(run.audits)) found.push_back(told(finding));
  const Json report = {{"schema", 1},
                       {"report", "audit"},
                       {"tool", tool(run.version)},
                       {"seed", plan.seed},
                       {"cases", plan.cases},
                       {"difficulty", plan.difficulty ? Json(*plan.difficulty) : Json(nullptr)},
                       {"convention", told(plan.convention)},
                       {"declared", declared(run.audits)},
                       {"limits", {{"wrong_t", wrong_t_limit}}},
                       {"shares", shares(plan)},
                       {"environment", told(run.environment)},
                       {"audits", audits},
                       {"findings", found}};
  return written(report);
}

}  // namespace rayaudit
