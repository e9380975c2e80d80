#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/tally.hpp"

namespace rayaudit {

struct Audit;

/// What of a tally can be limited.
struct Quantity {
  std::string_view name;
  bool is_count;                        ///< of cases, out of all
  double (*seen)(const Tally&);         ///< 0 where nothing of it was seen
  const Worst* (*worst)(const Tally&);  ///< the case that shows it most, or null
};

/// Every quantity there is, by name: the wrong verdicts, all of them together, errors, margin.
std::span<const Quantity> quantities();

/// The most that a quantity may be.
struct Limit {
  const Quantity* quantity;
  double most;

  friend bool operator==(const Limit&, const Limit&) = default;
};

/// The names of all subjects there are.
std::span<const std::string_view> subject_names();

/// A promise that subjects are held to: one row of a file.
struct Bound {
  std::string subject, shape, family;  ///< names, or globs for many
  std::vector<Limit> limits;
  bool proved = false;     ///< else only observed
  std::string place = {};  ///< `file:line`, empty where it was not read

  bool is_about(const Audit& audit) const;
};

/// Reads `SUBJECT SHAPE FAMILY LIMIT VALUE ... proved|observed` from each line of a file that is no
/// comment and not blank. Throws Error with file and line where it cannot, or a name is none of
/// those of the subjects.
std::vector<Bound> read_bounds(std::string_view text, const std::string& file,
                               std::span<const std::string_view> subjects = subject_names());

/// Does any of the bounds speak of the audit?
bool is_named(const Audit& audit, const std::vector<Bound>& bounds);

/// The most ulps that all bounds grant its right answers, where they limit them.
std::optional<double> most_ulps(const Audit& audit, const std::vector<Bound>& bounds);

/// A limit that an audit does not keep.
struct Broken {
  const Bound* bound;
  const Audit* audit;
  Limit limit;
  double seen;
  const Worst* worst;
};

/// All that is broken, in the order of the bounds, their audits and limits. Cases that were not
/// asked break every row that does not grant them.
std::vector<Broken> broken(const std::vector<Bound>& bounds, const Audit& audit);
std::vector<Broken> broken(const std::vector<Bound>& bounds, const std::vector<Audit>& audits);

/// The strictest bounds that every audit keeps, a row each. Of wrong verdicts that occurred only
/// the margin is told: how often they do depends on the number of cases. Where room is more than 1,
/// an error or a margin is granted so many times what was seen, and only what is likely to be kept
/// by other cases too is told.
std::vector<Bound> observed(const std::vector<Audit>& audits, double room = 1);

/// The least number of two decimal digits that is not below x; x itself where it is 0 or infinite.
double rounded_up(double x);

}  // namespace rayaudit
