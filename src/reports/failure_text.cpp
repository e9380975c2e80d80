#include "reports/failure_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/case_line.hpp"
#include "geometry/signal_name.hpp"
#include "reports/figures.hpp"
#include "reports/sentence.hpp"

namespace rayaudit {
namespace {

using figures::magnitude;
using oracle::Crossing;
using oracle::Kind;

/// Below so many u a verdict may turn by rounding the numbers of the case once or twice.
constexpr double excusable = 4;

std::string row(std::string_view label, std::string_view text) {
  return fmt::format("{:<9}{}\n", label, text);
}

template <class N>
std::string spelled(N x) {
  std::string hex;
  write(hex, real(x));
  const std::string text = fmt::format("{}", x);
  return std::isfinite(x) ? fmt::format("{} ({})", hex, text) : hex;
}

template <class N>
bool is_in(const Real& x) {
  return !is_finite(x) || compare(real(nearest<N>(x)), x) == 0;
}

/// In hex, and in decimals that tell it from its neighbours in the format.
std::string spelled(const Real& x, const Format& format) {
  if (format == float_format && is_in<float>(x)) return spelled(nearest<float>(x));
  if (format != long_double_format && is_in<double>(x)) return spelled(nearest<double>(x));
  return spelled(nearest<long double>(x));
}

std::string got(const Answer& answer, const Format& format) {
  if (answer.form == Answer::Form::hit) return "hit " + spelled(answer.t, format);
  std::string text;
  write(text, answer);
  if (answer.signal != 0) text += fmt::format(" by {}", signal_name(answer.signal));
  return text;
}

/// The exact t, rounded to the format; of a stretch both ends.
template <class N>
std::string t_in(const Case& question, const Crossing& crossing) {
  std::string t = spelled(oracle::rounded<N>(question, crossing));
  if (crossing.kind != Kind::within) return t;
  return t + " to " + spelled(oracle::rounded_last<N>(question, crossing));
}
std::string t_in(const Case& question, const Crossing& crossing, const Format& format) {
  if (format == float_format) return t_in<float>(question, crossing);
  if (format == double_format) return t_in<double>(question, crossing);
  return t_in<long double>(question, crossing);
}

std::string told(const Case& question, const oracle::Truth& truth, const Format& format) {
  if (truth.invalid != oracle::Invalid::no)
    return fmt::format("invalid: {}", figures::words(name(truth.invalid)));
  std::string text;
  for (const Crossing& crossing : truth.crossings()) {
    const bool is_hit = crossing.kind == Kind::proper;
    text += fmt::format("{}{} {}", text.empty() ? "" : ", then ",
                        is_hit ? "hit" : fmt::format("touch {}", name(crossing.kind)),
                        t_in(question, crossing, format));
  }
  if (truth.hit() == nullptr) text += text.empty() ? "miss" : ", then miss";
  return text;
}

std::string verdict_words(const Judgement& judgement, double max_ulp) {
  std::string text(name(judgement.verdict));
  if (judgement.claim != Claim::none) text += fmt::format(" ({})", name(judgement.claim));
  if (is_wrong(judgement.verdict))
    return fmt::format("{}: {}{}", text, sentence(judgement.verdict), sentence(judgement.claim));
  if (agrees(judgement, max_ulp)) return text;
  return fmt::format("{}, but t is off by more than the {} ulp allowed", text, magnitude(max_ulp));
}

std::string error_words(const Judgement& judgement, const Format& format) {
  std::string text = fmt::format("{} ulp of {}", magnitude(judgement.ulps), format.name);
  if (!std::isnan(judgement.relative) && judgement.relative > 0)
    text += fmt::format(", {} of t", magnitude(judgement.relative));
  if (!std::isnan(judgement.forced))
    text += fmt::format(", {} times what rounding the case would do", magnitude(judgement.forced));
  return text;
}

std::string margin_words(double margin, const Format& format) {
  if (margin == 0) return "0: there is a touch, and any rounding changes the truth";
  return fmt::format("{} u in {}: {}", magnitude(margin), format.name,
                     margin < excusable ? "rounding the numbers of the case may excuse it"
                                        : "no rounding of the case excuses it");
}

/// Would t be right if the direction had length 1?
bool takes_direction_for_unit(const Case& question, const Answer& answer, const Format& format) {
  if (answer.form != Answer::Form::hit) return false;
  const Case unit = posed(question, {.unit_direction = true}, double_format);
  const Judgement judgement = judge(unit, answer, format);
  return judgement.verdict == Verdict::right && judgement.relative < 0x1p-10;
}

/// What an answer alone shows of its cause; empty where it shows none.
std::string_view cause_words(Settled& settled, const Answer& answer, const Judgement& judgement,
                             const Format& format) {
  if (judgement.verdict == Verdict::touch) return "convention: mathematics leaves it open";
  if (judgement.claim == Claim::declined) return "convention: declared to be a miss";
  if (judgement.claim == Claim::centre || judgement.claim == Claim::origin)
    return "formula, it seems: a point stands for \"no hit\"";
  const bool is_off = judgement.verdict == Verdict::wrong_t ||
                      judgement.verdict == Verdict::wrong_root || judgement.claim == Claim::no_root;
  if (is_off && takes_direction_for_unit(settled.question(), answer, format))
    return "assumption, it seems: t is right for a direction of length 1, which this is not";
  return "";
}

/// What of a convention the judge goes by, as --convention takes it.
std::string stated(const Convention& convention) {
  using Stance = Convention::Stance;
  std::string text;
  const auto state = [&](std::string_view what, std::string_view is) {
    text += fmt::format("{}{}={}", text.empty() ? "--convention " : ",", what, is);
  };
  for (std::size_t kind = 1; kind < convention.stances.size(); ++kind)
    if (const Stance stance = convention.stances[kind]; stance != Stance::either)
      state(name(static_cast<Kind>(kind)), stance == Stance::hit ? "hit" : "miss");
  if (convention.inside != Convention::Inside::hit) state("inside", name(convention.inside));
  return text.empty() ? text : text + ' ';
}

std::string command(const Case& question, const Answer& answer, const Format& format,
                    const Convention& convention) {
  std::string line = case_line(question) + ' ';
  write(line, answer);
  const std::string option =
      format == double_format ? "" : fmt::format("--format {} ", format.name);
  return fmt::format("rayaudit explain {}{}'{}'", option, stated(convention), line);
}

}  // namespace

bool agrees(const Judgement& judgement, double max_ulp) {
  const bool is_far = max_ulp > 0 && judgement.ulps > max_ulp;
  return !is_wrong(judgement.verdict) && !is_far;
}

std::string failure_text(const JudgedAnswer& judged) {
  const auto& [question, answer, format, judgement, margin, max_ulp, cause, repeats, command] =
      judged;
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(format));
  std::string text = row("case", case_line(question)) + row("got", got(answer, format)) +
                     row("truth", told(question, truth, format)) +
                     row("verdict", verdict_words(judgement, max_ulp));
  if (!std::isnan(judgement.ulps)) text += row("error", error_words(judgement, format));
  if (!std::isnan(margin)) text += row("margin", margin_words(margin, format));
  if (!cause.empty()) text += row("cause", cause);
  if (!repeats) text += row("again", "not reproducible: asked alone it was not so wrong");
  return text + row("explain", command);
}

std::string failure_text(const Case& question, const Answer& answer, const Format& format,
                         const Convention& convention, double max_ulp) {
  const oracle::Truth truth = oracle::truth(question, oracle::bits_for(format));
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, format, convention);
  return failure_text({.question = question,
                       .answer = answer,
                       .format = format,
                       .judgement = judgement,
                       .margin = std::ldexp(settled.reach(), format.precision),
                       .max_ulp = max_ulp,
                       .cause = std::string(cause_words(settled, answer, judgement, format)),
                       .command = command(question, answer, format, convention)});
}

}  // namespace rayaudit
