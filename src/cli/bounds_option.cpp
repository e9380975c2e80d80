#include "cli/bounds_option.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "cli/exit_code.hpp"
#include "cli/lines.hpp"
#include "geometry/error.hpp"
#include "reports/explain_line.hpp"
#include "reports/figures.hpp"
#include "reports/promise.hpp"

namespace rayaudit {
namespace {

std::string text_of(LineFile& file) {
  std::string text;
  for (auto pieces = file.next(); !pieces.empty(); pieces = file.next())
    for (const Piece& piece : pieces) text += piece.text;
  return text;
}

/// Loads the libraries that the rows of a file of bounds name.
void load_libraries(const std::string& text, const std::string& file, Subjects& subjects) {
  std::istringstream lines(text);
  std::size_t number = 1;
  for (std::string line; std::getline(lines, line); ++number) {
    std::istringstream words(line.substr(0, line.find('#')));
    std::string pattern;
    if (!(words >> pattern)) continue;
    try {
      subjects.load(pattern);
    } catch (const Error& why) {
      throw Error(fmt::format("{}:{}: {}", file, number, why.what()));
    }
  }
}

/// Every audit there is of these subjects.
std::vector<Audit> every_audit(const std::vector<const Subject*>& subjects) {
  Plan plan;
  plan.subjects = subjects;
  for (const Family& family : families()) plan.families.push_back(&family);
  for (std::size_t shape = 0; shape < shape_count; ++shape) plan.shapes.push_back(shape);
  return planned(plan);
}

/// The limits of a bound, and whether it is proved.
std::string whole_promise(const Bound& bound) {
  return ' ' + promise(bound.limits) + (bound.proved ? " proved" : " observed");
}

/// What was seen of a quantity: never so rounded that it would seem to be within the limit.
std::string seen(const Broken& broken) {
  if (!broken.limit.quantity->is_count) {
    const std::string text = fmt::format("{:.3g}", broken.seen);
    return std::strtod(text.c_str(), nullptr) > broken.limit.most ? text : promise(broken.seen);
  }
  return fmt::format("{} of {} cases", figures::grouped(static_cast<std::uint64_t>(broken.seen)),
                     figures::grouped(broken.audit->tally.cases));
}

}  // namespace

std::vector<Bound> read_bounds_file(const std::string& path, Subjects& subjects) {
  LineFile file(path);
  const std::string text = text_of(file);
  load_libraries(text, file.name(), subjects);
  std::vector<std::string_view> names;
  names.reserve(subjects.all().size());
  for (const Subject* subject : subjects.all()) names.push_back(subject->name);
  std::vector<Bound> bounds = read_bounds(text, file.name(), names);
  if (bounds.empty()) throw NothingAudited(file.name() + " has no row: nobody is held to anything");
  const std::vector<Audit> audits = every_audit(subjects.all());
  for (const Bound& bound : bounds)
    if (std::none_of(audits.begin(), audits.end(),
                     [&](const Audit& audit) { return bound.is_about(audit); }))
      throw NothingAudited(fmt::format(
          "{}: `{} {} {}` names no audit there is: no such subject answers such a shape that such "
          "a family draws",
          bound.place, bound.subject, bound.shape, bound.family));
  return bounds;
}

std::string row(const Bound& bound) {
  return bound.subject + ' ' + bound.shape + ' ' + bound.family + whole_promise(bound);
}

std::string write_bounds(const std::vector<Bound>& bounds, const std::vector<std::string>& head) {
  std::string text;
  for (const std::string& line : head) text += "# " + line + '\n';
  text += "# SUBJECT SHAPE FAMILY, limits with their values, proved or observed\n";
  std::size_t subject = 0, shape = 0, family = 0;
  for (const Bound& bound : bounds) {
    subject = std::max(subject, bound.subject.size());
    shape = std::max(shape, bound.shape.size());
    family = std::max(family, bound.family.size());
  }
  for (const Bound& bound : bounds)
    text += fmt::format("{:<{}} {:<{}} {:<{}}{}\n", bound.subject, subject, bound.shape, shape,
                        bound.family, family, whole_promise(bound));
  return text;
}

std::string told(const Broken& broken, const Convention& convention) {
  const auto& [bound, audit, limit, _, worst] = broken;
  return fmt::format("{}: `{}` is broken by {} on {}, family {}: {} is {}, more than {}{}",
                     bound->place, row(*bound), audit->subject->name, shape_names[audit->shape],
                     audit->family->id, limit.quantity->name, seen(broken), promise(limit.most),
                     worst == nullptr
                         ? ""
                         : fmt::format("; cause: {}: {}", told(worst->diagnosis),
                                       explain_line(*worst, *audit->subject, convention)));
}

std::string told(const Break& broken, const Climb& climb, const Family& family) {
  const auto& [k, bound, limit, seen, worst] = broken;
  return fmt::format(
      "{}: `{}` is broken by {} on {}, family {} at k = {}: {} is {}, more than {}{}", bound.place,
      row(bound), climb.subject->name, shape_names[climb.shape], family.id, k, limit.quantity->name,
      figures::magnitude(seen), promise(limit.most),
      worst ? ": " + explain_line(*worst, *climb.subject) : "");
}

}  // namespace rayaudit
