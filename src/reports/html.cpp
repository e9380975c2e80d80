#include <algorithm>
#include <map>

#include "audit/along.hpp"
#include "audit/finding.hpp"
#include "reports/declared.hpp"
#include "reports/explain_line.hpp"
#include "reports/findings.hpp"
#include "reports/json.hpp"
#include "reports/page.hpp"
#include "reports/report.hpp"

namespace rayaudit {
namespace {

using namespace json;

/// Names, each once, in the order of their coming; told by their places.
class Names {
 public:
  std::size_t place(std::string_view name) {
    const auto [known, is_new] = places_.try_emplace(std::string(name), places_.size());
    if (is_new) names_.push_back(known->first);
    return known->second;
  }
  const std::vector<std::string>& all() const { return names_; }

 private:
  std::map<std::string, std::size_t, std::less<>> places_;
  std::vector<std::string> names_;
};

/// All that a page tells by place: it names them once.
class Page {
 public:
  Json told(const Run& run);

 private:
  Json told(const Audit& audit);
  Json told(const Outcome& outcome);
  Json told(const Finding& finding);
  std::size_t line(const Worst& worst);
  std::size_t family(const Family& family);
  std::size_t subject(const Subject& subject);

  Names subjects_, families_, lines_;
  Json subject_list_ = Json::array(), family_list_ = Json::array(), line_list_ = Json::array();
};

std::size_t Page::line(const Worst& worst) {
  const std::string line = answered_line(worst);
  const std::size_t place = lines_.place(line);
  if (place < line_list_.size()) return place;
  Json roots = Json::array();
  for (const Along& root : along(worst.question)) {
    roots.push_back({root.kind, number(root.t)});
    if (root.t_last != root.t) roots.back().push_back(number(root.t_last));
  }
  line_list_.push_back({line, roots});
  return place;
}

std::size_t Page::family(const Family& family) {
  const std::size_t place = families_.place(family.id);
  if (place == family_list_.size())
    family_list_.push_back({{"id", family.id}, {"about", family.about}});
  return place;
}

std::size_t Page::subject(const Subject& subject) {
  const std::size_t place = subjects_.place(subject.name);
  if (place == subject_list_.size())
    subject_list_.push_back({{"name", subject.name},
                             {"format", subject.format.name},
                             {"declares", declared(subject.convention)},
                             {"brought_by", subject.brought_by}});
  return place;
}

/// Median, 99th percentile and maximum; null where nothing was measured.
Json quantiles(const Histogram& errors) {
  if (errors.count() == 0) return nullptr;
  return {magnitude(errors.quantile(0.5)), magnitude(errors.quantile(0.99)),
          magnitude(errors.largest())};
}

/// The exponent of the first octave, then the counts up to the last that has any.
Json octaves(const Histogram& errors) {
  Json told = Json::array();
  int zeros = 0;
  for (int exponent = Histogram::least_octave; exponent <= Histogram::most_octave; ++exponent) {
    const std::uint64_t count = errors.octave(exponent);
    if (count == 0) {
      ++zeros;
      continue;
    }
    if (told.empty()) {
      told.push_back(exponent);
      zeros = 0;
    }
    for (; zeros > 0; --zeros) told.push_back(0);
    told.push_back(count);
  }
  return told;
}

/// Exponent, cases and wrong ones of every step that has cases, one after the other.
Json curve(const MarginCurve& curve) {
  Json told = Json::array();
  for (int exponent = MarginCurve::least; exponent <= MarginCurve::most; ++exponent)
    if (const auto& [cases, wrong] = curve.at(exponent); cases > 0)
      for (const std::uint64_t count : {cases, wrong}) {
        if (told.size() % 3 == 0) told.push_back(exponent);
        told.push_back(count);
      }
  return told;
}

/// Verdict, claim, count, largest margin, the worst case and its cause.
Json Page::told(const Outcome& outcome) {
  const Worst& worst = *outcome.worst;
  return {outcome.verdict,           outcome.claim, outcome.count,
          magnitude(worst.severity), line(worst),   rayaudit::told(worst.diagnosis)};
}

Json Page::told(const Audit& audit) {
  const Tally& tally = audit.tally;
  Json outcomes = Json::array();
  for (const Outcome& outcome : tally.outcomes)
    if (is_wrong(outcome.verdict) && outcome.worst) outcomes.push_back(told(outcome));
  const Worst* widest = tally.widest();
  return {{"subject", subject(*audit.subject)},
          {"family", family(*audit.family)},
          {"shape", audit.shape},
          {"cases", tally.cases},
          {"verdicts", tally.verdicts},
          {"ulp", quantiles(tally.ulps)},
          {"forced", quantiles(tally.forced)},
          {"margin", widest != nullptr ? magnitude(widest->severity) : Json(nullptr)},
          {"curve", curve(tally.curve)},
          {"ulps", octaves(tally.ulps)},
          {"outcomes", outcomes},
          {"largest", tally.worst_ulps ? Json(line(*tally.worst_ulps)) : Json(nullptr)}};
}

/// The cause that accounts for most, in words.
std::string main_cause(const Finding& finding) {
  const auto most = std::max_element(finding.by_cause.begin(), finding.by_cause.end());
  const auto cause = static_cast<Cause>(most - finding.by_cause.begin());
  return finding.example.diagnosis.cause == cause ? rayaudit::told(finding.example.diagnosis)
                                                  : std::string(name(cause));
}

Json Page::told(const Finding& finding) {
  Json afflicted = Json::array();
  for (const Afflicted& each : finding.families)
    afflicted.push_back({families_.place(each.family), each.wrong, each.cases});
  return {{"routine", finding.routine},
          {"shape", finding.shape},
          {"verdict", finding.verdict},
          {"claim", finding.claim},
          {"numbers", finding.numbers},
          {"families", afflicted},
          {"wrong", finding.wrong},
          {"cases", finding.cases},
          {"margin", magnitude(finding.margin)},
          {"cause", main_cause(finding)},
          {"subject", subject(*finding.audit->subject)},
          {"family", family(*finding.audit->family)}};
}

/// The kinds of touch of which something is declared.
Json spelled(const Convention& convention) {
  Json told = Json::object();
  for (std::size_t kind = 1; kind < convention.stances.size(); ++kind)
    if (const auto stance = convention.stances[kind]; stance != Convention::Stance::either)
      told[std::string(name(static_cast<oracle::Kind>(kind)))] =
          stance == Convention::Stance::hit ? "hit" : "miss";
  return told;
}

/// What tell(i) says of each of a number of enumerators.
template <class E, class Tell>
Json words(std::size_t count, const Tell& tell) {
  Json all = Json::array();
  for (std::size_t i = 0; i < count; ++i) all.push_back(tell(static_cast<E>(i)));
  return all;
}

/// The places of the verdicts that count as wrong answers.
Json wrong_verdicts() {
  Json places = Json::array();
  for (std::size_t i = 0; i < verdict_count; ++i)
    if (is_wrong(static_cast<Verdict>(i))) places.push_back(i);
  return places;
}

Json Page::told(const Run& run) {
  const Plan& plan = run.plan;
  Json audits = Json::array(), findings = Json::array();
  for (const Audit& audit : run.audits) audits.push_back(told(audit));
  for (const Finding& finding : rayaudit::findings(run.audits)) findings.push_back(told(finding));
  return {
      {"schema", 1},
      {"report", "audit"},
      {"tool", tool(run.version)},
      {"command", run.command},
      {"seed", plan.seed},
      {"cases", plan.cases},
      {"difficulty", plan.difficulty ? Json(*plan.difficulty) : Json(nullptr)},
      {"convention", spelled(plan.convention)},
      {"environment", json::told(run.environment)},
      {"subjects", subject_list_},
      {"families", family_list_},
      {"shapes", shape_names},
      {"verdicts", words<Verdict>(verdict_count, [](Verdict each) { return name(each); })},
      {"wrong_verdicts", wrong_verdicts()},
      {"verdict_words", words<Verdict>(verdict_count, [](Verdict each) { return sentence(each); })},
      {"claim_words", words<Claim>(claim_count, [](Claim each) { return sentence(each); })},
      {"lines", line_list_},
      {"audits", audits},
      {"findings", findings}};
}

}  // namespace

std::string write_html(const Run& run, const Look&) {
  return page("rayaudit audit", compact(Page().told(run)));
}

}  // namespace rayaudit
