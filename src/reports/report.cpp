#include "reports/report.hpp"

#include "reports/page.hpp"
#include "reports/scene_run.hpp"

namespace rayaudit {
namespace {

constexpr std::string_view page_about =
    "for people, in a browser: one page with charts that needs no network";

constexpr ReportOf<Run> of_audits[] = {
    {"table", "for people: what is wrong of each subject, and the findings, worst first",
     write_table},
    {"libraries", "for people: libraries, as --libraries audits them, beside the textbook",
     write_library_table},
    {"json", "for programs: everything, with the worst case of each kind", write_json},
    {"csv", "for spreadsheets: a row for each subject, shape and family", write_csv},
    {"html", page_about, write_html, require_page},
    {"junit", "for continuous integration: a testcase for each subject, shape and family",
     write_junit},
    {"markdown", "for a pull request: the verdict, a table, and the worst findings folded up",
     write_markdown},
};

constexpr ReportOf<CostRun> of_costs[] = {
    {"table", "for people: the front of each shape, and what its next steps cost",
     write_cost_table},
    {"json", "for programs: every way on every shape and family", write_cost_json},
    {"html", page_about, write_cost_html, require_page},
};

constexpr ReportOf<LadderRun> of_ladders[] = {
    {"table", "for people: how far each subject holds, and how its errors rise",
     write_ladder_table},
    {"json", "for programs: every subject at every difficulty", write_ladder_json},
    {"html", page_about, write_ladder_html, require_page},
};

constexpr ReportOf<SceneRun> of_scenes[] = {
    {"table", "for people: what each effect costs and has wrong, and what each offset would do",
     write_scene_table},
    {"json", "for programs: everything, with the worst case of each kind", write_scene_json},
    {"html", "for people, in a browser: one page with the pictures side by side, without script",
     write_scene_html},
};

}  // namespace

std::span<const ReportOf<Run>> reports() { return of_audits; }
std::span<const ReportOf<CostRun>> cost_reports() { return of_costs; }
std::span<const ReportOf<LadderRun>> ladder_reports() { return of_ladders; }

std::span<const ReportOf<SceneRun>> scene_reports() { return of_scenes; }

}  // namespace rayaudit
