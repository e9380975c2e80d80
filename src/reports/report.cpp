#include "reports/report.hpp"

namespace rayaudit {
namespace {

constexpr Report table[] = {
    {"table", "for people: what is wrong of each subject, and the findings, worst first",
     write_table},
    {"json", "for programs: everything, with the worst case of each kind", write_json},
    {"csv", "for spreadsheets: a row for each subject, shape and family", write_csv},
};

}  // namespace

std::span<const Report> reports() { return table; }

}  // namespace rayaudit
