#include <fmt/format.h>

#include "audit/audit.hpp"
#include "audit/library_times.hpp"
#include "cli/audit_end.hpp"
#include "cli/bounds_option.hpp"
#include "cli/command.hpp"
#include "cli/command_text.hpp"
#include "cli/convention_option.hpp"
#include "cli/exit_code.hpp"
#include "cli/libraries_option.hpp"
#include "cli/names.hpp"
#include "cli/option.hpp"
#include "cli/page_option.hpp"
#include "cli/progress_bar.hpp"
#include "cli/ranks_run.hpp"
#include "cli/selection.hpp"
#include "cli/shard_option.hpp"
#include "geometry/error.hpp"
#include "oracle/checked.hpp"

namespace rayaudit {
namespace {

constexpr std::int64_t default_cases = 10'000;

Plan default_plan() {
  Plan plan;
  plan.cases = default_cases;
  plan.seed = default_seed;
  return plan;
}

struct AuditOptions {
  SubjectChoice subjects;
  std::vector<std::string> shapes, families, bounds;
  Plan plan = default_plan();
  bool is_shard = false;
  LibrariesOption libraries;
  std::string page;  ///< the folder that the page of findings goes to, or empty
  AuditEnd end;
  std::string command;  ///< what of it was typed that says what is run
};

/// A difficulty must be one of every family that has any, in every format it will be drawn in.
void require_difficulty(const std::vector<Audit>& audits, int difficulty) {
  bool any = false;
  for (const Audit& audit : audits) {
    if (!audit.family->difficulty) continue;
    any = true;
    rayaudit::require_difficulty(*audit.family, audit.subject->drawn_in(), difficulty);
  }
  if (!any) throw Error("--difficulty: no family chosen has a difficulty");
}

Plan plan_of(const AuditOptions& options, Subjects& subjects,
             const std::deque<Subject>& libraries) {
  Plan plan = options.plan;
  plan.beside_textbook = options.libraries.is_asked;
  if (plan.beside_textbook)
    for (const Subject& subject : libraries) plan.subjects.push_back(&subject);
  else
    plan.subjects = subjects.selected(options.subjects);
  for (const std::size_t i :
       selected("family", options.families, names_of(families(), &Family::id)))
    plan.families.push_back(&families()[i]);
  plan.shapes = selected("shape", options.shapes, shape_names);
  for (const std::string& file : options.bounds)
    for (const Bound& bound : read_bounds_file(file, subjects)) plan.bounds.push_back(bound);
  const std::vector<Audit> audits = planned(plan);
  if (audits.empty())
    throw NothingAudited(
        plan.bounds.empty()
            ? "nothing to audit: no chosen subject answers a chosen shape that a chosen family "
              "draws"
            : "nothing was held: no row of " + fmt::format("{}", fmt::join(options.bounds, ", ")) +
                  " is about a chosen subject, shape and family");
  if (plan.difficulty) require_difficulty(audits, *plan.difficulty);
  return plan;
}

/// What of the command line says what is run: not where to, how fast, nor in how many parts.
std::string command_text_of_run(const CLI::App& command) {
  std::vector<std::string> others = audit_end_options();
  others.insert(others.end(), {"--page", "--shard", "--threads"});
  return command_text(command, others);
}

std::vector<Audit> run_with_progress(const Plan& plan) {
  ProgressBar bar;
  return run(plan, [&](const Progress& progress) { bar.tell(progress); });
}

/// Whoever cannot answer at all is told before the run.
void require_answers(const std::vector<Audit>& audits) {
  for (const Audit& audit : audits)
    if (audit.subject->is_elsewhere) audit.subject->answer[audit.shape]({}, {});
}

/// Libraries are an audit of their own: with peers, and cases that all of them have time for.
void require_alone(const AuditOptions& options) {
  if (!options.subjects.names.empty() || options.subjects.brings_any())
    throw Error("--libraries names what is audited: it goes without other subjects");
  if (options.is_shard) throw Error("--libraries goes without --shard");
}

std::deque<Subject> libraries_of(const AuditOptions& options) {
  if (!options.libraries.is_asked) return {};
  require_alone(options);
  return loaded_libraries(options.libraries.names);
}

/// What is to be run.
struct Prepared {
  std::deque<Subject> libraries;
  Subjects subjects;
  Plan plan;

  explicit Prepared(const AuditOptions& options)
      : libraries(libraries_of(options)),
        subjects(options.subjects),
        plan(plan_of(options, subjects, libraries)) {}
};

ReadyEnd ready_end(const AuditOptions& options, const Plan& plan) {
  ReadyEnd end = ready(options.end, plan);
  if (!options.page.empty()) require_page_folder(options.page);
  return end;
}

/// Tells of audits that are over.
int told(const AuditOptions& options, const ReadyEnd& end, const Plan& plan,
         const std::vector<Audit>& audits, const Environment& environment) {
  Run run = {RAYAUDIT_VERSION, plan, audits, environment, options.command, options.end.fail_on};
  if (plan.beside_textbook) run.times = times_beside_textbook(plan);
  const int code = told(end, run);
  if (!options.page.empty()) write_page_folder(options.page, run);
  return code;
}

int audit_alone(const AuditOptions& options) {
  Prepared prepared(options);
  const Plan& plan = prepared.plan;
  if (options.is_shard) return run_shard(plan, options.end, options.command);
  const ReadyEnd end = ready_end(options, plan);
  require_answers(planned(plan));
  return told(options, end, plan, run_with_progress(plan), environment());
}

int audit_by_ranks(const AuditOptions& options) {
  if (options.is_shard)
    throw Error("--shard goes without mpirun, which gives each process a shard");
  Ranks ranks;
  std::optional<Prepared> prepared;
  std::optional<ReadyEnd> end;
  ranks.together([&] {
    prepared.emplace(options);
    if (ranks.is_first()) end.emplace(ready_end(options, prepared->plan));
    require_answers(planned(prepared->plan));
  });
  ShardSum sum = gathered_by(ranks, prepared->plan, options.command);
  return ranks.by_first([&] {
    conclude(prepared->plan, sum.audits());
    return told(options, *end, prepared->plan, sum.audits(), sum.environment());
  });
}

int audit(const AuditOptions& options) {
  return ranks_started() > 1 ? audit_by_ranks(options) : audit_alone(options);
}

void add_names(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_subjects_and_shapes(command, options->subjects, options->shapes);
  add_list(command, "--family", "FAMILY,...", "names or globs", options->families)->delimiter(',');
}

void add_numbers(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_number(command, "--cases", "for each subject, shape and family; 1e6 and 100k will do", 1,
             largest_cases,
             [=](std::int64_t n) { options->plan.cases = static_cast<std::uint64_t>(n); })
      ->default_str(fmt::format("{}, of libraries {}", default_cases, cases_of_libraries));
  add_seed(command, options->plan.seed);
  add_number(
      command, "--difficulty",
      "draw at difficulty K (see rayaudit list families); default: spread over each family's range",
      INT32_MIN, INT32_MAX, [=](std::int64_t n) { options->plan.difficulty = static_cast<int>(n); })
      ->type_name("K");
  add_number(command, "--threads",
             "else one for each processor, under mpirun of each rank; the findings are the same", 1,
             1024, [=](std::int64_t n) { options->plan.threads = static_cast<int>(n); });
  add_option(command, "--shard", "i/n",
             "the i-th of n parts of all cases, for `rayaudit merge`; with --report shard=FILE",
             [=](const std::string& text) {
               const auto [shard, shards] = read_shard_of_run(text);
               options->plan.shard = shard, options->plan.shards = shards;
               options->is_shard = true;
             });
}

/// The oracle itself, under audit.
void add_oracle(CLI::App& command) {
  add_option(command, "--oracle", "plain|checked",
             "checked: whatever is decided is decided again in exact numbers of any size; exit "
             "3 where they differ",
             [](const std::string& text) {
               if (text == "checked") return oracle::check_every_decision();
               if (text != "plain") throw Error("--oracle: expected plain or checked, not " + text);
             });
}

void add_judgement(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_option(command, "--convention", "KIND=STANCE,...",
             "what the subjects declare, as tangent=hit,rim=miss; also inside=hit|miss|start|any, "
             "direction=unit, ray=line|segment, t_min=T, t_max=T, extent=unbounded|both_nappes, "
             "stand=upright_y|upright_z, opening=angle|cosine",
             [=](const std::string& text) { options->plan.convention = read_convention(text); });
  command.add_flag("--thorough", options->plan.thorough,
                   "margins, proofs and causes of every case, not of a share");
  add_oracle(command);
}

void add_bounds(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  add_list(command, "--bounds", "FILE",
           "exit 1 where a row of the file is broken; only what its rows name is audited; may be "
           "repeated",
           options->bounds);
}

void add_libraries(CLI::App& command, const std::shared_ptr<AuditOptions>& options) {
  CLI::Option* const libraries = add_libraries_option(command, options->libraries);
  add_option(command, "--page", "FOLDER",
             "with it: write the page of findings, each confirmed by a program of its own, to "
             "README.md and programs there",
             [=](const std::string& folder) {
               if (folder.empty()) throw Error("--page: expected a folder");
               options->page = folder;
             })
      ->needs(libraries);
}

}  // namespace

void add_audit_command(CLI::App& program, Command& asked) {
  const auto options = std::make_shared<AuditOptions>();
  CLI::App* command = program.add_subcommand(
      "audit", "Hold subjects against the exact truth and tell what is wrong");
  add_names(*command, options);
  add_libraries(*command, options);
  add_numbers(*command, options);
  add_judgement(*command, options);
  add_bounds(*command, options);
  add_audit_end(*command, options->end);
  command->footer(
      "Without names, every subject, shape and family is audited. A subject that is wrong is a\n"
      "finding, not a failure: the exit code is 0 unless --fail-on, --bounds or --baseline says\n"
      "otherwise.\n\n"
      "Each row of a file of bounds is a promise: SUBJECT SHAPE FAMILY, names or globs; limits "
      "and\n"
      "their values; and whether it is proved or only observed, as in\n"
      "  textbook/float sphere anywhere wrong 0 max_ulp 8 observed  # a comment\n"
      "Limits: wrong, or one wrong verdict, in cases; unasked, else none may be; max_ulp;\n"
      "max_forced; max_own; wrong_margin, in u. Subjects that are brought along join those that "
      "are\n"
      "named, unless the names choose among them.\n\n"
      "Examples:\n"
      "  rayaudit audit\n"
      "  rayaudit audit 'textbook/*' --shape sphere --family grazing,far --cases 1e6\n"
      "  rayaudit audit '*/float' --report table --report json=audit.json\n"
      "  rayaudit audit stable_quadratic/double --fail-on false_hit,false_miss,max_ulp=100\n"
      "  rayaudit audit 'textbook/*' --cases 1e6 --headroom 2 --write-bounds mine.txt\n"
      "  rayaudit audit --bounds mine.txt --seed 2\n"
      "  rayaudit audit '*/float' --baseline audit.json\n"
      "  rayaudit audit --plugin ./libmine.so --cases 1e5\n"
      "  rayaudit audit --program 'python3 mine.py' --shape sphere\n");
  command->callback([=, &asked] {
    options->libraries.is_asked = command->count("--libraries") > 0;
    if (options->libraries.is_asked && command->count("--cases") == 0)
      options->plan.cases = cases_of_libraries;
    options->end.command = command_text(*command);
    options->command = command_text_of_run(*command);
    asked = [options] { return audit(*options); };
  });
}

}  // namespace rayaudit
