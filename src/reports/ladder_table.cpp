#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/ink.hpp"
#include "reports/promise.hpp"
#include "reports/report.hpp"
#include "reports/surroundings.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;
using figures::percent;

/// So many difficulties have a column.
constexpr std::size_t most_columns = 9;

std::string title(const LadderRun& run) {
  const Family& family = *run.plan.family;
  return wrapped(
      fmt::format("rayaudit {}: ladder of {} ({}), k: {}; {} cases for each subject, shape and k; "
                  "seed {}",
                  run.version, family.id, family.about, family.difficulty->about,
                  grouped(run.plan.cases), run.plan.seed),
      0);
}

std::string legend(const LadderRun& run) {
  std::set<std::string> held_to;
  for (const Climb& climb : run.climbs) held_to.insert(promises(climb.held_to));
  const std::string bound =
      held_to.size() == 1 ? *held_to.begin() : "the rows of the bounds that are about it";
  return wrapped(
      fmt::format(
          "Each k: the largest error of the subject's own, in units of the larger of an ulp and of "
          "what rounding the numbers of the case once would do to t (a stable routine stays flat); "
          "and below, where any are, the per cent of wrong answers. Case: that forced error in "
          "ulps, in half of the hits, and the margin of half of the cases in u, both of the case "
          "and not of any routine. Holds to: the last k up to which the subject keeps {}. Slopes: "
          "powers of two a step by which rise the error in ulps of half of the hits, the error of "
          "its own of 99 in 100, and the forced error in ulps of half: where the first follows the "
          "last, the case is to blame.",
          bound),
      0);
}

/// The difficulties with a column: the ends and some evenly between, of those that there are.
std::vector<int> columns(const std::vector<const Climb*>& climbs) {
  std::set<int> all;
  for (const Climb* climb : climbs)
    for (const Rung& rung : climb->rungs) all.insert(rung.k);
  const std::vector<int> rungs(all.begin(), all.end());
  std::set<int> chosen;
  for (std::size_t i = 0; i < most_columns; ++i)
    chosen.insert(rungs[i * (rungs.size() - 1) / (most_columns - 1)]);
  // Each format ends at a k of its own: in place of the column next to it.
  for (const Climb* climb : climbs) {
    const int last = climb->rungs.back().k;
    if (chosen.contains(last)) continue;
    const auto before = std::prev(chosen.upper_bound(last));
    if (before != chosen.begin()) chosen.erase(before);
    chosen.insert(last);
  }
  return {chosen.begin(), chosen.end()};
}

const Rung* rung_at(const Climb& climb, int k) {
  const auto found = std::ranges::find(climb.rungs, k, &Rung::k);
  return found == climb.rungs.end() ? nullptr : &*found;
}

/// A cell for each column, of the rungs that the climb has there.
template <class Text>
std::string cells(const Climb& climb, const std::vector<int>& columns, const Text& text) {
  std::string row;
  for (const int k : columns) {
    const Rung* rung = rung_at(climb, k);
    row += fmt::format("{:>7}", rung == nullptr ? "" : text(*rung));
  }
  return row + '\n';
}

std::string slope(double x) {
  // Rounded first, so that there is no -0.00.
  return std::isnan(x) ? "-" : fmt::format("{:.2f}", std::round(100 * x) / 100 + 0.0);
}

std::string holds(const Climb& climb, const Ink& ink) {
  const std::optional<int> last = climb.holds_to();
  if (!climb.broken) return ink.good(fmt::format("{:>7}", fmt::format("all {}", *last)));
  return ink.bad(fmt::format("{:>7}", last ? std::to_string(*last) : "none"));
}

std::string rows(const Climb& climb, const std::vector<int>& columns, const Ink& ink) {
  const auto& [ulps, own, condition] = climb.slopes;
  std::string text = fmt::format("  {:<28.28}{}{:>7}{:>6}{:>6} ", climb.subject->name,
                                 holds(climb, ink), slope(ulps), slope(own), slope(condition));
  text += cells(climb, columns, [](const Rung& rung) { return magnitude(rung.own.all); });
  if (std::ranges::all_of(climb.rungs, [](const Rung& rung) { return rung.wrong == 0; }))
    return text;
  return text + fmt::format("{:<57}", fmt::format("{:>55}", "% wrong")) +
         cells(climb, columns, [](const Rung& rung) { return percent(rung.wrong, rung.cases); });
}

/// What the cases themselves are like in one format: the same for every subject that hits.
std::string case_rows(const std::vector<const Climb*>& climbs, const Format& format,
                      const std::vector<int>& columns, const Ink& ink) {
  const auto hits = [](const Climb* climb) {
    return std::ranges::count_if(climb->rungs,
                                 [](const Rung& rung) { return !std::isnan(rung.condition.half); });
  };
  const Climb* fullest = nullptr;
  for (const Climb* climb : climbs)
    if (climb->subject->format == format && (fullest == nullptr || hits(climb) > hits(fullest)))
      fullest = climb;
  if (fullest == nullptr) return "";
  const std::string name = fmt::format("  case in {}, ", format.name);
  return ink.faint(fmt::format("{:<57}", name + "forced error in ulps") +
                   cells(*fullest, columns,
                         [](const Rung& rung) { return magnitude(rung.condition.half); })) +
         ink.faint(fmt::format("{:<57}", name + "margin in u") +
                   cells(*fullest, columns, [](const Rung& rung) {
                     return rung.half_margin ? fmt::format("2^{}", *rung.half_margin) : "-";
                   }));
}

std::string table(const std::vector<const Climb*>& climbs, const Ink& ink) {
  const std::vector<int> chosen = columns(climbs);
  std::string heading = fmt::format("{:<30}{:>7}{:>7}{:>6}{:>6} ", shape_names[climbs[0]->shape],
                                    "holds", "ulp", "own", "case");
  for (const int k : chosen) heading += fmt::format("{:>7}", fmt::format("k={}", k));
  std::string text = ink.heading(heading) + '\n';
  for (const Climb* climb : climbs) text += rows(*climb, chosen, ink);
  std::vector<Format> formats;
  for (const Climb* climb : climbs)
    if (const Format& format = climb->subject->format; std::ranges::count(formats, format) == 0)
      formats.push_back(format);
  for (const Format& format : formats) text += case_rows(climbs, format, chosen, ink);
  return text + '\n';
}

/// The first break of each subject, with the command that shows it.
std::string breaks(const LadderRun& run, const Ink& ink) {
  std::string text;
  for (const Climb& climb : run.climbs)
    if (climb.broken)
      text += wrapped(
          fmt::format(
              "{} on {} at k = {}: {} is {}, more than {}{}", climb.subject->name,
              shape_names[climb.shape], climb.broken->k, climb.broken->limit.quantity->name,
              magnitude(climb.broken->seen), promise(climb.broken->limit.most),
              climb.broken->worst ? ": " + explain_line(*climb.broken->worst, *climb.subject) : ""),
          2);
  return text.empty() ? "" : ink.heading("Where they break first") + '\n' + text + '\n';
}

std::string summary(const LadderRun& run, const Ink& ink) {
  const auto held =
      std::ranges::count_if(run.climbs, [](const Climb& climb) { return !climb.broken; });
  const bool all = held == static_cast<std::ptrdiff_t>(run.climbs.size());
  const std::string text =
      fmt::format("{} of {} climbs hold to the last k of their format", held, run.climbs.size());
  return (all ? ink.good(text) : ink.bad(text)) + '\n';
}

}  // namespace

std::string write_ladder_table(const LadderRun& run, const Look& look) {
  const Ink ink = {look.colour};
  std::string text = title(run) + '\n' + legend(run) + '\n';
  for (const std::size_t shape : run.plan.shapes) {
    std::vector<const Climb*> climbs;
    for (const Climb& climb : run.climbs)
      if (climb.shape == shape) climbs.push_back(&climb);
    if (!climbs.empty()) text += table(climbs, ink);
  }
  if (look.everything) text += breaks(run, ink);
  return text + surroundings(run.environment) + summary(run, ink);
}

}  // namespace rayaudit
