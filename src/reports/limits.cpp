#include "reports/limits.hpp"

#include <fmt/format.h>

#include <array>

#include "reports/figures.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::magnitude;
using figures::percent;

/// The margins at which a new column begins, as powers of two; the first column holds all below.
constexpr std::array columns = {0, 2, 4, 8, 16, 24, 32};
constexpr std::array<std::string_view, columns.size() + 1> headings = {
    "< 1 u", "1-4", "4-16", "16-2^8", "-2^16", "-2^24", "-2^32", "beyond"};

/// A subject over all shapes and families of a run.
struct Sum {
  const Subject* subject;
  MarginCurve curve = {};
  Certificate certificate = {};
  std::array<std::uint64_t, 4> stages = {};
};

std::vector<Sum> sums(const std::vector<Audit>& audits) {
  std::vector<Sum> all;
  for (const Audit& audit : audits) {
    if (all.empty() || all.back().subject != audit.subject) all.push_back({audit.subject});
    all.back().curve.merge(audit.tally.curve);
    all.back().certificate.merge(audit.tally.certificate);
    for (std::size_t i = 0; i < all.back().stages.size(); ++i)
      all.back().stages[i] += audit.tally.stages[i];
  }
  return all;
}

std::array<MarginCurve::Step, columns.size() + 1> by_column(const MarginCurve& curve) {
  std::array<MarginCurve::Step, columns.size() + 1> steps;
  std::size_t column = 0;
  for (int exponent = MarginCurve::least; exponent <= MarginCurve::most; ++exponent) {
    while (column < columns.size() && exponent >= columns[column]) ++column;
    steps[column].cases += curve.at(exponent).cases;
    steps[column].wrong += curve.at(exponent).wrong;
  }
  return steps;
}

std::string wrong_by_margin(const MarginCurve& curve) {
  std::string text;
  for (const auto& [cases, wrong] : by_column(curve))
    text += fmt::format("{:>7}", cases == 0 ? "" : percent(wrong, cases));
  return text;
}

std::string proofs(const Certificate& certificate) {
  if (certificate.cases == 0) return "";
  std::string text = fmt::format("{:>8}", percent(certificate.certified, certificate.cases));
  if (certificate.proved)
    text += fmt::format("{:>8}{:>8}{:>7}", magnitude(certificate.proved->severity),
                        magnitude(certificate.observed->severity),
                        magnitude(certificate.looseness.quantile(0.5)));
  if (certificate.compared < certificate.certified)
    text += fmt::format("  ({} past the work limit)", certificate.certified - certificate.compared);
  if (certificate.wrong > 0)
    text += fmt::format("  {} DIFFER from the exact replay", certificate.wrong);
  return text;
}

/// Which stage of its own answered, of a subject that works in stages.
std::string stages(const std::array<std::uint64_t, 4>& counts) {
  std::uint64_t all = 0;
  for (const std::uint64_t count : counts) all += count;
  if (all == 0) return "";
  return fmt::format("  stages {}%, {}%, {}%", percent(counts[1], all), percent(counts[2], all),
                     percent(counts[3], all));
}

}  // namespace

std::string write_limits(const Run& run, const Ink& ink) {
  std::string text = wrapped(
      fmt::format(
          "Limits: per cent wrong at which margin; and of the answers run with error bounds, "
          "per cent certified (every comparison proved, so that the verdict is that of the "
          "same routine without rounding), the largest bound proved and the largest error "
          "seen of t, in ulps, both against that exact replay, and how many times the one "
          "the other is, at half of the hits. Of a subject that works in stages, per cent answered "
          "by each. From {}.",
          run.plan.thorough ? "all cases" : "32 of each 1,024 cases"),
      0);
  text.replace(0, 6, ink.heading("Limits"));
  text += fmt::format("{:<30}", "");
  for (const std::string_view heading : headings) text += fmt::format("{:>7}", heading);
  text += fmt::format("{:>8}{:>8}{:>8}{:>7}\n", "proved%", "bound", "seen", "loose");
  for (const Sum& sum : sums(run.audits)) {
    std::string line = fmt::format("  {:<28.28}", sum.subject->name) + wrong_by_margin(sum.curve) +
                       proofs(sum.certificate) + stages(sum.stages);
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + '\n';
  }
  return text;
}

}  // namespace rayaudit
