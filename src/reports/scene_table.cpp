#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/ink.hpp"
#include "reports/scene_run.hpp"
#include "reports/scene_words.hpp"
#include "reports/sentence.hpp"
#include "reports/surroundings.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;
using scenes::counted;
using scenes::explain_line;

constexpr std::size_t findings_shown = 20, skipped_shown = 10;

/// A count in a column: a dash for none, shortened where it does not fit.
std::string column(std::uint64_t count, std::size_t width) {
  std::string text = count == 0 ? "-" : grouped(count);
  if (text.size() >= width) text = magnitude(static_cast<double>(count));
  return fmt::format("{:>{}}", text, width);
}

/// The same in red where it is not 0.
std::string bad_column(std::uint64_t count, std::size_t width, const Ink& ink) {
  const std::string text = column(count, width);
  return count == 0 ? text : ink.bad(text);
}

std::string effects(const SceneRun& run, const Ink& ink) {
  std::string text = ink.heading("Effects") + ", and what calls for them\n";
  const double time = scenes::sum(run.picture.account).nanoseconds;
  for (const scenes::EffectUse& use : scenes::uses(run)) {
    std::string took;
    if (use.is_on && run.plan.audited) took = counted(use.rays, "ray");
    if (use.is_on && time > 0)
      took += fmt::format(", {:.0f}% of the time", 100 * use.nanoseconds / time);
    text += fmt::format("  {:<12}{:<12}{:<34}{}", name(use.calling->effect), scenes::state(use),
                        took, scenes::reason(use));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text + '\n';
}

struct VerdictColumn {
  Verdict verdict;
  std::string_view above, below;
};
constexpr std::array<VerdictColumn, 5> columns = {{{Verdict::false_hit, "false", "hits"},
                                                   {Verdict::false_miss, "false", "misses"},
                                                   {Verdict::wrong_root, "wrong", "roots"},
                                                   {Verdict::wrong_t, "wrong", "t"},
                                                   {Verdict::not_finite, "NaN,", "inf"}}};
constexpr std::array rare = {Verdict::crashed, Verdict::timed_out, Verdict::invalid_mishandled};

constexpr std::size_t wave_width = 15, rays_width = 11, verdict_width = 9, error_width = 8,
                      trouble_width = 10, leaks_width = 8;

std::string waves_heading(const Ink& ink) {
  std::string above = fmt::format("{:<{}}{:>{}}{:>{}}", "", wave_width + 2, "", rays_width, "",
                                  rays_width),
              below = fmt::format("{:>{}}{:>{}}", "rays", rays_width, "questions", rays_width);
  for (const VerdictColumn& each : columns) {
    above += fmt::format("{:>{}}", each.above, verdict_width);
    below += fmt::format("{:>{}}", each.below, verdict_width);
  }
  above.replace(0, 17, ink.heading("Bounce, effect") + "   ");
  above += fmt::format("{:>{}}{:>{}}{:>{}}", "margin", error_width, "ulp", error_width, "self-",
                       trouble_width);
  below += fmt::format("{:>{}}{:>{}}{:>{}}{:>{}}", "max", error_width, "max", error_width,
                       "inters.", trouble_width, "leaks", leaks_width);
  return above + '\n' + std::string(wave_width + 2, ' ') + below + '\n';
}

std::string wave_row(const std::string& name, const WaveAccount& wave, const Ink& ink) {
  const Tally& tally = wave.tally;
  const Worst* widest = tally.widest();
  std::string text = fmt::format("  {:<{}}", name, wave_width) + column(wave.rays, rays_width) +
                     column(wave.questions, rays_width);
  for (const VerdictColumn& each : columns)
    text += bad_column(tally.of(each.verdict), verdict_width, ink);
  text += fmt::format("{:>{}}{:>{}}", widest == nullptr ? "-" : magnitude(widest->severity),
                      error_width, tally.ulps.count() == 0 ? "-" : magnitude(tally.ulps.largest()),
                      error_width);
  return text + bad_column(wave.self_intersections.count, trouble_width, ink) +
         bad_column(wave.leaks.count, leaks_width, ink) + '\n';
}

/// The verdicts that are too rare to have a column.
std::string rare_verdicts(const Tally& tally, const Ink& ink) {
  std::string text;
  for (const Verdict verdict : rare)
    if (tally.of(verdict) > 0)
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", grouped(tally.of(verdict)),
                          figures::words(name(verdict)));
  return text.empty() ? "" : "  and " + ink.bad(text) + '\n';
}

std::string waves(const SceneAccount& account, const Ink& ink) {
  std::string text = waves_heading(ink);
  for (const WaveAccount& wave : account.waves)
    text += wave_row(fmt::format("{} {}", wave.bounce, name(wave.effect)), wave, ink);
  const WaveAccount all = scenes::sum(account);
  if (account.waves.size() > 1) text += wave_row("all", all, ink);
  return text + rare_verdicts(all.tally, ink) +
         wrapped(
             "Margin: how far the numbers of a case that is answered wrongly must move for its "
             "truth to change, in units u of rounding. Ulp: the error of t in units of its last "
             "place. Self-intersections: rays that meet the surface that they leave where they "
             "left it. Leaks: rays between two surfaces that leave no gap.",
             2) +
         '\n';
}

/// What happened to rays worst, and the command that shows it.
std::string example(std::string_view what, const Trouble& trouble, const SceneRun& run) {
  if (!trouble.example) return "";
  return fmt::format("  {}:\n    {}\n", what, explain_line(*trouble.example, run.plan.subject));
}

/// Self-intersections and leaks, the worst of each.
std::string troubles(const SceneRun& run, const Ink& ink) {
  Trouble acne, leaks;
  const auto keep = [](Trouble& worst, const Trouble& other) {
    if (other.example && (!worst.example || other.severity > worst.severity)) worst = other;
  };
  for (const WaveAccount& wave : run.picture.account.waves) {
    keep(acne, wave.self_intersections);
    keep(leaks, wave.leaks);
  }
  const std::string text =
      example(
          fmt::format("a ray meets the surface that it leaves, {} away", magnitude(acne.severity)),
          acne, run) +
      example(fmt::format("a ray passes between two surfaces, missing one by {} u",
                          magnitude(leaks.severity)),
              leaks, run);
  if (text.empty()) return "";
  return ink.heading("Rays that go wrong between surfaces") + ", the worst of each kind\n" + text +
         '\n';
}

std::string finding(const scenes::Finding& found, std::size_t rank, const SceneRun& run,
                    const Ink& ink) {
  const Worst& worst = *found.worst;
  const std::string verdict = figures::words(name(found.verdict));
  std::string head =
      wrapped(fmt::format("{}: {}{}", verdict, sentence(found.verdict), sentence(found.claim)), 5);
  // Coloured last: escape codes would count as letters.
  head.replace(0, 5 + verdict.size(), fmt::format("{:>3}. {}", rank, ink.bad(verdict)));
  return '\n' + head + wrapped(scenes::where(found), 5) + "     " +
         explain_line(worst, run.plan.subject) + '\n';
}

std::string findings(const SceneRun& run, const Look& look, const Ink& ink) {
  const std::vector<scenes::Finding> found = scenes::findings(run.picture.account);
  if (found.empty()) return ink.heading("Findings") + ": none\n\n";
  std::string text = ink.heading("Findings") +
                     ", worst first, by how far from any other truth they occur; with the worst "
                     "case of each\n";
  const std::size_t shown = look.everything ? found.size() : std::min(findings_shown, found.size());
  for (std::size_t i = 0; i < shown; ++i) text += finding(found[i], i + 1, run, ink);
  if (shown < found.size())
    text += fmt::format("\n{} more, less severe: --report json=FILE tells all.\n",
                        found.size() - shown);
  return text + '\n';
}

std::string offset_rows(const SceneAccount& account, const Ink& ink) {
  std::string text =
      fmt::format("{}{:>12}{:>16}{:>14}{:>16}\n", ink.heading(fmt::format("{:<16}", "Offsets")),
                  "acne", "farthest away", "lost contact", "farthest away");
  for (const OffsetAccount& each : account.offsets) {
    const auto farthest = [](const Trouble& trouble) {
      return fmt::format("{:>16}", trouble.count == 0 ? "-" : magnitude(trouble.severity));
    };
    text += fmt::format("  {:<14}", each.offset.name) + bad_column(each.acne.count, 12, ink) +
            farthest(each.acne) + bad_column(each.lost_contact.count, 14, ink) +
            farthest(each.lost_contact) + '\n';
  }
  return text;
}

std::string offset_cases(const SceneRun& run) {
  std::string text;
  for (const OffsetAccount& each : run.picture.account.offsets)
    text += example(each.offset.name + ", acne", each.acne, run) +
            example(each.offset.name + ", lost contact", each.lost_contact, run);
  return text;
}

/// Of the smallest safe offset, what shows that no smaller one is.
std::string safe_cases(const SceneRun& run) {
  const SafeOffset& safe = run.picture.account.safe;
  const auto shown = [&](std::string_view what, const std::optional<Case>& question) {
    return example(what, {1, 0, question}, run);
  };
  return shown("the departure that takes the largest t_min", safe.t_min_case) +
         shown("the departure that takes the most ulps", safe.ulps_case) +
         shown("the nearest contact", safe.contact_case);
}

std::string offsets(const SceneRun& run, const Ink& ink) {
  const SceneAccount& account = run.picture.account;
  std::string text;
  const std::string safe = scenes::safe_offset(account);
  if (!account.offsets.empty() && !safe.empty())
    text +=
        offset_rows(account, ink) + wrapped(scenes::about_offsets(account), 2) + offset_cases(run);
  if (!safe.empty()) text += wrapped(safe + '.', 0) + safe_cases(run);
  return text.empty() ? "" : text + '\n';
}

std::string culling(const SceneRun& run, const Ink& ink) {
  const Culling& culled = run.picture.account.culling;
  const std::string text = scenes::culling(culled);
  if (text.empty()) return "";
  const bool is_wrong = culled.wrong.count > 0;
  return ink.heading("Culling") + ": " + (is_wrong ? ink.bad(text) : text) + '\n' +
         example("culled, though they meet", culled.wrong, run) + '\n';
}

std::string skipped(const Scene& scene, const Look& look, const Ink& ink) {
  if (scene.skipped.empty()) return "";
  std::string text = ink.heading("Skipped") + ", for there is no use for it\n";
  const std::size_t shown =
      look.everything ? scene.skipped.size() : std::min(skipped_shown, scene.skipped.size());
  for (std::size_t i = 0; i < shown; ++i)
    text += wrapped(told(scene.skipped[i].place) + ": " + scene.skipped[i].what, 2);
  if (shown < scene.skipped.size())
    text += fmt::format("  and {} more\n", scene.skipped.size() - shown);
  return text + '\n';
}

std::string files(const SceneRun& run) {
  std::string names;
  for (const std::string* file :
       {&run.picture_file, &run.exact_file, &run.difference_file, &run.verdict_file})
    if (!file->empty()) names += (names.empty() ? "" : ", ") + *file;
  return names.empty() ? "" : wrapped("Pictures: " + names, 0);
}

std::string summary(const SceneRun& run, const Ink& ink) {
  const std::string text = scenes::summary(run);
  const WaveAccount all = scenes::sum(run.picture.account);
  if (!run.plan.audited) return text + '\n';
  const bool is_well = all.tally.wrong() + all.self_intersections.count + all.leaks.count == 0;
  return (is_well ? ink.good(text) : ink.bad(text)) + '\n';
}

}  // namespace

std::string write_scene_table(const SceneRun& run, const Look& look) {
  const Ink ink = {look.colour};
  std::string text = wrapped(fmt::format("rayaudit {}: {}", run.version, scenes::title(run)), 0) +
                     '\n' + skipped(run.plan.scene, look, ink) + effects(run, ink);
  if (run.plan.audited)
    text += waves(run.picture.account, ink) + findings(run, look, ink) + troubles(run, ink) +
            offsets(run, ink) + culling(run, ink);
  if (const std::string moved = scenes::rounding(run); !moved.empty())
    text += wrapped(moved + '.', 0);
  return text + surroundings(run.environment) + files(run) + summary(run, ink);
}

}  // namespace rayaudit
