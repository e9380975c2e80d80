#include "cli/explain_steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "oracle/replay/replay.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using figures::magnitude;
using replay::Step;

/// The steps that one line took in one go.
using Visit = std::span<const Step>;

bool is_same_line(const Step& a, const Step& b) { return a.line == b.line && a.file == b.file; }

std::vector<Visit> visits(const std::vector<Step>& steps) {
  std::vector<Visit> all;
  for (std::size_t i = 0; i < steps.size();) {
    std::size_t end = i + 1;
    while (end < steps.size() && is_same_line(steps[i], steps[end])) ++end;
    all.emplace_back(steps.data() + i, end - i);
    i = end;
  }
  return all;
}

/// Of a loop the last operation and comparison, and where paths part; of a line of a routine every
/// step; elsewhere, in a dot product say, what comes of it.
bool is_shown(const Visit& visit, const Step& step) {
  if (!step.text.starts_with("while"))
    return step.compares || !step.used || step.file.starts_with("routines/");
  const auto is_later = [&](const Step& other) {
    return &other > &step && other.compares == step.compares;
  };
  return step.parts() || std::none_of(visit.begin(), visit.end(), is_later);
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
  const Step& first = visit.front();
  std::string text = fmt::format("  {}:{}  {}\n", first.file, first.line, first.text);
  for (const Step& step : visit)
    if (is_shown(visit, step))
      text += step.compares ? comparison_text(step, format) : operation_text(step, format);
  return text;
}

}  // namespace

std::string steps_text(const Case& question, const Subject& subject) {
  const replay::Replay* replay = replay::replay_of(subject.name);
  if (replay == nullptr) return subject.name + " cannot be replayed step by step\n";
  const auto run = replay->watched(question, subject.format, -1, replay::Wanted::all);
  if (!run) return subject.name + ": past the work limit of a replay\n";
  std::string text = fmt::format("{}, step by step:\n", subject.name);
  for (const Visit& visit : visits(run->steps)) text += text_of(visit, subject.format);
  return text;
}

}  // namespace rayaudit
