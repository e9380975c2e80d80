#include "reports/report.hpp"

namespace rayaudit {
namespace {

constexpr ReportOf<Run> of_audits[] = {
    {"table", "for people: what is wrong of each subject, and the findings, worst first",
     write_table},
    {"json", "for programs: everything, with the worst case of each kind", write_json},
    {"csv", "for spreadsheets: a row for each subject, shape and family", write_csv},
};

constexpr ReportOf<CostRun> of_costs[] = {
    {"table", "for people: the front of each shape, and what its next steps cost",
     write_cost_table},
    {"json", "for programs: every way on every shape and family", write_cost_json},
};

constexpr ReportOf<LadderRun> of_ladders[] = {
    {"table", "for people: how far each subject holds, and how its errors rise",
     write_ladder_table},
    {"json", "for programs: every subject at every difficulty", write_ladder_json},
};

}  // namespace

std::span<const ReportOf<Run>> reports() { return of_audits; }
std::span<const ReportOf<CostRun>> cost_reports() { return of_costs; }
std::span<const ReportOf<LadderRun>> ladder_reports() { return of_ladders; }

}  // namespace rayaudit
