#include <fmt/format.h>

#include <cmath>

#include "audit/judge.hpp"
#include "cli/command.hpp"
#include "cli/convention_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/lines.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/output.hpp"
#include "cli/truth_words.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using figures::grouped;

struct CheckOptions {
  std::vector<std::string> files, shapes;
  SubjectChoice choice;
  Convention convention;
};

/// A case of a file.
struct Kept {
  std::string place;  ///< `file:line`
  Case question;
  std::string why;
};

/// So many ulps of double may a t be off that stands on a line as the truth.
constexpr double ulps_of_truth = 1;

/// What stands on the line as the truth of its case must be one.
void require_truth(const std::string& place, const CaseLine& line) {
  if (!line.answer) return;
  const oracle::Truth truth = oracle::truth(line.question);
  Settled settled(line.question, truth);
  const Judgement judgement = judge(settled, *line.answer, double_format);
  const bool is_off = line.answer->form == Answer::Form::hit && judgement.ulps > ulps_of_truth;
  if (!is_wrong(judgement.verdict) && !is_off) return;
  std::string stands, is;
  write(stands, *line.answer);
  write_truth(is, line.question, truth, double_format);
  throw Error(fmt::format("{}: `{}` is not the truth of this case:{}; `rayaudit truth` writes it",
                          place, stands, is));
}

/// The cases of a file, of the shapes that are wanted.
std::vector<Kept> kept_in(const std::string& path, const std::vector<bool>& shapes) {
  LineFile file(path);
  std::vector<Kept> kept;
  work_through(
      file, Answers::welcome,
      [&](std::span<const Line> lines) {
        std::vector<Kept> here;
        for (const auto& [text, number, read] : lines) {
          if (!read || !shapes[read->question.shape.index()]) continue;
          const std::string place = file.name() + ":" + std::to_string(number);
          require_truth(place, *read);
          here.push_back({place, read->question, std::string(read->why)});
        }
        return here;
      },
      [&](std::vector<Kept> here) {
        std::move(here.begin(), here.end(), std::back_inserter(kept));
      });
  return kept;
}

/// A subject on all cases that it answers.
class Checked {
 public:
  Checked(const std::vector<Kept>& all, const Subject& subject, const Convention& stated)
      : subject_(subject), stated_(stated), convention_(joined(stated, subject.convention)) {
    for (const Kept& each : all)
      if (subject.answers(each.question.shape.index())) kept_.push_back(&each);
    for (const Kept* each : kept_) {
      const Case held = rounded(each->question, subject.drawn_in());
      cases_.push_back(asked(each->question, convention_, subject.drawn_in()));
      if (!is_other(cases_.back(), each->question)) continue;
      rounded_ += is_other(held, each->question), posed_ += is_other(cases_.back(), held);
    }
    answers_.resize(cases_.size());
    answer_mixed(subject, cases_, answers_);
    for (std::size_t i = 0; i < cases_.size(); ++i) judge_one(i);
  }

  std::size_t count() const { return cases_.size(); }
  std::size_t wrong() const { return wrong_; }
  std::string told() const {
    if (cases_.empty()) return subject_.name + ": answers no case of these\n";
    std::string text = fmt::format("{}: {} of {} cases wrong", subject_.name, grouped(wrong_),
                                   grouped(cases_.size()));
    if (touches_ > 0) text += fmt::format(", {} touched", grouped(touches_));
    if (rounded_ > 0)
      text += fmt::format(", {} rounded to {}", grouped(rounded_), subject_.drawn_in().name);
    if (posed_ > 0) text += fmt::format(", {} posed as its convention has it", grouped(posed_));
    if (unasked_ > 0) text += fmt::format(", {} not asked", grouped(unasked_));
    return text + '\n' + each_;
  }

 private:
  void judge_one(std::size_t i) {
    if (answers_[i].form == Answer::Form::unasked) {
      ++unasked_;
      return;
    }
    const Judgement judgement = judge(cases_[i], answers_[i], subject_.format, convention_);
    touches_ += judgement.verdict == Verdict::touch;
    if (!is_wrong(judgement.verdict)) return;
    ++wrong_;
    Worst worst;
    worst.question = cases_[i], worst.answer = answers_[i];
    const std::string claim =
        judgement.claim == Claim::none ? "" : " (" + std::string(name(judgement.claim)) + ")";
    each_ += fmt::format("  {}: {}{}{}{}\n    {}\n", kept_[i]->place, name(judgement.verdict),
                         claim, shows_again(cases_[i], judgement) ? "" : ", not reproducible",
                         kept_[i]->why.empty() ? "" : " # " + kept_[i]->why,
                         explain_line(worst, subject_, stated_));
  }

  /// Has a case that is asked again, alone, the same verdict? Only a subject elsewhere may differ.
  bool shows_again(const Case& question, const Judgement& judgement) const {
    if (!subject_.is_elsewhere) return true;
    const Answer again = answer_one(subject_, question);
    return again.form == Answer::Form::unasked ||
           judge(question, again, subject_.format, convention_).verdict == judgement.verdict;
  }
  /// By their words, for a NaN is not itself.
  static bool is_other(const Case& a, const Case& b) { return case_line(a) != case_line(b); }

  const Subject& subject_;
  const Convention& stated_;
  const Convention convention_;
  std::vector<const Kept*> kept_;
  std::vector<Case> cases_;
  std::vector<Answer> answers_;
  std::size_t wrong_ = 0, touches_ = 0, rounded_ = 0, posed_ = 0, unasked_ = 0;
  std::string each_;  ///< the wrong ones
};

int check(const CheckOptions& options) {
  if (options.choice.names.empty() && !options.choice.brings_any())
    throw Error("check: name what to check, as in --subject 'textbook/*' or --plugin ./libmine.so");
  const Subjects there(options.choice);
  const std::vector<const Subject*> subjects = there.selected(options.choice);
  std::vector<bool> shapes(shape_count);
  for (const std::size_t shape : selected("shape", options.shapes, shape_names))
    shapes[shape] = true;
  std::vector<Kept> kept;
  for (const std::string& file : options.files) {
    std::vector<Kept> here = kept_in(file, shapes);
    std::move(here.begin(), here.end(), std::back_inserter(kept));
  }
  std::string text;
  std::size_t count = 0, wrong = 0;
  for (const Subject* subject : subjects) {
    const Checked checked(kept, *subject, options.convention);
    text += checked.told();
    count += checked.count(), wrong += checked.wrong();
  }
  if (count == 0)
    throw NothingAudited(
        kept.empty() ? fmt::format("{} has no case to check{}", fmt::join(options.files, ", "),
                                   options.shapes.empty() ? "" : " of a chosen shape")
                     : "nothing was checked: no chosen subject answers the shapes "
                       "of these cases");
  print(text);
  return wrong == 0 ? all_held : found;
}

}  // namespace

void add_check_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<CheckOptions>();
  CLI::App* command = program.add_subcommand(
      "check", "Put the cases of files to subjects again: exit 1 where one is answered wrongly");
  command->add_option("FILE", options->files, "case lines, as audit --save-cases writes them")
      ->type_name("")
      ->required();
  add_list(*command, "--subject", "SUBJECT,...", "names or globs, as 'textbook/*'",
           options->choice.names)
      ->delimiter(',');
  add_list(*command, "--shape", "SHAPE,...", "names or globs", options->shapes)->delimiter(',');
  add_bringers(*command, options->choice,
               "without --subject, only what is brought along is checked");
  add_program_format(*command, options->choice);
  add_option(*command, "--convention", "KIND=STANCE,...",
             "what the subjects declare, before what each declares itself",
             [=](const std::string& text) { options->convention = read_convention(text); });
  command->footer(
      "A case is asked in the subject's format and as its convention has it, and held against the\n"
      "exact truth of that. A truth that stands on a line must be so, its t to an ulp of double: "
      "where\n"
      "it is not, the file is at fault (exit code 2) and nobody is asked. What a plugin or "
      "program\n"
      "answers wrongly it is asked again, alone.\n\n"
      "Examples:\n"
      "  rayaudit audit textbook/float --save-cases found.txt\n"
      "  rayaudit check found.txt --subject textbook/float\n"
      "  rayaudit check data/cases/*.txt --subject 'certified/*'\n"
      "  rayaudit check data/cases/*.txt --shape sphere,disk --plugin ./libmine.so\n");
  command->callback([=, &asked] { asked = [options] { return check(*options); }; });
}

}  // namespace rayaudit
