#include <fmt/format.h>

#include <algorithm>

#include "audit/cause.hpp"
#include "cli/case_text.hpp"
#include "cli/command.hpp"
#include "cli/convention_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/explain_steps.hpp"
#include "cli/formats.hpp"
#include "cli/line_of.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/signal_name.hpp"
#include "geometry/unknown_name.hpp"
#include "reports/figures.hpp"
#include "reports/pasted_test.hpp"
#include "subjects/subject.hpp"

namespace rayaudit {
namespace {

using oracle::Truth;

struct ExplainOptions {
  std::vector<std::string> words;
  Format format = double_format;
  std::string subject;  ///< the one to follow step by step, or empty
  SubjectChoice brought;
  Convention convention = {};
  std::optional<PastedAs> as = {};  ///< a test to paste is wanted instead
};

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
      if (answer.signal != 0) return "crashed, " + signal_name(answer.signal);
      std::string text;
      write(text, answer);
      return text;
    }
  }
  return {};
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
    cause = name(diagnosis({settled, answer, judgement, {}}, *subject,
                           replay::replay_of(subject->name), convention)
                     .cause);
  std::string row = fmt::format("{:<28} {:<26} {:<22} {:>8} {:>8}  {:<7} {}", who,
                                shown(answer, format), verdict, figures::magnitude(judgement.ulps),
                                figures::magnitude(judgement.forced), side, cause);
  return row.erase(row.find_last_not_of(' ') + 1) + '\n';
}

/// A case as it is asked, and how that is another than it was; empty where it is the same.
struct Posed {
  Case question;
  std::string how;
};

/// The case of a line as a subject of the format is asked it.
Posed posed_for(const Case& line, const Format& format, const Convention& convention) {
  const auto is_other = [](const Case& a, const Case& b) { return case_line(a) != case_line(b); };
  const Case held = rounded(line, format), question = asked(line, convention, format);
  // Of who takes two points a direction is not rounded, nor a radius of who takes an angle.
  if (!is_other(question, line)) return {question, ""};
  std::string how = is_other(held, line) ? fmt::format("rounded to {}", format.name) : "";
  if (is_other(question, held))
    how += std::string(how.empty() ? "" : " and ") + "posed as the convention has it";
  return {question, how};
}

/// The rows of subjects on the case of a line, and what they were asked that is not quite that.
class Rows {
 public:
  Rows(const Case& line, const Convention& stated) : line_(line), stated_(stated) {}

  /// Where it answers the shape.
  void add(const Subject& subject) {
    if (!subject.answers(line_.shape.index())) return;
    const Convention convention = joined(stated_, subject.convention);
    const auto [question, how] = posed_for(line_, subject.drawn_in(), convention);
    try {
      text_ += judged_row(subject.name, question, answer_one(subject, question), subject.format,
                          convention, &subject);
    } catch (const NoAnswer& why) {
      text_ += row_without_answer(subject, why.what());
    }
    if (!how.empty()) tell(subject.name, how + ": " + case_line(question));
  }

  std::string text() const {
    std::string text = text_;
    for (const auto& [what, names] : otherwise_)
      text += names.size() == 1
                  ? fmt::format("{} is asked the case {}\n", names[0], what)
                  : fmt::format("{} of them are asked the case {}\n", names.size(), what);
    return text;
  }

 private:
  static std::string row_without_answer(const Subject& subject, std::string_view why) {
    if (why.starts_with(subject.name + ' ')) why.remove_prefix(subject.name.size() + 1);
    return fmt::format("{:<28} {}\n", subject.name, why);
  }

  void tell(const std::string& subject, const std::string& what) {
    const auto known = std::find_if(otherwise_.begin(), otherwise_.end(),
                                    [&](const auto& each) { return each.first == what; });
    auto& names = known == otherwise_.end()
                      ? otherwise_.emplace_back(what, std::vector<std::string>()).second
                      : known->second;
    names.push_back(subject);
  }

  const Case& line_;
  const Convention& stated_;
  std::string text_;
  std::vector<std::pair<std::string, std::vector<std::string>>> otherwise_;  ///< what, and by whom
};

/// The rows of those that are asked of every case, and of the one to follow; where there is none,
/// of all that are brought along.
std::string subject_rows(const Case& question, const Subjects& subjects, const Subject* followed,
                         const Convention& convention) {
  Rows rows(question, convention);
  bool is_told = false;
  for (const Subject& subject : built_in_subjects()) {
    rows.add(subject);
    is_told = is_told || (followed != nullptr && subject.name == followed->name);
  }
  if (followed == nullptr)
    for (const Subject& subject : subjects.brought()) rows.add(subject);
  else if (!is_told)
    rows.add(*followed);
  return rows.text();
}

/// One subject on the case of a line: the cause of its answer in full, and its steps.
std::string followed(const Case& line, const Subject& subject, const Convention& stated) {
  const Convention convention = joined(stated, subject.convention);
  if (!subject.answers(line.shape.index()))
    throw Error(fmt::format("--subject: {} does not answer a {}", subject.name, name(line.shape)));
  const Case question = asked(line, convention, subject.drawn_in());
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

/// A test of the case as it is asked, in the format asked for, or that of the subject.
std::string pasted(const ExplainOptions& options, const CaseLine& line, const Subject* subject) {
  const Format& format = subject != nullptr ? subject->format : options.format;
  const Convention convention =
      subject != nullptr ? joined(options.convention, subject->convention) : options.convention;
  if (format.precision > long_double_format.precision)
    throw Error(fmt::format("--as: {} has no literals in C; --format names another", format.name));
  const auto [question, how] =
      posed_for(line.question, format == float_format ? float_format : double_format, convention);
  std::string why(line.why);
  if (!how.empty()) why += (why.empty() ? "" : "; ") + how;
  return pasted_test(question, why, *options.as, format, convention);
}

int explain(const ExplainOptions& options) {
  const std::string line = line_of(options.words);
  Subjects subjects(options.brought);
  const Subject* subject = options.subject.empty() ? nullptr : &subjects.named(options.subject);
  const CaseLine read = read_case_line(line);
  if (options.as) {
    print(pasted(options, read, subject));
    return all_held;
  }
  const auto& [question, answer, why, words] = read;
  std::string text = question_text(question);
  if (!why.empty()) text += row("why", why);
  text += truth_text(question, oracle::truth(question));
  text += fmt::format("\n{:<28} {:<26} {:<22} {:>8} {:>8}  {:<7} {}\n", "subject", "answer",
                      "verdict", "ulps", "forced", "side", "cause");
  const Format& format = subject != nullptr ? subject->format : options.format;
  Convention convention = options.convention;
  if (subject != nullptr) convention = joined(convention, subject->convention);
  if (answer)
    text += judged_row(fmt::format("the line, in {}", format.name), question, *answer, format,
                       convention, nullptr);
  text += subject_rows(question, subjects, subject, options.convention);
  try {
    if (subject != nullptr) text += '\n' + followed(question, *subject, options.convention);
  } catch (const NoAnswer&) {
    print(text);
    throw;
  }
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
             [=](const std::string& text) { options->subject = text; });
  add_bringers(*command, options->brought, "its answer is shown too, and --subject may name it");
  add_option(*command, "--convention", "KIND=STANCE,...",
             "what is declared, as tangent=hit,inside=miss",
             [=](const std::string& text) { options->convention = read_convention(text); });
  add_option(*command, "--format", "FORMAT",
             "of the answer on the line, and of a program: float, double or long_double",
             [=](const std::string& text) {
               options->format = options->brought.format = known_format(text);
             })
      ->default_str("double");
  add_option(*command, "--as", "KIND",
             "a test to paste instead, for boost, gtest, catch2 or c, in the format",
             [=](const std::string& text) {
               options->as =
                   PastedAs{static_cast<int>(place_of("kind of test", text, pasted_names))};
             });
  command->footer(
      "Examples:\n"
      "  rayaudit explain 'sphere 0 0 0 1 ray 0 0 -3 0 0 1'\n"
      "  rayaudit explain --format float 'sphere 0 0 0 1 ray 0 0.5 -3 0 0 1 hit 2.125'\n"
      "  rayaudit explain --subject textbook/float 'sphere 0 0 0 1 ray 0 1 -1024 0 0 1'\n"
      "  rayaudit explain data/cases/tangent.txt:12\n"
      "  rayaudit explain --as gtest --format float found.txt:3\n"
      "  rayaudit explain --subject mine/double --plugin ./libmine.so data/cases/tangent.txt:12\n");
  command->callback([=, &asked] {
    options->words = case_words(*command);
    asked = [options] { return explain(*options); };
  });
}

}  // namespace rayaudit
