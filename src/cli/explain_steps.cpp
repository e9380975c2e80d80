#include "cli/explain_steps.hpp"

#include <fmt/format.h>

#include <span>
#include <vector>

#include "oracle/replay/replay.hpp"
#include "reports/figures.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::magnitude;
using replay::Step;

/// The steps that one line took in one go.
using Visit = std::span<const Step>;

bool is_same_line(const Step& a, const Step& b) { return a.line == b.line && a.file == b.file; }

bool is_loop(const Visit& visit) { return visit.front().text.starts_with("while"); }

bool parts(const Visit& visit) {
  for (const Step& step : visit)
    if (step.parts()) return true;
  return false;
}

/// The visits of lines in order; of the rounds of a loop the last alone, and those where paths
/// part.
std::vector<Visit> visits(const std::vector<Step>& steps) {
  std::vector<Visit> all;
  for (std::size_t i = 0; i < steps.size();) {
    std::size_t end = i + 1;
    while (end < steps.size() && is_same_line(steps[i], steps[end]) &&
           !steps[end].compares == !steps[i].compares)
      ++end;
    const Visit visit(steps.data() + i, end - i);
    const bool again = !all.empty() && is_loop(visit) && is_same_line(all.back()[0], steps[i]) &&
                       !parts(all.back());
    if (again && all.back()[0].compares == steps[i].compares) all.pop_back();
    if (again && all.size() > 1 && is_same_line(all[all.size() - 2][0], steps[i]) &&
        !parts(all[all.size() - 2]))
      all.erase(all.end() - 2);
    all.push_back(visit);
    i = end;
  }
  return all;
}

std::string in_format(const Real& x, const Format& format) {
  if (format == float_format) return fmt::format("{}", nearest<float>(x));
  if (format == double_format) return fmt::format("{}", nearest<double>(x));
  return fmt::format("{}", nearest<long double>(x));
}

std::string exactly(const Real& x) { return fmt::format("{:.20g}", nearest<long double>(x)); }

std::string operation_text(const Step& step, const Format& format) {
  const std::string value = in_format(step.value, format);
  if (!step.defined)
    return fmt::format(
        "    {:<4} {:<24} exactly: no value, after a root or a division without one\n",
        step.operation, value);
  const double off = ulps(step.value, step.exact, format);
  const double bound = scaled({step.bound, 0, 0, 0}, spacing_exponent(step.exact, format));
  return fmt::format("    {:<4} {:<24} exactly {:<26} {:>9} ulps off, {:>8} at most\n",
                     step.operation, value, exactly(step.exact), magnitude(off), magnitude(bound));
}

std::string comparison_text(const Step& step, const Format& format) {
  const auto word = [](bool answer) { return answer ? "yes" : "no"; };
  std::string text = fmt::format("    {} {} {}: {}", in_format(step.value, format), step.operation,
                                 in_format(step.right, format), word(step.said));
  if (!step.defined)
    text += ", exactly undefined";
  else if (step.parts())
    text += fmt::format(", but exactly {} {} {}: {}   <-- the paths part", exactly(step.exact),
                        step.operation, exactly(step.exact_right), word(step.exactly));
  else
    text += step.proved ? ", proved" : ", exactly so too";
  return text + '\n';
}

std::string text_of(const Visit& visit, const Format& format) {
  std::string text;
  for (const Step& step : visit) {
    if (step.compares)
      text += comparison_text(step, format);
    else if (!step.used || step.file.starts_with("routines/"))
      text += operation_text(step, format);
  }
  return text;
}

}  // namespace

std::string steps_text(const Case& question, const Subject& subject) {
  const replay::Replay* replay = replay::replay_of(subject.name);
  if (replay == nullptr) return subject.name + " cannot be replayed step by step\n";
  const auto run = replay->watched(question, subject.format, -1, replay::Wanted::all);
  if (!run) return subject.name + ": past the work limit of a replay\n";
  std::string text = fmt::format("{}, step by step:\n", subject.name);
  const Step* last = nullptr;
  for (const Visit& visit : visits(run->steps)) {
    const Step& first = visit.front();
    if (last == nullptr || !is_same_line(*last, first))
      text += fmt::format("  {}:{}  {}\n", first.file, first.line, first.text);
    text += text_of(visit, subject.format);
    last = &first;
  }
  return text;
}

}  // namespace rayaudit
