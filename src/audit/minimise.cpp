#include "audit/minimise.hpp"

#include <algorithm>
#include <cmath>

#include "audit/beyond_rounding.hpp"
#include "audit/finding.hpp"
#include "audit/library_finding.hpp"
#include "audit/on_threads.hpp"
#include "audit/simpler.hpp"

namespace rayaudit {
namespace {

/// So many cases are put at once to a subject that is asked at no price.
constexpr std::size_t portion = 16;

bool is_missing(const Answer& answer) {
  return !answer.is_given() && answer.form != Answer::Form::unasked;
}

/// What a subject was asked, and to how many cases it said nothing.
struct Asked {
  std::size_t cases = 0, missing = 0;
};

/// The same subject; what it is asked is counted.
Subject counted(const Subject& subject, Asked& asked) {
  Subject made = subject;
  for (Subject::Batch& batch : made.answer)
    if (batch)
      batch = [&asked, answer = batch](std::span<const Case> cases, std::span<Answer> answers) {
        answer(cases, answers);
        asked.cases += cases.size();
        asked.missing += std::count_if(answers.begin(), answers.end(), is_missing);
      };
  return made;
}

/// A wrong answer, and what every simpler case must have in common with it.
class Failure {
 public:
  Failure(const Plan& plan, const Audit& audit, const Worst& worst)
      : subject_(counted(*audit.subject, asked_)),
        drawn_in_(plan.drawn_in ? *plan.drawn_in : subject_.drawn_in()),
        convention_(convention_of(plan, subject_)),
        replay_(plan.replay_of(subject_.name)),
        bits_(oracle::bits_for(subject_.format)),
        found_(worst),
        invalid_(oracle::truth(worst.question, bits_).invalid),
        least_margin_(std::fmin(worst.severity, telling_margin)) {}
  Failure(const Failure&) = delete;
  Failure& operator=(const Failure&) = delete;

  /// Where nothing is simpler: the case as it was found.
  Minimal as_found() const {
    return {found_.question, found_.answer, found_.judgement, found_.diagnosis, found_.severity};
  }

  /// The simplest of the same failure, of cases that are sorted by that; or nothing.
  std::optional<Minimal> first_alike(const std::vector<Case>& cases) const {
    const std::size_t at_once = asked_at_once(cases.size());
    for (std::size_t i = 0; i < cases.size() && !is_spent(); i += at_once) {
      const std::size_t size = std::min(at_once, cases.size() - i);
      if (auto alike = first_of({cases.data() + i, size})) return alike;
    }
    return {};
  }

  /// The cases one step away, as they are asked.
  std::vector<Case> simpler_than(const Case& question) const {
    std::vector<Case> cases = simpler(question, drawn_in_);
    if (!poses(convention_)) return cases;
    const Simplicity least = simplicity(question);
    for (Case& each : cases) each = posed(each, convention_, drawn_in_);
    std::erase_if(cases, [&](const Case& each) { return !(simplicity(each) < least); });
    std::stable_sort(cases.begin(), cases.end(),
                     [](const Case& a, const Case& b) { return simplicity(a) < simplicity(b); });
    return cases;
  }

  /// What of a minimal case is found out, where the case found did not tell.
  Diagnosis cause_of(const Minimal& minimal) const {
    const oracle::Truth truth = oracle::truth(minimal.question, bits_);
    Settled settled(minimal.question, truth);
    return diagnosis({settled, minimal.answer, minimal.judgement, {}}, subject_, replay_,
                     convention_);
  }

 private:
  /// Did a process end for want of an answer, or is it to be ended?
  bool ends_process() const { return subject_.is_elsewhere && !found_.answer.is_given(); }
  bool is_spent() const {
    const std::size_t dear = ends_process() ? asked_.cases : asked_.missing;
    return subject_.is_elsewhere && dear >= minimal_cases_without_answer;
  }

  /// A process that ends takes the rest of what it was asked with it.
  std::size_t asked_at_once(std::size_t all) const {
    if (!subject_.is_elsewhere) return portion;
    return ends_process() ? 1 : std::max<std::size_t>(all, 1);
  }

  std::optional<Minimal> first_of(std::span<const Case> cases) const {
    std::vector<Answer> answers(cases.size());
    std::vector<oracle::Truth> truths(cases.size());
    subject_.answer[found_.question.shape.index()](cases, answers);
    oracle::truth(cases, truths, bits_);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      Settled settled(cases[i], truths[i]);
      if (auto alike = if_alike(settled, answers[i])) return alike;
    }
    return {};
  }

  std::optional<Minimal> if_alike(Settled& settled, const Answer& answer) const {
    if (answer.form == Answer::Form::unasked || settled.truth().invalid != invalid_) return {};
    const Judgement judgement = judge(settled, answer, subject_.format, convention_);
    if (!has_verdict(judgement)) return {};
    const double margin = std::ldexp(settled.reach(), subject_.format.precision);
    if (margin < least_margin_) return {};
    if (found_.beyond_rounding &&
        !is_beyond_rounding(settled, answer, judgement, margin, subject_.format, convention_))
      return {};
    Minimal made = {settled.question(), answer, judgement, found_.diagnosis, margin};
    if (found_.diagnosis.cause != Cause::unknown) {
      made.diagnosis = diagnosis({settled, answer, judgement, {}}, subject_, replay_, convention_);
      if (!has_cause(made.diagnosis)) return {};
    }
    return repeats(settled) ? std::optional(made) : std::nullopt;
  }

  bool has_verdict(const Judgement& judgement) const {
    return judgement.verdict == found_.judgement.verdict &&
           judgement.claim == found_.judgement.claim;
  }
  bool has_cause(const Diagnosis& diagnosis) const {
    return diagnosis.cause == found_.diagnosis.cause && diagnosis.about == found_.diagnosis.about;
  }
  bool repeats(Settled& settled) const {
    return !subject_.is_elsewhere ||
           has_verdict(judge(settled, answer_one(subject_, settled.question()), subject_.format,
                             convention_));
  }

  Asked asked_;
  const Subject subject_;
  const Format drawn_in_;
  const Convention convention_;
  const replay::Replay* const replay_;
  const int bits_;
  const Worst& found_;
  const oracle::Invalid invalid_;
  const double least_margin_;  ///< NaN of an invalid case
};

}  // namespace

std::optional<Minimal> minimal(const Plan& plan, const Audit& audit, const Worst& worst) {
  if (!worst.repeats || worst.answer.form == Answer::Form::timed_out) return {};
  const Failure failure(plan, audit, worst);
  Minimal made = failure.as_found();
  const int rounds = audit.subject->is_elsewhere ? minimal_rounds_elsewhere : minimal_rounds;
  for (int round = 0; round < rounds; ++round) {
    const auto next = failure.first_alike(failure.simpler_than(made.question));
    if (!next) break;
    made = *next;
  }
  if (made.diagnosis.cause == Cause::unknown) made.diagnosis = failure.cause_of(made);
  return made;
}

void minimise(const Plan& plan, std::vector<Audit>& audits) {
  struct Example {
    Audit* audit;
    Worst* worst;
  };
  std::vector<Example> examples;
  const auto add = [&](const auto& finding) {
    Audit& audit = audits[finding.audit - audits.data()];
    examples.push_back({&audit, &*audit.tally.outcome(finding.verdict, finding.claim).worst});
  };
  if (plan.beside_textbook)
    for (const LibraryFinding& finding : library_findings(audits)) add(finding);
  else
    for (const Finding& finding : findings(audits)) add(finding);
  // A subject whose process ends too often is asked no more: what does that comes last.
  std::stable_partition(examples.begin(), examples.end(), [](const Example& each) {
    return each.worst->answer.form != Answer::Form::crashed;
  });
  std::vector<const Subject*> subjects;
  subjects.reserve(examples.size());
  for (const Example& each : examples) subjects.push_back(each.audit->subject);
  in_turn(plan.threads, subjects, [&](std::size_t i) {
    examples[i].worst->minimal = minimal(plan, *examples[i].audit, *examples[i].worst);
  });
}

}  // namespace rayaudit
