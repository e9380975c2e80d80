#include "cli/page_option.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "audit/on_threads.hpp"
#include "cli/output.hpp"
#include "cli/picture_folder.hpp"
#include "cli/report_order.hpp"
#include "reports/library_page.hpp"

namespace rayaudit {
namespace {

namespace fs = std::filesystem;

std::vector<Confirmed> confirmed_of(const std::vector<Confirmed>& all) {
  std::vector<std::string> why(all.size());
  on_threads(0, all.size(), [&](std::size_t i) {
    const auto& [program, sentence, shown, library] = all[i].shown_by;
    why[i] = why_unconfirmed(program, shown.question, shown.answer);
  });
  std::vector<Confirmed> confirmed;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (why[i].empty())
      confirmed.push_back(all[i]);
    else
      complain(fmt::format("not confirmed, and not on the page: {}: {}",
                           all[i].shown_by.program.file, why[i]));
  return confirmed;
}

void write(const fs::path& file, const std::string& text) { deliver(file.string(), text); }

}  // namespace

void require_page_folder(const std::string& folder) {
  for (const char* part : {"programs", "trackers"})
    PictureFolder((fs::path(folder) / part).string());
  require_places({(fs::path(folder) / "README.md").string()});
}

void write_page_folder(const std::string& folder, const Run& run) {
  const std::vector<LibraryFinding> found = library_findings(run.audits);
  const std::vector<Confirmed> shown = to_be_confirmed(found, run.plan.convention);
  if (shown.size() < found.size())
    complain(
        fmt::format("{} of {} findings have no program, or no sentence of their library's "
                    "documentation: they are not on the page",
                    found.size() - shown.size(), found.size()));
  const std::vector<Confirmed> confirmed = confirmed_of(shown);
  const fs::path place = folder;
  for (const char* folder_of : {"programs", "trackers"})
    for (const auto& entry : fs::directory_iterator(place / folder_of)) fs::remove(entry.path());
  for (const Confirmed& each : confirmed)
    write(place / "programs" / each.shown_by.program.file, each.shown_by.program.text);
  const std::vector<Confirmed> told = told_once(confirmed);
  for (const Confirmed& each : told)
    write(place / "trackers" / tracker_file(each), write_tracker(each, run));
  write(place / "README.md", write_library_page(run, told));
  write(place / "times.md", write_library_times(run));
}

}  // namespace rayaudit
