#include "reports/findings.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "audit/finding.hpp"
#include "geometry/signal_name.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {

namespace {

using figures::magnitude;

constexpr std::size_t themes_shown = 20, families_shown = 4;

/// Below so many u a verdict may turn by rounding the numbers of the case once or twice.
constexpr double excusable = 4;

/// A place that may stand for a miss: a slip to be mended however few rays show it.
bool is_sentinel(Claim claim) { return claim == Claim::centre || claim == Claim::origin; }

/// Findings of one routine, verdict and claim, each of another shape; the worst first.
using Theme = std::vector<Finding>;

std::vector<Theme> themes(const std::vector<Audit>& audits) {
  std::vector<Theme> all;
  for (Finding& finding : findings(audits)) {
    const auto alike = std::find_if(all.begin(), all.end(), [&](const Theme& theme) {
      const Finding& first = theme.front();
      return first.routine == finding.routine && first.verdict == finding.verdict &&
             first.claim == finding.claim;
    });
    Theme& theme = alike == all.end() ? all.emplace_back() : *alike;
    theme.push_back(std::move(finding));
  }
  return all;
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text;
}

/// A family of a theme, and the shape that has most of it wrong.
struct AfflictedShape {
  Afflicted family;
  std::size_t shape;
};

/// The families of a theme, the most afflicted first.
std::vector<AfflictedShape> afflicted(const Theme& theme) {
  std::vector<AfflictedShape> all;
  for (const Finding& finding : theme)
    for (const Afflicted& here : finding.families) {
      const auto known = std::find_if(all.begin(), all.end(), [&](const AfflictedShape& each) {
        return each.family.family == here.family;
      });
      if (known == all.end())
        all.push_back({here, finding.shape});
      else if (here.share() > known->family.share())
        *known = {here, finding.shape};
    }
  std::stable_sort(all.begin(), all.end(), [](const AfflictedShape& a, const AfflictedShape& b) {
    return a.family.share() > b.family.share();
  });
  return all;
}

std::string families(const Theme& theme) {
  const std::vector<AfflictedShape> all = afflicted(theme);
  const std::size_t shown = std::min(families_shown, all.size());
  std::vector<std::string> told;
  for (std::size_t i = 0; i < shown; ++i) {
    const auto& [family, shape] = all[i];
    told.push_back(
        fmt::format("{}% of {}", figures::percent(family.wrong, family.cases), family.family));
    if (theme.size() > 1) told.back() += fmt::format(" ({})", shape_names[shape]);
  }
  if (shown < all.size()) told.back() += fmt::format(", less of {} more", all.size() - shown);
  return joined(told);
}

/// Of a flip the comparison that was turned most often, of the rest what it was about.
std::string detail(const CauseCount& causes, Cause cause) {
  const auto most = [](const auto& list, const auto& fits) {
    auto found = list.end();
    for (auto each = list.begin(); each != list.end(); ++each)
      if (fits(*each) && (found == list.end() || each->count > found->count)) found = each;
    return found;
  };
  if (cause == Cause::flip) {
    const auto place = most(causes.turned, [](const auto&) { return true; });
    if (place == causes.turned.end()) return "";
    const char* often = place->count < causes.of(cause) ? "most" : "all";
    return fmt::format(" ({} at {}:{} `{}`)", often, place->file, place->line, place->text);
  }
  const auto about = most(causes.about, [&](const auto& each) { return each.cause == cause; });
  return about == causes.about.end() ? "" : fmt::format(" ({})", about->about);
}

/// The shapes and numbers of a theme.
std::string places(const Theme& theme) {
  std::vector<std::string> shapes, numbers;
  for (const Finding& finding : theme) {
    include(shapes, shape_names[finding.shape]);
    for (const std::string& number : finding.numbers) include(numbers, number);
  }
  return joined(shapes) + " in " + joined(numbers);
}

/// The causes that were found, the most frequent first, and where or what about.
std::string causes(const Theme& theme) {
  CauseCount sum;
  CauseShare weight = {};
  std::uint64_t wrong = 0;
  for (const Finding& finding : theme) {
    sum.merge(finding.causes);
    add(weight, finding.by_cause);
    wrong += finding.wrong;
  }
  std::vector<std::pair<double, std::string>> parts;
  for (std::size_t i = 0; i < cause_count; ++i) {
    const auto cause = static_cast<Cause>(i);
    const double share = weight[i] / static_cast<double>(wrong);
    if (share <= 0) continue;
    parts.emplace_back(share, std::string(name(cause)) + detail(sum, cause));
  }
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::string> words;
  words.reserve(parts.size());
  for (const auto& [share, text] : parts)
    words.push_back(parts.size() == 1 ? text : fmt::format("{:.3g}% {}", 100 * share, text));
  return fmt::format("cause (by {} of {} replayed): {}",
                     figures::grouped(std::max<std::uint64_t>(sum.replayed(), 1)),
                     figures::grouped(wrong), joined(words));
}

/// How near the edge it is wrong, and what can be relied on there.
std::string limits(const Finding& worst) {
  const double margin = worst.example.severity;
  const std::string_view subject = worst.audit->subject->name;
  std::string text =
      margin > 0 ? fmt::format("margin: {} wrong up to {} u", subject, magnitude(margin)) : "";
  if (margin > 0 && margin <= excusable) text += ", as rounding the case itself may do";
  const Certificate& there = worst.audit->tally.certificate;
  if (there.cases == 0) return text;
  if (!text.empty()) text += "; ";
  text += there.certified == 0 ? fmt::format("bound: none of {} certified", worst.audit->family->id)
                               : fmt::format("bound: {}% of {} certified",
                                             figures::percent(there.certified, there.cases),
                                             worst.audit->family->id);
  if (there.proved)
    text += fmt::format(", rounding alone within {} ulps proved, {} seen",
                        magnitude(there.proved->severity), magnitude(there.observed->severity));
  return text;
}

/// What is told of the case that is shown.
std::string minimal(const Minimal& of) {
  const std::string text = "minimal: " + told(of.diagnosis);
  return of.margin > 0 ? text + fmt::format(", margin {} u", magnitude(of.margin)) : text;
}

/// What a process ended by, and whether it all shows again.
std::string circumstances(const Finding& worst) {
  std::string text;
  if (const int signal = worst.example.answer.signal; signal != 0)
    text += ", killed by " + signal_name(signal);
  if (!worst.example.repeats) text += "; not reproducible: the case below, asked alone, goes well";
  return text;
}

std::string paragraph(const Theme& theme, std::size_t rank, const Convention& convention,
                      const Ink& ink) {
  const Finding& worst = theme.front();
  const std::string verdict = figures::words(name(worst.verdict));
  std::string head =
      wrapped(fmt::format("{} by {}: {}{}{}", verdict, worst.routine, sentence(worst.verdict),
                          sentence(worst.claim), circumstances(worst)),
              5);
  // Coloured last: escape codes would count as letters.
  head.replace(0, 5 + verdict.size(), fmt::format("{:>3}. {}", rank, ink.bad(verdict)));
  std::string text =
      head + wrapped(places(theme) + ": " + families(theme), 5) + wrapped(causes(theme), 5);
  if (const std::string limits_there = limits(worst); !limits_there.empty())
    text += wrapped(limits_there, 5);
  if (worst.example.minimal) text += wrapped(minimal(*worst.example.minimal), 5);
  return text + "     " +
         explain_line(told_first(worst.example), *worst.audit->subject, convention) + '\n';
}

}  // namespace

std::string write_findings(const Run& run, const Ink& ink, bool all) {
  const std::vector<Theme> found = themes(run.audits);
  if (found.empty()) return ink.heading("Findings") + ": none\n";
  std::string text =
      ink.heading("Findings") +
      ", worst first, by how far from any other truth they occur: what a routine does, on which "
      "shapes, how much of\nwhich family; why, by experiment; what bounds hold there; and a "
      "minimal "
      "case to look into\n";
  std::size_t shown = 0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (!all && i >= themes_shown && !is_sentinel(found[i].front().claim)) continue;
    text += '\n' + paragraph(found[i], i + 1, run.plan.convention, ink);
    ++shown;
  }
  if (shown < found.size())
    text +=
        fmt::format("\n{} more, less severe: --all-findings shows them.\n", found.size() - shown);
  return text;
}

}  // namespace rayaudit
