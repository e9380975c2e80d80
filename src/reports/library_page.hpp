#pragma once

#include <string>
#include <vector>

#include "reports/library_words.hpp"
#include "reports/report.hpp"

namespace rayaudit {

/// A finding whose program was run outside and said what the audit saw.
struct Confirmed {
  const LibraryFinding* finding;
  LibraryProgram shown_by;
  /// Those of the same library that the same case shows: one finding in several subjects.
  std::vector<Confirmed> same = {};
};

/// The findings of a run that have a program to show them, in their order.
std::vector<Confirmed> to_be_confirmed(const std::vector<LibraryFinding>& findings,
                                       const Convention& stated);

/// The same with what one case shows of several subjects of a library at the first of them.
std::vector<Confirmed> told_once(const std::vector<Confirmed>& confirmed);

/// The page of findings, in Markdown: what was done and what counts; every library with what was
/// found and confirmed, the programs in the folder `programs` beside
/// it, what trackers could be told in `trackers`; those that are clean. The
/// same run gives the same bytes: no times.
std::string write_library_page(const Run& run, const std::vector<Confirmed>& confirmed);

/// What could be filed with the library as it stands, in Markdown, and what its file is called.
std::string write_tracker(const Confirmed& confirmed, const Run& run);
std::string tracker_file(const Confirmed& confirmed);

/// Its times, which are not the same from run to run.
std::string write_library_times(const Run& run);

}  // namespace rayaudit
