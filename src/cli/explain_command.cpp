#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>

#include "audit/cause.hpp"
#include "cli/command.hpp"
#include "cli/convention_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/explain_steps.hpp"
#include "cli/formats.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"
#include "reports/figures.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {
namespace {

using oracle::Crossing;
using oracle::Kind;
using oracle::Truth;

constexpr int shown_digits = 40;

struct ExplainOptions {
  std::vector<std::string> words;
  Format format = double_format;
  const Subject* subject = nullptr;  ///< the one to follow step by step
  Convention convention = {};
};

struct Place {
  std::string file;
  std::uint64_t line;
};

/// FILE:LINE, where it is that.
std::optional<Place> place_in_file(const std::string& word) {
  const std::size_t colon = word.rfind(':');
  if (colon == word.npos || colon == 0) return std::nullopt;
  Place place = {word.substr(0, colon), 0};
  const char* end = word.data() + word.size();
  const auto [last, fault] = std::from_chars(word.data() + colon + 1, end, place.line);
  if (fault != std::errc() || last != end || place.line == 0) return std::nullopt;
  return place;
}

std::string line_at(const Place& place) {
  std::ifstream file(place.file);
  const auto unreadable = [&] {
    return Error("`" + place.file + "` cannot be read: " + std::strerror(errno));
  };
  if (!file) throw unreadable();
  std::string line;
  std::uint64_t number = 0;
  while (number < place.line && std::getline(file, line)) ++number;
  if (file.bad()) throw unreadable();
  if (number < place.line)
    throw Error(fmt::format("`{}` has no line {}, only {}", place.file, place.line, number));
  if (is_blank(line)) throw Error(fmt::format("{}:{}: no case here", place.file, place.line));
  return line;
}

std::string joined(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) (line += line.empty() ? "" : " ") += word;
  return line;
}

template <class N>
std::string shown(const Vec3<N>& v, std::string (*show)(const N&)) {
  return "(" + show(v.x) + ", " + show(v.y) + ", " + show(v.z) + ")";
}
std::string shown(const double& x) { return fmt::format("{}", x); }
std::string shown(const Vec3<double>& v) { return shown<double>(v, shown); }

/// In decimals, as many as tell it from its neighbours in the format.
std::string shown(const Real& x, const Format& format) {
  if (format == float_format) return fmt::format("{}", nearest<float>(x));
  if (format == double_format) return fmt::format("{}", nearest<double>(x));
  return fmt::format("{}", nearest<long double>(x));
}

std::string shown(const Answer& answer, const Format& format) {
  const auto in_format = [&](const Real& x) { return shown(x, format); };
  switch (answer.form) {
    case Answer::Form::miss:
      return "miss";
    case Answer::Form::yes:
      return "yes";
    case Answer::Form::hit:
      return "hit " + in_format(answer.t);
    case Answer::Form::at:
      return "at " + in_format(answer.point.x) + " " + in_format(answer.point.y) + " " +
             in_format(answer.point.z);
    default: {  // what stands in place of an answer
      std::string text;
      write(text, answer);
      return text;
    }
  }
  return {};
}

std::string row(std::string_view label, std::string_view text) {
  return fmt::format("{:<10}{}\n", label, text);
}

std::string shape_text(const Shape& any) {
  return std::visit(
      [](const auto& shape) {
        std::string text;
        std::size_t i = 0;
        const auto add = [&](const auto& part) {
          text += fmt::format("{}{} {}", i == 0 ? "" : "  ", shape.labels[i], shown(part));
          ++i;
        };
        std::apply([&](const auto&... part) { (add(part), ...); }, shape.parts());
        return row(shape.name, text);
      },
      any);
}

std::string ray_text(const Ray<double>& ray) {
  return row("ray", fmt::format("origin {}  direction {}  range ({}, {})", shown(ray.origin),
                                shown(ray.direction), ray.t_min, ray.t_max));
}

/// `t = (3 + sqrt(5)) / 2` and below it the digits and the nearest double.
std::string t_text(std::string_view label, const oracle::Spelled& t, double nearest_double) {
  const std::string indent(17, ' ');
  std::string text;
  if (t.closed_form) text += fmt::format("{}{}\n", label, *t.closed_form);
  const std::string digits = t.decimals + (t.terminates ? "" : "...");
  if (!t.closed_form || digits != *t.closed_form)
    text += fmt::format("{}{}\n", t.closed_form ? indent + "  = " : std::string(label), digits);
  std::string hex;
  write(hex, nearest_double);
  return text + fmt::format("{}  nearest double {} = {}\n", indent, nearest_double, hex);
}

std::string crossing_text(const Case& question, const Crossing& crossing) {
  const bool proper = crossing.kind == Kind::proper;
  const std::string what = proper ? "hit" : "touch, " + std::string(name(crossing.kind));
  std::string text =
      t_text(fmt::format("  {:<15}t = ", what), oracle::spelled(question, crossing, shown_digits),
             oracle::rounded<double>(question, crossing));
  if (crossing.kind == Kind::within)
    text += t_text(fmt::format("  {:<15}t = ", "  ... up to"),
                   oracle::spelled_last(question, crossing, shown_digits),
                   oracle::rounded_last<double>(question, crossing));
  return text;
}

std::string other_root_text(const oracle::Root& root) {
  return fmt::format("  {:<15}t = {}\n", name(root.standing), shown(root.t, double_format));
}

/// What a move by the margin would turn.
std::string sentence(const oracle::Margin& margin) {
  const std::string what = [&]() -> std::string {
    switch (margin.sign) {
      case oracle::Sign::discriminant:
        return "whether the line meets the surface";
      case oracle::Sign::start:
        return "whether the ray begins before it";
      case oracle::Sign::end:
        return "whether the ray ends before it";
      case oracle::Sign::side:
        return "whether it lies inside the rim";
      default:
        return "";
    }
  }();
  return margin.together > 1 ? what + ", with others" : what;
}

const Subject& known_subject(const std::string& text) {
  const auto& subjects = all_subjects();
  return subjects[place_of("subject", text, names_of(subjects, &Subject::name))];
}

std::string_view reason(oracle::Invalid invalid) {
  static constexpr std::array<std::string_view, 8> reasons = {
      "",
      "a number is NaN",
      "a number is infinite",
      "the direction is 0",
      "the normal is 0",
      "base and top are the same point",
      "the radius is not above 0",
      "the range is empty",
  };
  return reasons[static_cast<std::size_t>(invalid)];
}

/// How far from another truth, in u of each format, and what would turn first.
std::string margin_text(const Case& question, const Truth& truth) {
  const oracle::Margin margin = oracle::margin(question, truth);
  if (margin.sign == oracle::Sign::touch) return row("margin", "0, for there is a touch");
  if (std::isinf(margin.reach)) return row("margin", "none: no move changes the truth");
  const auto in = [&](const Format& format) {
    return figures::magnitude(std::ldexp(margin.reach, format.precision));
  };
  return row("margin",
             fmt::format("{} u in float, {} in double, {} in long double: {}", in(float_format),
                         in(double_format), in(long_double_format), sentence(margin)));
}

std::string truth_text(const Case& question, const Truth& truth) {
  if (truth.invalid != oracle::Invalid::no)
    return row("truth", fmt::format("none, the case is invalid: {}", reason(truth.invalid)));
  const bool by_interval = truth.stage == oracle::Stage::interval;
  std::string text =
      row("truth",
          fmt::format("{}{} (decided by {})", truth.hit() ? "a hit" : "a miss",
                      truth.has_touch() ? ", or the touch before it, as convention has it" : "",
                      by_interval ? "intervals" : "exact numbers"));
  for (const Crossing& crossing : truth.crossings()) text += crossing_text(question, crossing);
  text += margin_text(question, truth);
  std::string others;
  const oracle::Roots roots = oracle::roots(question);
  for (const oracle::Root& root : roots.roots())
    if (root.standing != oracle::Standing::acceptable) others += other_root_text(root);
  return others.empty() ? text : text + "other roots, no answers:\n" + others;
}

/// An answer with its verdict; and its cause, where it is the answer of a subject.
std::string judged_row(const std::string& who, const Case& question, const Answer& answer,
                       const Format& format, const Convention& convention, const Subject* subject) {
  const Truth truth = oracle::truth(question, oracle::bits_for(format));
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, format, convention);
  std::string verdict(name(judgement.verdict));
  if (judgement.claim != Claim::none) (verdict += " ") += name(judgement.claim);
  const std::string side =
      judgement.side == Side::unknown ? "-" : std::string(name(judgement.side));
  std::string cause;
  if (subject != nullptr && (is_wrong(judgement.verdict) || judgement.verdict == Verdict::touch))
    cause = name(
        diagnosis({settled, answer, judgement, {}}, *subject, replay::replay_of(subject->name), {})
            .cause);
  std::string row = fmt::format("{:<28} {:<26} {:<22} {:>8} {:>8}  {:<7} {}", who,
                                shown(answer, format), verdict, figures::magnitude(judgement.ulps),
                                figures::magnitude(judgement.forced), side, cause);
  return row.erase(row.find_last_not_of(' ') + 1) + '\n';
}

std::string subject_rows(const Case& question, const Convention& convention) {
  const std::size_t shape = question.shape.index();
  const bool floats = is_in(question, float_format);
  std::string text;
  for (const Subject& subject : built_in_subjects()) {
    if (!subject.answers(shape) || (subject.format == float_format && !floats)) continue;
    text += judged_row(subject.name, question, answer_one(subject, question), subject.format,
                       convention, &subject);
  }
  if (!floats) text += "subjects in float are not asked: the case has numbers that are no floats\n";
  return text;
}

/// One subject on a case: the cause of its answer in full, and its steps.
std::string followed(const Case& question, const Subject& subject, const Convention& convention) {
  if (!subject.answers(question.shape.index()))
    throw Error(
        fmt::format("--subject: {} does not answer a {}", subject.name, name(question.shape)));
  const Answer answer = answer_one(subject, question);
  const Truth truth = oracle::truth(question, oracle::bits_for(subject.format));
  Settled settled(question, truth);
  const Judgement judgement = judge(settled, answer, subject.format, convention);
  std::string text;
  if (is_wrong(judgement.verdict) || judgement.verdict == Verdict::touch) {
    const Diagnosis found = diagnosis({settled, answer, judgement, {}}, subject,
                                      replay::replay_of(subject.name), convention);
    text += row("cause", told(found));
    if (found.turned) text += row("", std::string(found.turned->text));
    if (found.cause == Cause::rounding)
      text += row("", "no one comparison, answered the other way, mends it");
  }
  return text + steps_text(question, subject);
}

/// The line that is asked about: the words, or what stands at the place that the only word names.
std::string line_of(const std::vector<std::string>& words) {
  constexpr const char* wanted = "explain: expected a case line or FILE:LINE";
  constexpr const char* counted = "; lines count from 1";
  if (words.empty()) throw Error(std::string(wanted) + counted);
  if (words.size() > 1) return joined(words);
  const std::string& word = words[0];
  if (const auto place = place_in_file(word)) return line_at(*place);
  if (word.find_first_of(" \t") == word.npos)
    throw Error(std::string(wanted) + ", got " + quotation(word) + counted);
  return word;
}

int explain(const ExplainOptions& options) {
  const std::string line = line_of(options.words);
  const auto& [question, answer, why, words] = read_case_line(line);
  std::string text = shape_text(question.shape) + ray_text(question.ray);
  if (!why.empty()) text += row("why", why);
  text += truth_text(question, oracle::truth(question));
  text += fmt::format("\n{:<28} {:<26} {:<22} {:>8} {:>8}  {:<7} {}\n", "subject", "answer",
                      "verdict", "ulps", "forced", "side", "cause");
  const Format& format = options.subject != nullptr ? options.subject->format : options.format;
  if (answer)
    text += judged_row(fmt::format("the line, in {}", format.name), question, *answer, format,
                       options.convention, nullptr);
  text += subject_rows(question, options.convention);
  if (options.subject != nullptr)
    text += '\n' + followed(question, *options.subject, options.convention);
  print(text);
  return all_held;
}

/// The words of a case begin with signs at times, so they come as what the command does not know.
std::vector<std::string> case_words(const CLI::App& command) {
  std::vector<std::string> words = command.remaining();
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) names.push_back(option->get_name());
  const std::vector<std::string_view> known(names.begin(), names.end());
  for (const std::string& word : words)
    if (word.starts_with("--")) throw Error(unknown_name("option", word, known));
  return words;
}

}  // namespace

void add_explain_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<ExplainOptions>();
  CLI::App* command = program.add_subcommand(
      "explain", "Show one case, CASE-LINE or FILE:LINE: its truth and all answers to it");
  command->allow_extras();
  add_option(*command, "--subject", "ROUTINE/NUMBER", "follow this one step by step",
             [=](const std::string& text) { options->subject = &known_subject(text); });
  add_option(*command, "--convention", "KIND=STANCE,...",
             "what is declared of touches, as tangent=hit,rim=miss",
             [=](const std::string& text) { options->convention = read_convention(text); });
  add_option(*command, "--format", "FORMAT",
             "of the answer on the line: float, double or long_double",
             [=](const std::string& text) { options->format = known_format(text); })
      ->default_str("double");
  command->footer(
      "Examples:\n"
      "  rayaudit explain 'sphere 0 0 0 1 ray 0 0 -3 0 0 1'\n"
      "  rayaudit explain --format float 'sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 hit 2.125'\n"
      "  rayaudit explain --subject textbook/float 'sphere 0 0 0 1 ray 0 1 -1024 0 0 1'\n"
      "  rayaudit explain data/cases/tangent.txt:12\n");
  command->callback([=, &asked] {
    options->words = case_words(*command);
    asked = [options] { return explain(*options); };
  });
}

}  // namespace rayaudit
