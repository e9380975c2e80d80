#include "reports/failure_block.hpp"

#include "reports/explain_line.hpp"
#include "reports/failure_text.hpp"

namespace rayaudit {

std::string failure_block(const Worst& of, const Subject& subject, const Convention& stated) {
  const Worst worst = told_first(of);
  const Verdict verdict = worst.judgement.verdict;
  const bool has_margin = is_wrong(verdict) && verdict != Verdict::invalid_mishandled;
  return failure_text({.question = worst.question,
                       .answer = worst.answer,
                       .format = subject.format,
                       .judgement = worst.judgement,
                       .margin = has_margin ? worst.severity : Judgement::unmeasured,
                       .cause = told(worst.diagnosis),
                       .repeats = worst.repeats,
                       .command = explain_line(worst, subject, stated)});
}

}  // namespace rayaudit
