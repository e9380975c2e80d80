#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "reports/declared.hpp"
#include "reports/figures.hpp"
#include "reports/findings.hpp"
#include "reports/ink.hpp"
#include "reports/limits.hpp"
#include "reports/report.hpp"
#include "reports/surroundings.hpp"
#include "reports/touches.hpp"
#include "reports/wrapped.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;
using figures::percent;

/// Up to so many audits get a row each; beyond, a row is a subject over all families.
constexpr std::size_t audits_with_rows = 100;

/// The audits of one subject and shape that a row tells of, and their sum.
struct Line {
  const Subject* subject;
  std::size_t shape;
  std::vector<const Audit*> audits;
  Tally tally = {};

  void add(const Audit& audit) {
    audits.push_back(&audit);
    tally.merge(audit.tally);
  }
};

std::vector<Line> lines(const std::vector<Audit>& audits, bool each_family) {
  std::vector<Line> all;
  for (const Audit& audit : audits) {
    const bool same = !each_family && !all.empty() && all.back().subject == audit.subject &&
                      all.back().shape == audit.shape;
    if (!same) all.push_back({audit.subject, audit.shape, {}});
    all.back().add(audit);
  }
  return all;
}

std::string cut(std::string_view text, std::size_t width) {
  return text.size() <= width ? std::string(text) : std::string(text.substr(0, width - 1)) + '~';
}

/// The cases that are wrong about the truth: conduct on invalid ones aside.
std::uint64_t untrue(const Tally& tally) {
  return tally.wrong() - tally.of(Verdict::invalid_mishandled);
}

/// Is a smaller share of a untrue than of b?
bool is_less_untrue(const Audit* a, const Audit* b) {
  return static_cast<double>(untrue(a->tally)) / static_cast<double>(a->tally.cases) <
         static_cast<double>(untrue(b->tally)) / static_cast<double>(b->tally.cases);
}

/// A column of verdicts, and the two lines of its heading.
struct VerdictColumn {
  Verdict verdict;
  std::string_view above, below;
};
using Columns = std::vector<VerdictColumn>;

/// The verdicts that have a column: crashes and time-outs where any occurred.
Columns columns_of(const std::vector<Audit>& audits) {
  Columns all = {
      {Verdict::false_hit, "false", "hit"},   {Verdict::false_miss, "false", "miss"},
      {Verdict::wrong_root, "wrong", "root"}, {Verdict::wrong_t, "wrong", "t"},
      {Verdict::not_finite, "NaN,", "inf"},   {Verdict::crashed, "cra-", "shed"},
      {Verdict::timed_out, "timed", "out"},   {Verdict::invalid_mishandled, "in-", "valid"}};
  std::erase_if(all, [&](const VerdictColumn& column) {
    const bool is_rare = column.verdict == Verdict::crashed || column.verdict == Verdict::timed_out;
    return is_rare && std::none_of(audits.begin(), audits.end(), [&](const Audit& audit) {
             return audit.tally.of(column.verdict) > 0;
           });
  });
  return all;
}

constexpr int family_width = 13, share_width = 6, error_width = 7;

/// What the rare columns take, the names of subjects give.
int subject_width(const Columns& columns) {
  constexpr int with_six = 28;
  return with_six - share_width * (static_cast<int>(columns.size()) - 6);
}

/// What is wrong of all, and of it what; or how little can be, with nothing wrong seen.
std::string shares(const Tally& tally, const Columns& columns, const Ink& ink) {
  const int shares_width = share_width * (1 + static_cast<int>(columns.size()));
  const std::uint64_t wrong = tally.wrong();
  if (wrong == 0) {
    const double most = 300 / static_cast<double>(tally.cases);
    const std::string holds =
        fmt::format("0 of {}, < {}% at 95%", grouped(tally.cases), magnitude(most));
    return ink.good(fmt::format("{:>{}}", holds, shares_width));
  }
  std::string text = ink.bad(fmt::format("{:>{}}", percent(wrong, tally.cases), share_width));
  for (const VerdictColumn& column : columns)
    text += fmt::format("{:>{}}", percent(tally.of(column.verdict), tally.cases), share_width);
  return text;
}

/// A figure of errors, where anything was measured.
std::string error(const Histogram& errors, double figure) {
  return fmt::format("{:>{}}", errors.count() > 0 ? magnitude(figure) : "-", error_width);
}

/// The cause of the most wrong answers, conduct on invalid cases aside, and the largest margin at
/// which one is wrong.
std::string cause_and_margin(const Line& line) {
  CauseShare sum = {};
  for (const Audit* audit : line.audits) add(sum, audit->tally.wrong_by_cause());
  const auto most = std::max_element(sum.begin(), sum.end());
  const std::string_view cause = *most == 0 ? "-" : name(static_cast<Cause>(most - sum.begin()));
  const Worst* widest = line.tally.widest();
  return fmt::format("{:>11}{:>9}", cause, widest == nullptr ? "-" : magnitude(widest->severity));
}

std::string row(const Line& line, const Columns& columns, const Ink& ink) {
  const int width_of_names = subject_width(columns);
  const auto holds = [](const Audit* audit) { return audit->tally.wrong() == 0; };
  const auto held = std::count_if(line.audits.begin(), line.audits.end(), holds);
  const Audit* worst = *std::max_element(line.audits.begin(), line.audits.end(), is_less_untrue);
  const Tally& there = worst->tally;
  const std::string_view most = untrue(there) == 0 ? "" : worst->family->id;
  const Tally& tally = line.tally;
  return fmt::format("  {:<{}}{}{:>6} {:<{}}{}{}\n",
                     cut(line.subject->name, static_cast<std::size_t>(width_of_names)),
                     width_of_names, shares(tally, columns, ink),
                     fmt::format("{}/{}", held, line.audits.size()), cut(most, family_width),
                     family_width, cause_and_margin(line),
                     error(tally.forced, tally.forced.largest()));
}

std::string row_of_family(const Line& line, const Columns& columns, const Ink& ink) {
  const int width_of_names = subject_width(columns);
  const Tally& tally = line.tally;
  return fmt::format("  {:<{}} {:<{}}{}{}{}{}\n",
                     cut(line.subject->name, static_cast<std::size_t>(width_of_names)),
                     width_of_names, cut(line.audits.front()->family->id, family_width),
                     family_width, shares(tally, columns, ink), cause_and_margin(line),
                     error(tally.ulps, tally.ulps.largest()),
                     error(tally.forced, tally.forced.largest()));
}

std::string verdicts_above(const Columns& columns) {
  std::string text(share_width, ' ');
  for (const VerdictColumn& column : columns)
    text += fmt::format("{:>{}}", column.above, share_width);
  return text;
}
std::string verdicts_below(const Columns& columns) {
  std::string text = fmt::format("{:>{}}", "wrong", share_width);
  for (const VerdictColumn& column : columns)
    text += fmt::format("{:>{}}", column.below, share_width);
  return text;
}

std::string heading(std::string_view shape, const Columns& columns, const Ink& ink) {
  const int width_of_names = subject_width(columns);
  const std::string name = fmt::format("{:<{}}", shape, 2 + width_of_names);
  return ink.heading(name) + verdicts_above(columns) +
         fmt::format("{:>47}\n{:<{}}", "main wrong to forced", "", 2 + width_of_names) +
         verdicts_below(columns) +
         fmt::format(" {:>5} {:<13}{:>11}{:>9}{:>7}\n", "holds", "most wrong in", "cause", "margin",
                     "max");
}

std::string heading_of_families(std::string_view shape, const Columns& columns, const Ink& ink) {
  const int width = 2 + subject_width(columns) + 1 + family_width;
  const std::string name = fmt::format("{:<{}}", shape, width);
  return ink.heading(name) + verdicts_above(columns) +
         fmt::format("{:>11}{:>9}{:>7}{:>7}\n{:<{}}", "main", "wrong to", "ulp", "forced", "",
                     width) +
         verdicts_below(columns) +
         fmt::format("{:>11}{:>9}{:>7}{:>7}\n", "cause", "margin", "max", "max");
}

/// The families that every number of a routine has right on a shape, of how many.
struct Held {
  std::size_t held = 0, of = 0;

  double share() const { return of == 0 ? 0 : static_cast<double>(held) / static_cast<double>(of); }
};

/// A routine, and by shape the families with whether any of its numbers has something wrong there.
struct Routine {
  std::string_view name;
  std::array<std::map<std::string_view, bool>, shape_count> wrong = {};

  Held on(std::size_t shape) const {
    const auto holds = [](const auto& family) { return !family.second; };
    const auto held = std::count_if(wrong[shape].begin(), wrong[shape].end(), holds);
    return {static_cast<std::size_t>(held), wrong[shape].size()};
  }
  Held all() const {
    Held sum;
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      sum.held += on(shape).held;
      sum.of += on(shape).of;
    }
    return sum;
  }
};

std::vector<Routine> routines(const std::vector<Audit>& audits) {
  std::vector<Routine> all;
  for (const Audit& audit : audits) {
    const std::string_view subject = audit.subject->name;
    const std::string_view name = subject.substr(0, subject.rfind('/'));
    if (all.empty() || all.back().name != name) all.push_back({name});
    all.back().wrong[audit.shape][audit.family->id] |= audit.tally.wrong() > 0;
  }
  std::stable_sort(all.begin(), all.end(), [](const Routine& a, const Routine& b) {
    return a.all().share() > b.all().share();
  });
  return all;
}

/// The routines, those that hold in the most of their families first.
std::string holding(const Run& run, const Ink& ink) {
  std::string text = ink.heading("What holds") +
                     ": the families that a routine has right in every number, of how many\n";
  for (const Routine& routine : routines(run.audits)) {
    text += fmt::format("  {:<17}", cut(routine.name, 16));
    for (const std::size_t shape : run.plan.shapes) {
      const auto [held, of] = routine.on(shape);
      const std::string told = fmt::format("{} {}/{}", shape_names[shape], held, of);
      const std::size_t width = std::max<std::size_t>(16, shape_names[shape].size() + 7);
      text += fmt::format("{:<{}}", of > 0 ? told : "", width);
    }
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string title(const Run& run) {
  const Plan& plan = run.plan;
  std::string text =
      fmt::format("rayaudit {}: {} cases for each subject, shape and family; seed {}", run.version,
                  grouped(plan.cases), plan.seed);
  if (plan.difficulty) text += fmt::format("; difficulty {}", *plan.difficulty);
  for (std::size_t kind = 1; kind < plan.convention.stances.size(); ++kind) {
    const auto stance = plan.convention.stances[kind];
    if (stance != Convention::Stance::either)
      text += fmt::format("; {} declared to be a {}", name(static_cast<oracle::Kind>(kind)),
                          stance == Convention::Stance::hit ? "hit" : "miss");
  }
  Convention others = plan.convention;
  others.stances = {};
  if (const std::string words = declared(others); !words.empty()) text += "; declared: " + words;
  return wrapped(text, 0) + write_declared(run.audits);
}

std::string legend(const Plan& plan, bool each_family) {
  const std::string replayed = plan.thorough
                                   ? "every wrong answer"
                                   : fmt::format("up to {} wrong answers of each {} cases",
                                                 replays_a_chunk, grouped(chunk_cases));
  return wrapped(
      fmt::format(
          "Per cent of the cases are wrong, and how; a t is wrong where it is off by more than "
          "1/{:.0f} of itself. {}Cause: by exact replay of {}; formula: "
          "wrong without any rounding too; assumption: right once what it takes for granted is so; "
          "flip: one comparison that rounding turned; rounding: the rest. Margin: how far the "
          "numbers of a case must move for its truth to change, in units u of rounding, to first "
          "order: wrong up to a few u is excusable, wrong at 1e6 u is a defect. Ulp: the error of "
          "t in units of its last place. Forced: the same in units of what rounding the numbers of "
          "the case once would do to t.",
          1 / wrong_t_limit,
          each_family ? "" : "Holds: the families where none is wrong, of how many. ", replayed),
      0);
}

std::string summary(const Run& run, const Ink& ink) {
  std::uint64_t cases = 0, wrong = 0, holding = 0, valid = 0, by_exact = 0, decided = 0;
  std::uint64_t unasked = 0;
  for (const auto& [subject, family, shape, tally, most_ulps] : run.audits) {
    cases += tally.cases;
    unasked += tally.unasked;
    wrong += tally.wrong();
    holding += tally.wrong() == 0;
    valid +=
        tally.cases - tally.of(Verdict::invalid_handled) - tally.of(Verdict::invalid_mishandled);
    by_exact += tally.of(oracle::Stage::integers) + tally.of(oracle::Stage::exact);
    decided += tally.decided();
  }
  const auto share = [](std::uint64_t part, std::uint64_t whole) {
    return part == 0 ? "0" : percent(part, whole);
  };
  const std::string verdict =
      fmt::format("{}% of {} cases wrong; {} of {} audits hold", share(wrong, cases),
                  grouped(cases), grouped(holding), grouped(run.audits.size()));
  return (wrong == 0 ? ink.good(verdict) : ink.bad(verdict)) +
         fmt::format("; {} undecided ({}% needed exact numbers){}\n", grouped(valid - decided),
                     share(by_exact, valid),
                     unasked == 0 ? "" : fmt::format("; {} not asked", grouped(unasked)));
}

/// Whether the subjects keep what they are held to; empty where that is nothing.
std::string bounds(const Run& run, const Ink& ink) {
  if (run.plan.bounds.empty()) return "";
  const std::size_t count = broken(run.plan.bounds, run.audits).size();
  const std::string rows = fmt::format("Bounds: of {} row{}, ", grouped(run.plan.bounds.size()),
                                       run.plan.bounds.size() == 1 ? "" : "s");
  if (count == 0) return rows + ink.good("every limit is kept") + '\n';
  return rows +
         ink.bad(fmt::format("{} limit{} broken", grouped(count), count == 1 ? " is" : "s are")) +
         '\n';
}

}  // namespace

std::string write_table(const Run& run, const Look& look) {
  const Ink ink = {look.colour};
  const bool each_family = run.audits.size() <= audits_with_rows;
  const std::vector<Line> all = lines(run.audits, each_family);
  const Columns columns = columns_of(run.audits);
  std::string text = title(run) + '\n' + legend(run.plan, each_family) + '\n';
  for (const std::size_t shape : run.plan.shapes) {
    std::string rows;
    for (const Line& line : all)
      if (line.shape == shape)
        rows += each_family ? row_of_family(line, columns, ink) : row(line, columns, ink);
    if (rows.empty()) continue;
    const std::string_view name = shape_names[shape];
    text += (each_family ? heading_of_families(name, columns, ink) : heading(name, columns, ink)) +
            rows + '\n';
  }
  const std::string touches = write_touches(run, ink);
  if (!touches.empty()) text += touches + '\n';
  text += write_findings(run, ink, look.everything) + '\n';
  text += write_limits(run, ink) + '\n';
  if (!each_family) text += holding(run, ink) + '\n';
  return text + surroundings(run.environment) + bounds(run, ink) + summary(run, ink);
}

}  // namespace rayaudit
