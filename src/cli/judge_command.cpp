#include <fmt/format.h>

#include <cmath>

#include "audit/tally.hpp"
#include "cli/command.hpp"
#include "cli/convention_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/fail_on.hpp"
#include "cli/formats.hpp"
#include "cli/lines.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;

struct JudgeOptions {
  std::string file;
  Format format = double_format;
  Convention convention;
  FailOn fail_on;
  bool each = false;
};

/// What was judged, and with --each the lines with their verdicts.
struct Judged {
  Tally tally;                ///< the place of a case is its line
  std::uint64_t outside = 0;  ///< cases with numbers that are none of the format
  std::string text;

  void merge(const Judged& other) {
    tally.merge(other.tally);
    outside += other.outside;
  }
};

void write_judged(std::string& text, const Line& line, const Judgement& judgement) {
  (text += line.text) += " # ";
  text += name(judgement.verdict);
  if (judgement.claim != Claim::none) (text += ' ') += name(judgement.claim);
  if (!std::isnan(judgement.ulps)) text += fmt::format(" {} ulps", magnitude(judgement.ulps));
}

Judged judged(std::span<const Line> lines, const JudgeOptions& options) {
  std::vector<Case> cases;
  for (const Line& line : lines)
    if (line.read) cases.push_back(line.read->question);
  std::vector<oracle::Truth> truths(cases.size());
  oracle::truth(cases, truths, oracle::bits_for(options.format));
  Judged judged;
  std::size_t place = 0;
  for (const Line& line : lines) {
    if (line.read) {
      const Answer& answer = *line.read->answer;
      Settled settled(cases[place], truths[place]);
      const Judgement judgement = judge(settled, answer, options.format, options.convention);
      const double margin = is_wrong(judgement.verdict)
                                ? std::ldexp(settled.reach(), options.format.precision)
                                : Judgement::unmeasured;
      judged.tally.add(settled, answer, judgement, line.number, margin);
      judged.outside += is_in(cases[place], options.format) ? 0 : 1;
      if (options.each) write_judged(judged.text, line, judgement);
      ++place;
    } else if (options.each) {
      judged.text += line.text;
    }
    if (options.each) judged.text += '\n';
  }
  return judged;
}

std::string verdict_lines(const Tally& tally) {
  std::string text;
  for (std::size_t i = 0; i < verdict_count; ++i) {
    if (tally.verdicts[i] == 0) continue;
    text +=
        fmt::format("  {:<19}{:>15}{:>8} %\n", name(static_cast<Verdict>(i)),
                    grouped(tally.verdicts[i]), figures::percent(tally.verdicts[i], tally.cases));
  }
  if (tally.wrong() == 0)
    text += fmt::format("  0 of {} wrong: < {} % at 95 %\n", grouped(tally.cases),
                        magnitude(300 / static_cast<double>(tally.cases)));
  return text;
}

std::string error_line(std::string_view what, const Histogram& errors) {
  if (errors.count() == 0) return {};
  return fmt::format("  {:<34}p50 {:<8}p99 {:<8}max {}\n", what, magnitude(errors.quantile(0.5)),
                     magnitude(errors.quantile(0.99)), magnitude(errors.largest()));
}

std::string touch_lines(const Tally& tally) {
  std::string text;
  for (std::size_t i = 0; i < tally.touches.size(); ++i) {
    const auto& [taken, passed] = tally.touches[i];
    if (taken + passed == 0) continue;
    text += fmt::format("  touch {:<13}taken in {} of {}\n", name(static_cast<oracle::Kind>(i)),
                        grouped(taken), grouped(taken + passed));
  }
  return text;
}

std::string worst_lines(const Tally& tally, const Format& format) {
  std::string text;
  for (const auto& [verdict, claim, count, worst, causes, beyond] : tally.outcomes) {
    if (!worst || !is_wrong(verdict)) continue;
    text += fmt::format("\n{}{}, line {}, margin {} u:\n  {}\n", name(verdict),
                        claim == Claim::none ? "" : " (" + std::string(name(claim)) + ")",
                        worst->place, magnitude(worst->severity), explain_line(*worst, format));
  }
  return text;
}

std::string summary(const Judged& judged, const std::string& file, const Format& format) {
  const Tally& tally = judged.tally;
  std::string text =
      fmt::format("{}: {} cases judged in {}\n", file, grouped(tally.cases), format.name);
  if (judged.outside > 0)
    text += fmt::format(
        "  {} of them have numbers that are no {}s: was it this case that was answered?\n",
        grouped(judged.outside), format.name);
  text += verdict_lines(tally);
  text += error_line("error of t, ulps", tally.ulps);
  text += error_line("error of t, forced errors", tally.forced);
  text += error_line("distance of the point, ulps", tally.distance);
  return text + touch_lines(tally) + worst_lines(tally, format);
}

int judge_lines(const JudgeOptions& options) {
  LineFile file(options.file);
  Judged all;
  work_through(
      file, Answers::required, [&](std::span<const Line> lines) { return judged(lines, options); },
      [&](const Judged& judged) {
        all.merge(judged);
        print(judged.text);
      });
  if (all.tally.cases == 0) throw NothingAudited(file.name() + " has no case to judge");
  if (!options.each) print(summary(all, file.name(), options.format));
  const auto broken = breach(options.fail_on, all.tally);
  if (!broken) return all_held;
  complain(fmt::format("--fail-on: {}:{}: {}: {}", file.name(), broken->worst->place, broken->words,
                       explain_line(*broken->worst, options.format)));
  return found;
}

}  // namespace

void add_judge_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<JudgeOptions>();
  CLI::App* command = program.add_subcommand("judge", "Judge case lines with answers");
  command->add_option("FILE", options->file, "case lines; standard input where there is none")
      ->type_name("");
  add_option(*command, "--format", "FORMAT", "what answered: float, double or long_double",
             [=](const std::string& text) { options->format = known_format(text); })
      ->default_str("double");
  add_option(*command, "--convention", "KIND=STANCE,...",
             "what is declared of touches, as tangent=hit,rim=miss",
             [=](const std::string& text) { options->convention = read_convention(text); });
  add_option(*command, "--fail-on", "VERDICT,...",
             "exit 1 where one of these occurs; also max_ulp=N",
             [=](const std::string& text) { options->fail_on = read_fail_on(text); });
  command->add_flag("--each", options->each, "write every line with its verdict, no summary");
  command->footer(
      "A line is a case and what was answered: `hit T`, `at X Y Z`, `yes` or `miss`.\n"
      "What `rayaudit truth` says is one too: a `touch` is passed over, `invalid` is a miss.\n\n"
      "Examples:\n"
      "  rayaudit draw --shape sphere --family far --count 1e5 | ./mine | rayaudit judge\n"
      "  rayaudit judge answers.txt --format float --fail-on false_hit,false_miss,max_ulp=4\n");
  command->callback([=, &asked] { asked = [options] { return judge_lines(*options); }; });
}

}  // namespace rayaudit
