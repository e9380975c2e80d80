#include "subjects/program.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cctype>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/glob.hpp"
#include "geometry/quotation.hpp"
#include "subjects/answer_lines.hpp"
#include "subjects/ending.hpp"
#include "subjects/libraries/libraries.hpp"
#include "subjects/program_run.hpp"

namespace rayaudit {
namespace {

using std::chrono::milliseconds;

/// So many cases of a batch that a program dies or hangs over are found; the rest is unasked.
constexpr int most_broken = 4;
/// After so many runs that hung, only single cases are put to the program.
constexpr int most_hung = 60;
/// So much less patience is there for a part of a batch that hung: what is found is asked again.
constexpr int haste = 4;

/// A case of each shape that no program should find hard.
constexpr std::array<std::string_view, shape_count> easy_cases = {
    "disk 0 0 0 0 0 1 1 ray 0.25 0.25 -3 0 0 1",
    "sphere 0 0 0 1 ray 0.25 0.25 -3 0 0 1",
    "cylinder 0 0 0 0 1 0 1 ray 0.25 0.25 -3 0 0 1",
    "cone 0 0 0 0 1 0 1 ray 0.25 0.25 -3 0 0 1",
    "capped_cylinder 0 0 0 0 1 0 1 ray 0.25 0.25 -3 0 0 1",
    "capped_cone 0 0 0 0 1 0 1 ray 0.25 0.25 -3 0 0 1"};

/// A run broke off before all answers were there.
struct Broken {
  Answer answer;  ///< what stands in place of one
  std::string what;
};

/// What came of putting cases to a program: answers to all of them, or to so many.
struct Attempt {
  std::size_t answered = 0;
  std::optional<Broken> broken = {};
};

/// Sorts out how a run ended; throws Fault where that is no case's doing.
std::optional<Broken> broken_by(const ProgramEnd& end, AnswerLines& lines, milliseconds patience) {
  const bool has_failed = end.is_hung || end.status != 0;
  if (!has_failed) {
    lines.end();
    return {};
  }
  const std::string after = " after " + lines.progress();
  if (!end.is_hung) {
    if (lines.is_complete()) throw Fault{told_end(end.status) + after};
    return Broken{Answer::crashed(signal_of(end.status)), told_end(end.status) + after};
  }
  if (lines.is_complete()) throw Fault{"did not end within " + seconds(patience) + after};
  const bool never_read = !end.is_fed && lines.answered() == 0;
  return Broken{Answer::timed_out(), never_read
                                         ? "neither read nor said anything for " + seconds(patience)
                                         : "said nothing for " + seconds(patience) + after};
}

class Program {
 public:
  Program(std::string name, std::string command, milliseconds patience)
      : name_(std::move(name)), command_(std::move(command)), patience_(patience) {}

  void answer(std::size_t shape, std::span<const Case> cases, std::span<Answer> answers) {
    try {
      std::call_once(tried_[shape], [&] { try_out(shape); });
      if (cases.size() == 1) return ask_alone(cases[0], answers[0]);
      ask(cases, answers);
    } catch (const Fault& fault) {
      throw NoAnswer(name_ + " does not answer: its program " + quotation(command_) + " " +
                     fault.what);
    }
  }

 private:
  /// A mistake is told over a case that is no reason to fail.
  void try_out(std::size_t shape) {
    const Case easy = read_case_line(easy_cases[shape]).question;
    Answer said;
    if (const auto broken = attempt({&easy, 1}, {&said, 1}, patience_).broken)
      throw Fault{broken->what + " when asked `" + std::string(easy_cases[shape]) + "`"};
  }

  void ask_alone(const Case& question, Answer& answer) {
    if (const auto broken = attempt({&question, 1}, {&answer, 1}, patience_).broken)
      answer = broken->answer;
  }

  void ask(std::span<const Case> cases, std::span<Answer> answers) {
    for (int found = 0; !cases.empty(); ++found) {
      if (found == most_broken || hung_ >= most_hung)
        return std::fill(answers.begin(), answers.end(), Answer::unasked());
      const auto [answered, broken] = attempt(cases, answers, patience_);
      if (!broken) return;
      const std::size_t all =
          answered + find(*broken, cases.subspan(answered), answers.subspan(answered));
      cases = cases.subspan(all), answers = answers.subspan(all);
    }
  }

  /// Finds the case at which the program broke off among cases that it was asked together. That and
  /// all before it then have their answers; returns how many these are.
  std::size_t find(const Broken& broken, std::span<const Case> cases, std::span<Answer> answers) {
    const bool is_hung = broken.answer.form == Answer::Form::timed_out;
    const milliseconds patience = is_hung ? patience_ / haste : patience_;
    std::size_t first = 0, last = cases.size();
    while (last - first > 1) {
      const std::size_t half = (last - first) / 2;
      const Attempt part =
          attempt(cases.subspan(first, half), answers.subspan(first, half), patience);
      if (part.broken) last = first + half;
      first += part.broken ? part.answered : half;
    }
    ask_alone(cases[first], answers[first]);
    // A program that is only slow has time for one; one that died once can do so again.
    if (!is_hung && answers[first].is_given()) answers[first] = broken.answer;
    return first + 1;
  }

  /// Runs the program for some cases.
  Attempt attempt(std::span<const Case> cases, std::span<Answer> answers, milliseconds patience) {
    if (cases.empty()) return {};
    std::string text;
    for (const Case& question : cases) {
      write(text, question);
      text += '\n';
    }
    AnswerLines lines(cases, answers);
    const ProgramEnd end =
        run_program(command_, text, patience, [&](std::string_view piece) { lines.take(piece); });
    require_started(end);
    if (end.is_hung) ++hung_;
    const std::optional<Broken> broken = broken_by(end, lines, patience);
    return {lines.answered(), broken};
  }

  /// By these exit codes a shell tells that there is nothing to run.
  void require_started(const ProgramEnd& end) const {
    const int code = end.is_hung || WIFSIGNALED(end.status) ? 0 : WEXITSTATUS(end.status);
    if (code != 126 && code != 127) return;
    throw Error("program " + quotation(command_) + " cannot be started: " +
                (code == 127 ? "there is no such command" : "it is nothing that can be run") +
                " (exit code " + std::to_string(code) + " of the shell)");
  }

  const std::string name_, command_;
  const milliseconds patience_;
  std::array<std::once_flag, shape_count> tried_;
  std::atomic<int> hung_ = 0;  ///< runs
};

/// Takes the first word off a command as a shell does, who lets quotes hold it together.
std::string take_word(std::string_view& command) {
  constexpr std::string_view white = " \t\n";
  command.remove_prefix(std::min(command.find_first_not_of(white), command.size()));
  std::string word;
  char quote = 0;
  for (; !command.empty(); command.remove_prefix(1)) {
    const char letter = command.front();
    if (quote == 0 && white.find(letter) != white.npos) break;
    if (letter == quote)
      quote = 0;
    else if (quote == 0 && (letter == '\'' || letter == '"'))
      quote = letter;
    else
      word += letter;
  }
  return word;
}

/// Does a word set a variable for the program after it?
bool is_assignment(const std::string& word) {
  const std::size_t equals = word.find('=');
  return equals != word.npos && equals > 0 &&
         std::all_of(
             word.begin(), word.begin() + static_cast<std::ptrdiff_t>(equals),
             [](unsigned char letter) { return std::isalnum(letter) != 0 || letter == '_'; });
}

/// The base name of a program, with `_` for what a name of a subject does not have.
std::string base_name(const std::string& program) {
  std::string name = program.substr(program.rfind('/') + 1);
  std::replace_if(name.begin(), name.end(), std::not_fn(is_letter_of_name), '_');
  return name.find_first_not_of('_') == name.npos ? "program" : name;
}

/// The base name of the program that a command runs first, and the format.
std::string name_of(std::string_view command, const Format& format) {
  std::string word = take_word(command);
  while (is_assignment(word)) word = take_word(command);
  const std::string name = base_name(word) + '/' + std::string(format.name);
  // By its name a routine of ours would be replayed for the program, or a library's be meant.
  const std::vector<Subject>& ours = all_subjects();
  const bool is_taken =
      std::any_of(ours.begin(), ours.end(),
                  [&](const Subject& subject) { return subject.name == name; }) ||
      std::any_of(libraries().begin(), libraries().end(), [&](const Library& library) {
        return matches(std::string(library.subjects), name);
      });
  return is_taken ? "./" + name : name;
}

}  // namespace

Subject program_subject(const std::string& command, const Format& format, milliseconds patience) {
  Subject made = {name_of(command, format), format, {}};
  made.is_elsewhere = true;
  const auto program = std::make_shared<Program>(made.name, command, patience);
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    made.answer[shape] = [=](std::span<const Case> cases, std::span<Answer> answers) {
      program->answer(shape, cases, answers);
    };
  return made;
}

}  // namespace rayaudit
