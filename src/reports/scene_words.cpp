#include "reports/scene_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <tuple>

#include "audit/finding.hpp"
#include "geometry/case_line.hpp"
#include "reports/figures.hpp"

namespace rayaudit::scenes {
namespace {

using figures::grouped;
using figures::magnitude;

Finding& finding(std::vector<Finding>& all, const Outcome& outcome) {
  const auto known = std::find_if(all.begin(), all.end(), [&](const Finding& each) {
    return each.verdict == outcome.verdict && each.claim == outcome.claim;
  });
  if (known != all.end()) return *known;
  return all.emplace_back(Finding{outcome.verdict, outcome.claim});
}

void add(Finding& finding, Effect effect, const Outcome& outcome) {
  finding.count += outcome.count;
  auto part = std::find_if(finding.parts.begin(), finding.parts.end(),
                           [&](const Finding::Part& each) { return each.effect == effect; });
  if (part == finding.parts.end()) part = finding.parts.insert(part, {effect});
  part->count += outcome.count;
  const Worst& worst = *outcome.worst;
  if (finding.worst == nullptr || worst.severity > finding.worst->severity) finding.worst = &worst;
}

/// The rank of a finding; larger is worse.
auto rank(const Finding& finding) {
  const double margin = std::min(finding.worst->severity, defect_margin);
  const int octave = margin > 0 ? std::ilogb(margin) : -10'000;
  return std::make_tuple(finding.verdict != Verdict::invalid_mishandled, octave, finding.count);
}

/// Three digits of a number that is not below x, or with a share less of it not above.
std::string bounding(double x, double share) {
  const std::string text = fmt::format("{:.3g}", x);
  const double read = std::strtod(text.c_str(), nullptr);
  return (share > 0 ? read >= x : read <= x) ? text : fmt::format("{:.3g}", x * (1 + share));
}
// Half a unit of the third digit is at most this share.
std::string at_least(double x) { return bounding(x, 0.005); }
std::string at_most(double x) { return bounding(x, -0.005); }

/// Is there an offset that skips every departure and no contact?
std::string verdict_on(const SafeOffset& safe) {
  if (std::isinf(safe.contact))
    return "nothing is met but the departure, so that no larger one loses anything";
  std::string nearest =
      fmt::format("the nearest contact of such a ray lies {} away", at_most(safe.contact));
  if (safe.t_min >= safe.contact) return nearest + ", within it: no fixed t_min is safe here";
  if (safe.t_min == 0) return nearest;
  return fmt::format("{}, {} times as far: a t_min between the two is safe here", nearest,
                     magnitude(safe.contact / safe.t_min));
}

bool leaves_surfaces(const SceneAccount& account) {
  return account.safe.t_min_case || account.safe.ulps_case || account.safe.contact_case ||
         std::any_of(account.offsets.begin(), account.offsets.end(),
                     [](const OffsetAccount& each) { return each.rays > 0; });
}

}  // namespace

std::vector<Finding> findings(const SceneAccount& account) {
  std::vector<Finding> all;
  for (const WaveAccount& wave : account.waves)
    for (const Outcome& outcome : wave.tally.outcomes)
      if (is_wrong(outcome.verdict) && outcome.worst)
        add(finding(all, outcome), wave.effect, outcome);
  for (Finding& each : all)
    std::sort(each.parts.begin(), each.parts.end(),
              [](const auto& a, const auto& b) { return a.effect < b.effect; });
  std::stable_sort(all.begin(), all.end(),
                   [](const Finding& a, const Finding& b) { return rank(a) > rank(b); });
  return all;
}

WaveAccount sum(const SceneAccount& account) {
  WaveAccount all = {Effect::primary, 0};
  for (const WaveAccount& wave : account.waves) {
    all.rays += wave.rays;
    all.questions += wave.questions;
    all.tally.merge(wave.tally);
    all.self_intersections.count += wave.self_intersections.count;
    all.leaks.count += wave.leaks.count;
    all.nanoseconds += wave.nanoseconds;
  }
  return all;
}

std::string where(const Finding& finding) {
  std::string text = counted(finding.count, "answer") + ": ";
  for (const auto& [effect, count] : finding.parts) {
    if (&effect != &finding.parts.front().effect) text += ", ";
    text += fmt::format("{} of {} rays", grouped(count), name(effect));
  }
  const Worst& worst = *finding.worst;
  text += fmt::format("; the worst on a {}", name(worst.question.shape));
  if (worst.severity > 0) text += fmt::format(", margin {} u", magnitude(worst.severity));
  return text + ", cause: " + told(worst.diagnosis);
}

std::vector<EffectUse> uses(const SceneRun& run) {
  std::vector<EffectUse> all;
  all.reserve(run.callings.size());
  for (const Calling& calling : run.callings) {
    EffectUse& use = all.emplace_back(
        EffectUse{&calling, calling.is_on && run.plan.effects.has(calling.effect)});
    for (const WaveAccount& wave : run.picture.account.waves)
      if (wave.effect == calling.effect) {
        use.rays += wave.rays;
        use.nanoseconds += wave.nanoseconds;
      }
  }
  return all;
}

std::string_view state(const EffectUse& use) {
  if (use.is_on) return "on";
  return use.calling->is_on ? "taken away" : "off";
}

std::string reason(const EffectUse& use) {
  const Calling& calling = *use.calling;
  // No line calls for primary rays.
  if (!calling.is_on || calling.effect == Effect::primary || calling.place.file.empty())
    return calling.because;
  return calling.because.empty() ? told(calling.place)
                                 : told(calling.place) + ": " + calling.because;
}

std::string explain_line(const Case& question, const Subject& subject) {
  const std::string brought = subject.brought_by.empty() ? "" : ' ' + subject.brought_by;
  return fmt::format("rayaudit explain --subject {}{} '{}'", subject.name, brought,
                     case_line(question));
}

std::string counted(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(count), noun, count == 1 ? "" : "s");
}

std::string title(const SceneRun& run) {
  const PicturePlan& plan = run.plan;
  const Scene& scene = plan.scene;
  return fmt::format(
      "{}, {} x {}, {} a pixel, {}, {}; {}; offset {}; seed {}", scene.name, scene.film.width,
      scene.film.height, counted(static_cast<std::uint64_t>(std::max(scene.samples, 0)), "sample"),
      counted(scene.primitives.size(), "shape"), counted(scene.lights.size(), "light"),
      plan.subject.name, plan.offset.name.empty() ? "none" : plan.offset.name, plan.seed);
}

std::string rounding(const SceneRun& run) {
  if (!(run.most_moved > 0)) return "";
  return fmt::format(
      "The shapes were rounded to {}: a number moved by up to {} of the largest in its vector{}",
      run.plan.subject.format.name, magnitude(run.most_moved),
      run.moved_shape.empty() ? "" : ", most of the shape at " + run.moved_shape);
}

std::string safe_offset(const SceneAccount& account) {
  if (!leaves_surfaces(account)) return "";
  const SafeOffset& safe = account.safe;
  return fmt::format(
      "The smallest safe offset is a t_min above {} world units, or {} ulps along the normal, of "
      "powers of two; {}",
      at_least(safe.t_min), std::isinf(safe.ulps) ? "no number of" : fmt::format("{}", safe.ulps),
      verdict_on(safe));
}

std::string about_offsets(const SceneAccount& account) {
  return fmt::format(
      "Of {} that leave a surface, begun by each offset: those that meet it again where they left "
      "it, and the true meetings that the offset loses; in world units, the largest. Proved: off "
      "by what is proved of the point, nothing where a subject proves nothing; what its next "
      "answer errs is not in that.",
      counted(account.offsets.front().rays, "ray"));
}

std::string culling(const Culling& culling) {
  if (culling.settled == 0) return "";
  const std::string settled =
      fmt::format("{} of a ray and a shape whose boxes do not meet {} settled exactly",
                  counted(culling.settled, "pair"), culling.settled == 1 ? "was" : "were");
  if (culling.wrong.count == 0) return settled + ": none meets";
  return fmt::format("{}: {} {} and {} wrongly culled", settled, grouped(culling.wrong.count),
                     culling.wrong.count == 1 ? "meets" : "meet",
                     culling.wrong.count == 1 ? "was" : "were");
}

std::string summary(const SceneRun& run) {
  const WaveAccount all = sum(run.picture.account);
  std::string text;
  if (!run.picture.whole) text = "Stopped before the end of the picture: of what was finished, ";
  if (!run.plan.audited) return text + "nothing was audited";
  const std::uint64_t wrong = all.tally.wrong();
  text += fmt::format("{}% of {} about {} answered wrongly",
                      wrong == 0 ? "0" : figures::percent(wrong, all.questions),
                      counted(all.questions, "question"), counted(all.rays, "ray"));
  return text + fmt::format("; {}; {}", counted(all.self_intersections.count, "self-intersection"),
                            counted(all.leaks.count, "leak"));
}

}  // namespace rayaudit::scenes
