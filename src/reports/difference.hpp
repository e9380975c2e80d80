#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/report.hpp"

namespace rayaudit {

/// A kind of wrong answer that a report tells of, with its worst case.
struct RecordedOutcome {
  std::string verdict, claim;
  std::uint64_t count;
  std::string cause, line, explain;
};

/// An audit that a report tells of.
struct RecordedAudit {
  std::string subject, shape, family;
  std::uint64_t cases, wrong;
  std::vector<RecordedOutcome> outcomes;
  /// The largest own error in ulps, where any was measured, and the case that has it.
  std::optional<double> own;
  std::string own_line, own_explain;
  std::string convention, drawn;  ///< what its subject declared; which cases were drawn
};

/// What a json report of an audit tells that another can be held against.
struct Record {
  std::string name;  ///< of its file
  std::string version;
  std::uint64_t seed, cases;
  std::string difficulty, convention, shares;  ///< as they stand there
  std::vector<RecordedAudit> audits;
};

/// Reads a json report of an audit; throws Error where it is none, or not whole.
Record read_record(std::string_view json, const std::string& name);

/// The record that a run's json report would be.
Record record_of(const Run& run, const std::string& name);

/// Renames a subject: `OLD=NEW`. Throws Error where there is no such subject.
void rename_subject(Record& record, std::string_view renaming);

/// Throws Error that tells what differs, unless both were asked the same: seed, cases, difficulty,
/// convention.
void require_same_cases(const Record& before, const Record& after);

/// One kind of wrong answer of an audit that became more or less frequent, or an error that grew
/// or shrank.
struct Change {
  std::string subject, shape, family;
  std::string what, claim;  ///< a verdict and its claim, or `max_own_ulp`
  double before, after;     ///< in cases, or in ulps
  std::uint64_t cases;      ///< of which; 0 where it is an error
  bool others = false;      ///< as many as before, but not the same
  std::string cause, line, explain;
};

/// What one run of the same cases has otherwise than another.
struct Difference {
  Record before, after;
  std::vector<Change> broke, fixed;
  std::vector<RecordedAudit> gone, added;  ///< audits that only one of them has
  std::size_t compared = 0;
  std::size_t partly = 0;  ///< of these, by crashes and time-outs alone: not all cases were asked
};

/// An error that grew to more than so many times itself broke, or shrank as much is fixed, where
/// the larger is more than one unit.
inline constexpr double error_factor = 2;

/// Holds one record against another of the same cases. Throws Error where they are not.
Difference difference(Record before, Record after);

std::string write_difference_table(const Difference& difference, const Look& look);
std::string write_difference_json(const Difference& difference, const Look& look);
std::string write_difference_markdown(const Difference& difference, const Look& look);

std::span<const ReportOf<Difference>> difference_reports();

/// A change in a sentence without its full stop.
std::string told(const Change& change);

/// How much broke and was fixed, in a sentence without its full stop.
std::string summary(const Difference& difference);

}  // namespace rayaudit
