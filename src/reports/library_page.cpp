#include "reports/library_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "reports/contract.hpp"
#include "reports/declared.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/markdown_text.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;

/// A share of cases in which nothing was found, with 95 % confidence.
std::string none_of(std::uint64_t cases) {
  return fmt::format("0 of {}, < {}%", grouped(cases),
                     magnitude(300 / static_cast<double>(std::max<std::uint64_t>(cases, 1))));
}

std::string about(const Subject& subject) {
  return subject.about.empty() ? subject.name : subject.about;
}

/// How a reader builds and runs a program.
std::string command_of(const OutsideProgram& program) {
  std::string command = program.build;
  const auto put = [&](std::string_view word, const std::string& name) {
    if (const std::size_t at = command.find(word); at != command.npos)
      command.replace(at, word.size(), name);
  };
  put("FILE", program.file);
  if (command.find("PROGRAM") == command.npos) return command;
  put("PROGRAM", "a.out");
  return command + " && ./a.out";
}

/// The program without the lines in front that only we read.
std::string_view body(const OutsideProgram& program) {
  std::string_view text = program.text;
  while (text.starts_with("// ")) text.remove_prefix(std::min(text.find('\n') + 1, text.size()));
  return text;
}

/// So many families of a finding are told on the page; its tracker's text has all.
constexpr std::size_t families_told = 5;

/// The other subjects that the case of a finding shows, each with how often and its program.
std::string others(const Confirmed& confirmed) {
  std::string text;
  for (const auto& [finding, shown_by, none] : confirmed.same)
    text += fmt::format("  - the same of {}: {} ([program](programs/{}))\n",
                        code_span(finding->subject->name),
                        markdown_text(afflicted(*finding, families_told)), shown_by.program.file);
  return text;
}

std::string section(const Confirmed& confirmed, const Run& run) {
  const auto& [finding, shown_by, same] = confirmed;
  const auto& [program, sentence_of_it, shown, library] = shown_by;
  std::string text =
      fmt::format("\n- **{}**: {}. {}.", figures::words(name(finding->verdict)),
                  markdown_text(what(*finding)), markdown_text(afflicted(*finding, families_told)));
  text += fmt::format(" Cause: {}.\n", markdown_text(shares(finding->causes, finding->wrong)));
  const auto row = [&](std::string_view label, const std::string& value) {
    text += fmt::format("  - {}: {}\n", label, value);
  };
  row("case",
      fmt::format("`{}`, margin {} u", explain_line(shown, *finding->subject, run.plan.convention),
                  magnitude(shown.severity)));
  const std::string hand = by_hand(shown.question);
  row("exact", fmt::format("`{}`{}", exact_answer(shown.question, shown.answer.form),
                           hand.empty() ? "" : " " + markdown_text(hand)));
  row("observed", '`' + printed(shown.answer) + '`');
  row("but it says", code_span(sentence_of_it));
  text += others(confirmed);
  text += fmt::format("  - [program](programs/{}), [what its tracker could be told](trackers/{})\n",
                      program.file, tracker_file(confirmed));
  return text;
}

/// Those of one subject and shape, below a heading.
std::string sections(const std::vector<Confirmed>& confirmed, const Run& run) {
  std::string text;
  const Confirmed* before = nullptr;
  for (const Confirmed& each : confirmed) {
    if (before == nullptr || before->finding->subject != each.finding->subject ||
        before->finding->shape != each.finding->shape)
      text += fmt::format("\n### {}, {}\n", code_span(each.finding->subject->name),
                          shape_names[each.finding->shape]);
    text += section(each, run);
    before = &each;
  }
  return text;
}

bool is_of(const LibraryFinding& finding, const Contract& contract) {
  return finding.subject == contract.subject && finding.shape == contract.shape;
}

/// What of a subject and shape is on the page: below its own name, or below another's.
struct Told {
  std::size_t own = 0, elsewhere = 0;
  std::uint64_t wrong = 0;  ///< of all of them
  std::string where = {};   ///< the subject that tells those elsewhere, the last
};

Told told_of(const std::vector<Confirmed>& confirmed, const Contract& contract) {
  Told told;
  for (const Confirmed& each : confirmed) {
    if (is_of(*each.finding, contract)) ++told.own, told.wrong += each.finding->wrong;
    for (const Confirmed& same : each.same)
      if (is_of(*same.finding, contract)) {
        ++told.elsewhere, told.wrong += same.finding->wrong;
        told.where = each.finding->subject->name;
      }
  }
  return told;
}

std::string finding_words(const Told& told, const Contract& contract) {
  if (contract.beyond_rounding == 0) return "clean: " + none_of(contract.cases);
  std::vector<std::string> words;
  if (told.own > 0) words.push_back(fmt::format("**{}**", told.own));
  if (told.elsewhere > 0)
    words.push_back(fmt::format("{} as of {}", told.elsewhere, code_span(told.where)));
  const std::string of = fmt::format("{} of {}", grouped(contract.beyond_rounding - told.wrong),
                                     grouped(contract.cases));
  if (words.empty()) return fmt::format("none confirmed ({} beyond rounding)", of);
  if (contract.beyond_rounding > told.wrong)
    words.push_back("beyond rounding, but no finding: " + of);
  return fmt::format("{}", fmt::join(words, "; "));
}

std::string table(const std::vector<Contract>& contracts, const std::vector<Confirmed>& confirmed) {
  std::string text =
      "\n| subject | what it is | shape | findings | wrong where the textbook may be, too | by "
      "cause |\n|---|---|---|---|--:|---|\n";
  for (const Contract& contract : contracts)
    text +=
        fmt::format("| {} | {} | {} | {} | {} of {} | {} |\n", code_span(contract.subject->name),
                    markdown_text(about(*contract.subject)), shape_names[contract.shape],
                    finding_words(told_of(confirmed, contract), contract),
                    grouped(contract.wrong - contract.beyond_rounding), grouped(contract.cases),
                    contract.beyond_rounding > 0 ? markdown_text(causes(contract)) : "");
  return text;
}

std::string contract_list(const std::vector<Contract>& contracts) {
  std::string text = "\n## Contracts, as declared and as observed\n";
  const Subject* told = nullptr;
  for (const Contract& contract : contracts) {
    if (contract.subject != told) {
      told = contract.subject;
      const std::string words = declared(told->convention);
      text += fmt::format("\n{} declares {}.\n\n", code_span(told->name),
                          words.empty() ? "nothing" : '`' + words + '`');
    }
    text += fmt::format("- {}: {}; largest margin of a wrong answer {} u\n",
                        shape_names[contract.shape], markdown_text(observed(contract)),
                        magnitude(contract.margin));
  }
  return text;
}

/// What makes a wrong answer a finding.
std::string_view criteria() {
  return "- the case is more than 2^10 units of rounding from any case with another truth (a wrong "
         "t: is off by more than 2^10 times what rounding the numbers of the case would do to it), "
         "and no product of four of its numbers leaves the range of the format;\n"
         "- on that very case the textbook's routine in the same format is right, and would be "
         "were each of its operations that rounds 2^8 times less exact: no library need do better "
         "than that, so whatever is wrong where the textbook might be is counted as *within "
         "rounding*; and so is what changing the case shows to be rounding's;\n"
         "- a sentence of the library's own documentation makes it a defect, and no tolerance or "
         "approximation that it documents allows for it (the adapters quote those);\n"
         "- and a program against the library's public interface, built and run outside of "
         "rayaudit, gives the same answer on the minimal case.\n\n";
}

std::string head(const Run& run) {
  const Environment& here = run.environment;
  return fmt::format(
      "# What libraries answer\n\nWritten by `{}`: {} cases for each subject, shape and family, "
      "seed "
      "{}; rayaudit {}, compiled by {}; {}.\n\nEvery library is asked through the interface that "
      "its "
      "users call, in the convention that its documentation declares (the adapters in "
      "`src/subjects/libraries` quote it), and every answer is held against exact truth. **A "
      "finding** "
      "is what neither convention nor rounding excuses:\n\n{}"
      "A t that is not finite and no answer at all need no margin. A *wrong root* is a t that is "
      "nearer to another root than to the right one, be it near to that or not. What one case "
      "shows of several subjects of a library is one finding. Families are adversarial "
      "(`rayaudit "
      "list families`): how often is of their cases, not of a scene's. What a library does with "
      "what "
      "is no case at all (a direction of length 0, say) is told under *Contracts*, and is no "
      "finding. Times stand in [times.md](times.md).\n",
      run.command, grouped(run.plan.cases), run.plan.seed, run.version, here.compiler,
      here.processor, criteria());
}

/// Does one case show both? A finding is then of one library, verdict and sense.
bool are_same(const Confirmed& a, const Confirmed& b) {
  return a.finding->verdict == b.finding->verdict &&
         a.finding->is_behind() == b.finding->is_behind() &&
         a.shown_by.shown.question == b.shown_by.shown.question &&
         a.shown_by.library == b.shown_by.library;
}

/// What each family draws, and how much of it is wrong.
std::string by_family(const LibraryFinding& finding) {
  std::string text;
  for (const Afflicted& each : finding.families) {
    text += fmt::format("- {} of {} in {}", grouped(each.wrong), grouped(each.cases),
                        markdown_text(each.family));
    for (const Family& family : families())
      if (family.id == each.family) text += ": " + markdown_text(family.about);
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<Confirmed> to_be_confirmed(const std::vector<LibraryFinding>& findings,
                                       const Convention& stated) {
  std::vector<Confirmed> all;
  for (const LibraryFinding& finding : findings)
    if (const auto program = library_program(finding))
      all.push_back({&finding, headed(*program, finding, stated)});
  return all;
}

std::vector<Confirmed> told_once(const std::vector<Confirmed>& confirmed) {
  std::vector<Confirmed> told;
  for (const Confirmed& each : confirmed) {
    const auto first = std::find_if(told.begin(), told.end(),
                                    [&](const Confirmed& other) { return are_same(other, each); });
    if (first == told.end())
      told.push_back(each);
    else
      first->same.push_back(each);
  }
  return told;
}

std::string tracker_file(const Confirmed& confirmed) {
  const std::string& file = confirmed.shown_by.program.file;
  return file.substr(0, file.rfind('.')) + ".md";
}

std::string write_tracker(const Confirmed& confirmed, const Run& run) {
  const auto& [finding, shown_by, same] = confirmed;
  const auto& [program, sentence_of_it, shown, library] = shown_by;
  std::string text =
      fmt::format("# {}, {}: {}\n\n", one_line(about(*finding->subject)),
                  shape_names[finding->shape], figures::words(name(finding->verdict)));
  text += fmt::format(
      "The program below prints `{}`; the exact answer is `{}`: {}. The documentation says {}.\n\n",
      printed(shown.answer), exact_answer(shown.question, shown.answer.form),
      markdown_text(what(*finding)), code_span(sentence_of_it));
  text += fmt::format("    {}\n\n", command_of(program)) + fenced(body(program));
  if (const std::string hand = by_hand(shown.question); !hand.empty())
    text += fmt::format("\nBy hand: {}\n", markdown_text(hand));
  for (const Confirmed& each : same)
    text += fmt::format("\nThe same case shows the same of {}.\n",
                        markdown_text(about(*each.finding->subject)));
  return text +
         fmt::format(
             "\nHow often, of cases made to be hard, by family, whose truth was found in exact "
             "arithmetic (rayaudit {}, seed {}):\n\n{}\nOn all of these the textbook's formula is "
             "right in {}, even were each of its operations 2^8 times less exact. Cause, as found "
             "by changing cases: {}.\n\nBuilt with {}; run on {}.\n",
             run.version, run.plan.seed, by_family(*finding), finding->subject->format.name,
             markdown_text(shares(finding->causes, finding->wrong)), run.environment.compiler,
             run.environment.processor);
}

std::string write_library_page(const Run& run, const std::vector<Confirmed>& confirmed) {
  const std::vector<Contract> contracts = contracts_of(run);
  std::string text = head(run) + table(contracts, confirmed);
  if (!confirmed.empty()) text += "\n## Findings\n" + sections(confirmed, run);
  return text + contract_list(contracts);
}

std::string write_library_times(const Run& run) {
  std::string text =
      "# What libraries take\n\nNanoseconds a case beside the textbook in the same format, on the "
      "same cases of the family *unit*, in turn, one ray at a time: which some libraries are not "
      "made "
      "for. Medians; not the same from run to run.\n\n| subject | shape | ns a case | textbook | "
      "times "
      "|\n|---|---|--:|--:|--:|\n";
  for (const TimeBeside& time : run.times)
    text += fmt::format(
        "| {} | {} | {} | {} | {} |\n", markdown_text(time.subject->name), shape_names[time.shape],
        magnitude(time.nanoseconds.median), time.textbook ? magnitude(time.textbook->median) : "",
        time.textbook ? magnitude(time.nanoseconds.median / time.textbook->median) : "");
  return text;
}

}  // namespace rayaudit
