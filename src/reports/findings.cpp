#include "reports/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "audit/finding.hpp"
#include "geometry/case_line.hpp"
#include "reports/figures.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

constexpr std::size_t themes_shown = 20, families_shown = 4;

/// What the subject says, for those who do not know the words yet.
std::string_view sentence(Verdict verdict) {
  switch (verdict) {
    case Verdict::false_hit:
      return "a hit where there is none";
    case Verdict::false_miss:
      return "a miss where there is a hit";
    case Verdict::wrong_root:
      return "a hit, but another than the first";
    case Verdict::wrong_t:
      return "the first hit, but t is far off";
    case Verdict::not_finite:
      return "a hit, but t is no finite number";
    case Verdict::invalid_mishandled:
      return "a hit where there is no ray or no shape";
    default:
      return name(verdict);
  }
}

/// What there is at the place that it claims.
std::string_view sentence(Claim claim) {
  switch (claim) {
    case Claim::none:
      return "";
    case Claim::no_root:
      return ", nor anywhere near on the line";
    case Claim::nan:
      return ": t is NaN";
    case Claim::infinite:
      return ": t is infinite";
    case Claim::behind:
      return ": there the line meets it before the ray begins";
    case Claim::past:
      return ": there the line meets it after the ray ends";
    case Claim::clipped:
      return ": there the line is beside the disk, or above or below the shape";
    case Claim::mirrored:
      return ": there is the other nappe of the cone";
    case Claim::later:
      return ": a later one";
    case Claim::declined:
      return ": a touch, declared to be a miss";
  }
  return "";
}

/// Findings that have their verdict, claim and most afflicted family in common, the worst first.
using Theme = std::vector<Finding>;

std::vector<Theme> themes(const std::vector<Audit>& audits) {
  std::vector<Theme> all;
  for (Finding& finding : findings(audits)) {
    const auto alike = std::find_if(all.begin(), all.end(), [&](const Theme& theme) {
      const Finding& first = theme.front();
      return first.verdict == finding.verdict && first.claim == finding.claim &&
             first.families.front().family == finding.families.front().family;
    });
    Theme& theme = alike == all.end() ? all.emplace_back() : *alike;
    theme.push_back(std::move(finding));
  }
  return all;
}

void include(std::vector<std::string>& names, std::string_view name) {
  if (std::find(names.begin(), names.end(), name) == names.end()) names.emplace_back(name);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// The families of a theme, each as the finding that it afflicts most has it; the worst first.
std::vector<Afflicted> afflicted(const Theme& theme) {
  std::vector<Afflicted> all;
  for (const Finding& finding : theme)
    for (const Afflicted& here : finding.families) {
      const auto known = std::find_if(all.begin(), all.end(), [&](const Afflicted& each) {
        return each.family == here.family;
      });
      if (known == all.end())
        all.push_back(here);
      else if (here.share() > known->share())
        *known = here;
    }
  std::stable_sort(all.begin(), all.end(),
                   [](const Afflicted& a, const Afflicted& b) { return a.share() > b.share(); });
  return all;
}

std::string families(const Theme& theme) {
  const std::vector<Afflicted> all = afflicted(theme);
  const std::size_t shown = std::min(families_shown, all.size());
  std::vector<std::string> told;
  for (std::size_t i = 0; i < shown; ++i)
    told.push_back(
        fmt::format("{}% of {}", figures::percent(all[i].wrong, all[i].cases), all[i].family));
  if (shown < all.size()) told.back() += fmt::format(", less of {} more", all.size() - shown);
  return joined(told);
}

/// The routines of a theme, each with the shapes; then the numbers.
std::string culprits(const Theme& theme) {
  std::vector<std::string> routines, numbers, told;
  for (const Finding& finding : theme) {
    include(routines, finding.routine);
    for (const std::string& number : finding.numbers) include(numbers, number);
  }
  for (const std::string& routine : routines) {
    std::vector<std::string> shapes;
    for (const Finding& finding : theme)
      if (finding.routine == routine) include(shapes, shape_names[finding.shape]);
    told.push_back(routine + " (" + joined(shapes) + ")");
  }
  return joined(told) + " in " + joined(numbers);
}

std::string paragraph(const Theme& theme, std::size_t rank, const Ink& ink) {
  const Finding& worst = theme.front();
  return fmt::format("{:>3}. {}: {}{}\n", rank, ink.bad(figures::words(name(worst.verdict))),
                     sentence(worst.verdict), sentence(worst.claim)) +
         wrapped(culprits(theme) + ": " + families(theme), 5) +
         fmt::format("     rayaudit explain '{}'\n", case_line(worst.example.question));
}

}  // namespace

std::string write_findings(const Run& run, const Ink& ink, bool all) {
  const std::vector<Theme> found = themes(run.audits);
  if (found.empty()) return ink.heading("Findings") + ": none\n";
  const std::size_t shown = all ? found.size() : std::min(themes_shown, found.size());
  std::string text =
      ink.heading("Findings") +
      ", worst first: how much of which family the worst of them has wrong; each with "
      "a case to look into\n";
  for (std::size_t i = 0; i < shown; ++i) text += '\n' + paragraph(found[i], i + 1, ink);
  if (shown < found.size())
    text +=
        fmt::format("\n{} more, less severe: --all-findings shows them.\n", found.size() - shown);
  return text;
}

}  // namespace rayaudit
