#include <fmt/format.h>

#include <algorithm>

#include "reports/difference.hpp"
#include "reports/figures.hpp"
#include "reports/ink.hpp"
#include "reports/json.hpp"
#include "reports/markdown_text.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using json::Json;

constexpr ReportOf<Difference> of_differences[] = {
    {"table", "for people: what broke, what is fixed, what is gone", write_difference_table},
    {"json", "for programs: every change with its case", write_difference_json},
    {"markdown", "for a pull request", write_difference_markdown},
};

std::string amount(const Change& change, double of) {
  return change.cases == 0 ? figures::magnitude(of) : grouped(static_cast<std::uint64_t>(of));
}

std::string audits(std::size_t count) {
  return fmt::format("{} audit{}", grouped(count), count == 1 ? "" : "s");
}

/// The subjects of audits, each once, with how many audits it has there.
std::string subjects_of(const std::vector<RecordedAudit>& all) {
  std::string text;
  for (auto audit = all.begin(); audit != all.end();) {
    const auto next = std::find_if(audit, all.end(), [&](const RecordedAudit& each) {
      return each.subject != audit->subject;
    });
    text += fmt::format("{}{} ({})", text.empty() ? "" : ", ", audit->subject,
                        grouped(static_cast<std::uint64_t>(next - audit)));
    audit = next;
  }
  return text;
}

std::uint64_t wrong_in(const std::vector<RecordedAudit>& all) {
  std::uint64_t sum = 0;
  for (const RecordedAudit& audit : all) sum += audit.wrong;
  return sum;
}

/// Of audits that only one of the reports has, a sentence each way; nothing where there are none.
std::vector<std::string> asides(const Difference& difference) {
  std::vector<std::string> all;
  if (!difference.gone.empty())
    all.push_back(
        fmt::format("Gone: {}: {}", audits(difference.gone.size()), subjects_of(difference.gone)));
  if (!difference.added.empty())
    all.push_back(fmt::format("New: {}, {} wrong answers in them, held against nothing: {}",
                              audits(difference.added.size()), grouped(wrong_in(difference.added)),
                              subjects_of(difference.added)));
  return all;
}

std::string paragraph(const Change& change) {
  return fmt::format("  {}\n    {}\n", told(change), change.explain);
}

Json told_in_json(const std::vector<Change>& changes) {
  Json all = Json::array();
  for (const Change& each : changes)
    all.push_back({{"subject", each.subject},
                   {"shape", each.shape},
                   {"family", each.family},
                   {"what", each.what},
                   {"claim", each.claim},
                   {"before", json::number(each.before)},
                   {"after", json::number(each.after)},
                   {"cases", each.cases == 0 ? Json(nullptr) : Json(each.cases)},
                   {"others", each.others},
                   {"cause", each.cause},
                   {"case", each.line},
                   {"explain", each.explain}});
  return all;
}

Json told_in_json(const std::vector<RecordedAudit>& audits) {
  Json all = Json::array();
  for (const RecordedAudit& each : audits)
    all.push_back({{"subject", each.subject},
                   {"shape", each.shape},
                   {"family", each.family},
                   {"cases", each.cases},
                   {"wrong", each.wrong}});
  return all;
}

std::string block(const Change& change) {
  std::string text = fmt::format("case     {}\n", change.line);
  if (!change.cause.empty()) text += fmt::format("cause    {}\n", change.cause);
  return text + fmt::format("explain  {}\n", change.explain);
}

std::vector<std::string> folded_changes(const std::vector<Change>& changes) {
  std::vector<std::string> all;
  all.reserve(changes.size());
  for (const Change& each : changes) all.push_back(folded(told(each), block(each)));
  return all;
}

/// So many of the changes of each kind are told where not all are asked for.
constexpr std::size_t changes_shown = 20;

}  // namespace

std::span<const ReportOf<Difference>> difference_reports() { return of_differences; }

std::string told(const Change& change) {
  const std::string place =
      fmt::format("{} on {}, family {}", change.subject, change.shape, change.family);
  if (change.cases == 0)
    return fmt::format("{}: the largest error was {}, is {} times what rounding excuses", place,
                       amount(change, change.before), amount(change, change.after));
  const std::string what =
      change.claim == "none" ? change.what : fmt::format("{} ({})", change.what, change.claim);
  const std::string cause = change.cause.empty() ? "" : "; cause: " + change.cause;
  if (change.others)
    return fmt::format("{}: {} in {} of {} cases as before, but not the same{}", place, what,
                       amount(change, change.after), grouped(change.cases), cause);
  return fmt::format("{}: {} was in {}, is in {} of {} cases{}", place, what,
                     amount(change, change.before), amount(change, change.after),
                     grouped(change.cases), cause);
}

std::string summary(const Difference& difference) {
  std::string text = fmt::format("{} broke, {} fixed in {}", grouped(difference.broke.size()),
                                 grouped(difference.fixed.size()), audits(difference.compared));
  if (difference.partly > 0)
    text += fmt::format(" ({} of them by crashes and time-outs alone: not all cases were asked)",
                        grouped(difference.partly));
  if (!difference.gone.empty()) text += fmt::format(", {} gone", grouped(difference.gone.size()));
  if (!difference.added.empty()) text += fmt::format(", {} new", grouped(difference.added.size()));
  return text;
}

std::string write_difference_table(const Difference& difference, const Look& look) {
  const Ink ink = {look.colour};
  const Record& after = difference.after;
  std::string text = fmt::format(
      "rayaudit {}: `{}` held against `{}`: {} cases for each subject, shape and family; seed "
      "{}\n\n",
      after.version, after.name, difference.before.name, grouped(after.cases), after.seed);
  const auto list = [&](const std::string& heading, const std::vector<Change>& changes) {
    if (changes.empty()) return;
    text += heading + '\n';
    for (const Change& each : changes) text += paragraph(each);
    text += '\n';
  };
  list(ink.bad("Broke"), difference.broke);
  list(ink.good("Fixed"), difference.fixed);
  for (const std::string& each : asides(difference)) text += each + "\n\n";
  const std::string last = summary(difference);
  return text + (difference.broke.empty() ? ink.good(last) : ink.bad(last)) + '\n';
}

std::string write_difference_json(const Difference& difference, const Look&) {
  const auto file = [](const Record& record) {
    return Json{{"file", record.name}, {"version", record.version}};
  };
  return json::written({{"schema", 1},
                        {"report", "diff"},
                        {"tool", json::tool(difference.after.version)},
                        {"seed", difference.after.seed},
                        {"cases", difference.after.cases},
                        {"before", file(difference.before)},
                        {"after", file(difference.after)},
                        {"compared", difference.compared},
                        {"partly", difference.partly},
                        {"broke", told_in_json(difference.broke)},
                        {"fixed", told_in_json(difference.fixed)},
                        {"gone", told_in_json(difference.gone)},
                        {"new", told_in_json(difference.added)}});
}

std::string write_difference_markdown(const Difference& difference, const Look& look) {
  const std::string foot =
      fmt::format("\nrayaudit {}: {} cases for each subject, shape and family; seed {}\n",
                  difference.after.version, grouped(difference.after.cases), difference.after.seed);
  ShortMarkdown text(fmt::format("**rayaudit: {}**\n", markdown_text(summary(difference))), foot);
  const auto list = [&](std::string_view heading, const std::vector<Change>& changes,
                        std::string_view left) {
    if (changes.empty()) return;
    std::vector<std::string> pieces = folded_changes(changes);
    pieces.front() = fmt::format("\n### {}\n{}", heading, pieces.front());
    text.add(pieces, look.everything ? pieces.size() : changes_shown, left);
  };
  list("Broke", difference.broke, "that broke are");
  list("Fixed", difference.fixed, "that are fixed are");
  for (const std::string& each : asides(difference))
    text.add({'\n' + markdown_text(each) + '\n'}, 1, "paragraph is");
  return text.text();
}

}  // namespace rayaudit
