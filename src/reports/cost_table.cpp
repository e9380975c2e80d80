#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/figures.hpp"
#include "reports/ink.hpp"
#include "reports/report.hpp"
#include "reports/steps.hpp"
#include "reports/surroundings.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;

/// Nanoseconds to three digits: 8.31, 42.7, 1,234.
std::string nanoseconds(double x) {
  return x < 999.5 ? fmt::format("{:.3g}", x)
                   : grouped(static_cast<std::uint64_t>(std::llround(x)));
}

std::string title(const CostRun& run) {
  return wrapped(
      fmt::format("rayaudit {}: what being right costs; {} cases for each way, shape and family, "
                  "drawn as floats; {} rounds of {} of them; of dear ways fewer; seed {}",
                  run.version, grouped(run.plan.cases), run.plan.rounds,
                  grouped(std::min<std::uint64_t>(run.plan.cases, chunk_cases)), run.plan.seed),
      0);
}

std::string legend(const CostRun& run, const Look& look) {
  return wrapped(
      fmt::format(
          "Nanoseconds a case: the median of the rounds and its quartiles, measured here and now, "
          "every way in turn on the same cases, on one processor; up to {} of them are spent on "
          "reading a case and writing an answer. Wrong answers, false hits and misses: per million "
          "cases; where none is wrong, so many at most, at 95%. Margin: the largest at which an "
          "answer is wrong, in u of the subject's format. Ulp, forced: the worst error of t in the "
          "subject's own ulps, and in units of what rounding the numbers of the case once would do "
          "to t. Error: the worst of its own among proper hits, in units of float, whatever the "
          "format: of the larger of an ulp and that forced error. Hard: the time on families of "
          "degenerate cases and those near them, in units of the time on the others; a dash where "
          "they cannot be told apart. The front{}: from the most accurate on, each way that is "
          "clearly faster (quartiles apart, medians by {:.0f}% at least) and slower than none more "
          "accurate; of these each that is clearly more accurate than the next faster one: never "
          "wrong where that is, or less often by more than chance, or with half its error at most.",
          nanoseconds(run.cost.idle.median), look.everything ? " (*)" : "", 100 * apart),
      0);
}

std::string heading(const Cell& cell, std::size_t families, const Ink& ink) {
  const std::string of = cell.scope == Scope::family ? fmt::format("family {}", cell.family->id)
                         : cell.scope == Scope::all
                             ? fmt::format("{} famil{}", families, families == 1 ? "y" : "ies")
                             : fmt::format("the {} {} famil{}", families, name(cell.scope),
                                           families == 1 ? "y" : "ies");
  return ink.heading(fmt::format("{:<35}", fmt::format("{}, {}", shape_names[cell.shape], of))) +
         fmt::format("{:>7}{:>14}{:>13}{:>8}{:>8}{:>7}{:>7}{:>7}{:>8}{:>6}\n", "ns", "quartiles",
                     "wrong", "f. hits", "f. miss", "margin", "ulp", "forced", "error", "hard");
}

/// How much dearer hard cases are, where that can be told.
std::string dearer(const Price* price) {
  if (price == nullptr || !(is_clearly_less(price->easy->nanoseconds, price->hard->nanoseconds) ||
                            is_clearly_less(price->hard->nanoseconds, price->easy->nanoseconds)))
    return "-";
  return magnitude(price->times.median);
}

std::string row(const Way& way, const Price* price, const Look& look, const Ink& ink) {
  const auto& [low, median, high] = way.nanoseconds;
  const Accuracy& accuracy = way.accuracy;
  const auto verdicts = [&](Verdict verdict) {
    const double count = accuracy.per_million(verdict);
    return count == 0 ? "-" : count == 1e6 ? "all" : whole(count);
  };
  const std::string wrong = fmt::format("{:>13}", per_million(accuracy));
  const std::string text = fmt::format(
      "{}{:<33}{:>7}{:>14}{}{:>8}{:>8}{:>7}{:>7}{:>7}{:>8}{:>6}",
      !look.everything ? "  "
      : way.on_front   ? "* "
                       : "  ",
      way.subject->name, nanoseconds(median),
      fmt::format("{}-{}", nanoseconds(low), nanoseconds(high)),
      accuracy.wrong == 0 ? ink.good(wrong) : ink.bad(wrong), verdicts(Verdict::false_hit),
      verdicts(Verdict::false_miss), magnitude(accuracy.wrong_margin), magnitude(accuracy.ulps),
      magnitude(accuracy.forced), magnitude(accuracy.error), dearer(price));
  return (look.everything && !way.on_front ? ink.faint(text) : text) + '\n';
}

std::string table(const Cell& cell, const CostRun& run, const Look& look, const Ink& ink) {
  const std::vector<Price> prices = run.cost.prices(cell.shape);
  const auto price_of = [&](const Way& way) -> const Price* {
    if (cell.scope != Scope::all) return nullptr;
    const auto found = std::ranges::find_if(
        prices, [&](const Price& price) { return price.easy->subject == way.subject; });
    return found == prices.end() ? nullptr : &*found;
  };
  std::vector<const Way*> shown = cell.front();
  if (look.everything) {
    shown.clear();
    for (const Way& way : cell.ways) shown.push_back(&way);
    std::ranges::stable_sort(shown, {}, [](const Way* way) { return way->nanoseconds.median; });
  }
  const auto is_in = [&](const Family* family) {
    return family->draw[cell.shape] != nullptr && counts_in(cell.scope, *family);
  };
  const auto families = std::ranges::count_if(run.plan.families, is_in);
  std::string text = heading(cell, static_cast<std::size_t>(families), ink);
  for (const Way* way : shown) text += row(*way, price_of(*way), look, ink);
  if (const std::size_t more = cell.ways.size() - shown.size(); more > 0)
    text += ink.faint(fmt::format("    and {} way{} that others are better than", more,
                                  more == 1 ? "" : "s")) +
            '\n';
  for (const Step& step : cell.steps()) text += wrapped(told(step), 4);
  return text + '\n';
}

/// What is told by default: sums, or the one family where there is no other.
bool is_shown(const Cell& cell, const CostRun& run, const Look& look) {
  const bool only_one = run.plan.families.size() == 1;
  return cell.scope == Scope::family ? look.families || only_one : !only_one;
}

std::string absent(const CostRun& run) {
  std::string text;
  for (const auto& [subjects, why] : absent_subjects())
    text += wrapped(fmt::format("Not measured: {}: {}", subjects, why), 0);
  for (const Untimed& each : run.cost.untimed) text += wrapped("Not measured: " + each.why, 0);
  return text;
}

}  // namespace

std::string write_cost_table(const CostRun& run, const Look& look) {
  const Ink ink = {look.colour};
  std::string text = title(run) + '\n' + legend(run, look) + '\n';
  for (const Cell& cell : run.cost.cells)
    if (is_shown(cell, run, look)) text += table(cell, run, look, ink);
  return text + absent(run) + surroundings(run.environment);
}

}  // namespace rayaudit
