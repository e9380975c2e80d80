#include <fmt/format.h>

#include <algorithm>

#include "audit/library_finding.hpp"
#include "reports/contract.hpp"
#include "reports/declared.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/ink.hpp"
#include "reports/library_words.hpp"
#include "reports/report.hpp"
#include "reports/surroundings.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;

std::string heading(const Ink& ink) {
  return ink.heading(fmt::format("{:<28}{:<17}{:>9} {:>9} {:>9} {:>8} {:>9} {:>7}", "library",
                                 "shape", "cases", "wrong", "beyond", "margin", "ns a case",
                                 "times")) +
         '\n';
}

std::string row(const Contract& contract, const Run& run, const Ink& ink) {
  const auto& [subject, shape] = std::tie(contract.subject, contract.shape);
  std::string text =
      fmt::format("  {:<26}{:<17}{:>9} {:>9} {:>9} {:>8}", subject->name, shape_names[shape],
                  grouped(contract.cases), grouped(contract.wrong),
                  grouped(contract.beyond_rounding), magnitude(contract.margin));
  for (const TimeBeside& time : run.times)
    if (time.subject == subject && time.shape == shape) {
      text += fmt::format(" {:>9}", magnitude(time.nanoseconds.median));
      if (time.textbook)
        text += fmt::format(" {:>7}", magnitude(time.nanoseconds.median / time.textbook->median));
    }
  return (contract.beyond_rounding > 0 ? ink.bad(text) : text) + '\n';
}

std::string contracts(const std::vector<Contract>& all) {
  std::string text;
  const Subject* told = nullptr;
  for (const Contract& contract : all) {
    if (contract.subject != told) {
      told = contract.subject;
      const std::string declares = declared(told->convention);
      text +=
          '\n' +
          wrapped(fmt::format("{}{}{}", told->name, told->about.empty() ? "" : ": " + told->about,
                              declares.empty() ? "; declares nothing" : "; declares " + declares),
                  2);
    }
    text += wrapped(fmt::format("{}: {}", shape_names[contract.shape], observed(contract)), 4);
  }
  return text;
}

std::string told(const LibraryFinding& finding, std::size_t number, const Convention& stated,
                 const Ink& ink) {
  const Worst first = told_first(finding.example);
  std::string head =
      wrapped(fmt::format("{} by {} on {}: {}", figures::words(name(finding.verdict)),
                          finding.subject->name, shape_names[finding.shape], what(finding)),
              5);
  const std::string verdict = figures::words(name(finding.verdict));
  head.replace(0, 5 + verdict.size(), fmt::format("{:>3}. {}", number, ink.bad(verdict)));
  return head + wrapped(afflicted(finding, SIZE_MAX), 5) +
         wrapped(fmt::format("cause: {}; minimal case, by {}, margin {} u:",
                             shares(finding.causes, finding.wrong), rayaudit::told(first.diagnosis),
                             magnitude(first.severity)),
                 5) +
         "     " + explain_line(first, *finding.subject, stated) + '\n';
}

}  // namespace

std::string write_library_table(const Run& run, const Look& look) {
  const Ink ink = {look.colour};
  const std::vector<Contract> all = contracts_of(run);
  std::string text =
      wrapped(fmt::format("rayaudit {}: {} cases for each subject, shape and family; seed {}",
                          run.version, grouped(run.plan.cases), run.plan.seed),
              0);
  text += wrapped(
      "Wrong are answers outside of what a subject declares, of valid cases. Beyond: those of them "
      "that rounding does not excuse: over 2^10 u from any other truth, where the textbook's "
      "routine "
      "in the same format is right and provably decides nothing by rounding. Margin: the largest "
      "of "
      "a wrong answer, in u. Times: as many as the textbook takes, on the same cases.",
      0);
  text += '\n' + heading(ink);
  for (const Contract& contract : all) text += row(contract, run, ink);
  text += '\n' + ink.heading("Contracts") + ", as declared and as observed" + '\n' + contracts(all);
  const std::vector<LibraryFinding> found = library_findings(run.audits);
  text += '\n' + ink.heading("Findings") + ": " +
          (found.empty() ? "none" : "what rounding does not excuse, by library and shape") + '\n';
  for (std::size_t i = 0; i < found.size(); ++i)
    text += '\n' + told(found[i], i + 1, run.plan.convention, ink);
  return text + '\n' + surroundings(run.environment);
}

}  // namespace rayaudit
