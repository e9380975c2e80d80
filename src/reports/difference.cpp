#include "reports/difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <tuple>

#include "geometry/case_line.hpp"
#include "geometry/error.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

using nlohmann::json;

/// What json::number wrote; nothing where that is null.
std::optional<double> number(const json& of) {
  if (of.is_null()) return {};
  if (of == "inf") return std::numeric_limits<double>::infinity();
  return of.get<double>();
}

RecordedOutcome read_outcome(const json& of) {
  return {of.at("verdict"), of.at("claim"), of.at("count"),
          of.at("cause"),   of.at("case"),  of.at("explain")};
}

RecordedAudit read_audit(const json& of, const json& declared) {
  const json& own = of.at("own");
  RecordedAudit audit = {
      of.at("subject"),         of.at("shape"),
      of.at("family"),          of.at("cases"),
      of.at("wrong"),           {},
      number(own.at("max")),    own.value("case", ""),
      own.value("explain", ""), declared.value(of.at("subject").get<std::string>(), json()).dump(),
      of.value("drawn", "")};
  for (const json& outcome : of.at("outcomes")) audit.outcomes.push_back(read_outcome(outcome));
  return audit;
}

auto key(const RecordedAudit& audit) { return std::tie(audit.subject, audit.shape, audit.family); }

std::string words(const RecordedAudit& audit) {
  return fmt::format("{} on {}, family {}", audit.subject, audit.shape, audit.family);
}

void require_single(const Record& record) {
  std::set<std::tuple<std::string, std::string, std::string>> seen;
  for (const RecordedAudit& audit : record.audits)
    if (!seen.insert(key(audit)).second)
      throw Error(fmt::format("`{}` tells of {} twice", record.name, words(audit)));
}

/// Throws Error unless it is a report of an audit in the schema that this program writes.
void require_audit(const json& report, const std::string& name) {
  if (!report.is_object() || !report.contains("schema") || !report.contains("tool"))
    throw Error(fmt::format("`{}` is no report of rayaudit", name));
  if (report["schema"] != 1)
    throw Error(fmt::format("`{}` has schema {}; this program reads schema 1", name,
                            quotation(report["schema"].dump())));
  if (const json kind = report.value("report", json("audit")); kind != "audit")
    throw Error(fmt::format("`{}` is a report of {}, not of an audit", name,
                            quotation(kind.is_string() ? kind.get<std::string>() : kind.dump())));
}

json parsed(std::string_view text, const std::string& name) {
  try {
    return json::parse(text);
  } catch (const json::parse_error& fault) {
    if (fault.byte > text.size())
      throw Error(
          fmt::format("`{}` breaks off after {} bytes: it is not whole", name, text.size()));
    throw Error(fmt::format("`{}` is no JSON at byte {}", name, fault.byte));
  }
}

using Outcomes = std::map<std::tuple<std::string, std::string>, const RecordedOutcome*>;

Outcomes by_kind(const RecordedAudit& audit) {
  Outcomes all;
  for (const RecordedOutcome& each : audit.outcomes) all[{each.verdict, each.claim}] = &each;
  return all;
}

/// Two audits of the same cases.
class Pair {
 public:
  Pair(const RecordedAudit& before, const RecordedAudit& after, Difference& difference)
      : before_(before), after_(after), difference_(difference) {}

  void compare_outcomes() {
    const Outcomes before = by_kind(before_), after = by_kind(after_);
    std::set<Outcomes::key_type> kinds;
    for (const Outcomes* each : {&before, &after})
      for (const auto& [kind, outcome] : *each) kinds.insert(kind);
    const auto of = [](const Outcomes& all, const auto& kind) {
      const auto found = all.find(kind);
      return found == all.end() ? nullptr : found->second;
    };
    for (const auto& kind : kinds) {
      const auto* old_one = of(before, kind);
      const auto* new_one = of(after, kind);
      if (is_whole() || is_no_answer(old_one != nullptr ? *old_one : *new_one))
        compare(old_one, new_one);
    }
  }

  void compare_errors() {
    if (!is_whole() || !before_.own || !after_.own) return;
    const auto change = [&](const RecordedAudit& shown) {
      return Change{after_.subject, after_.shape, after_.family,  "max_own_ulp",
                    "none",         *before_.own, *after_.own,    0,
                    false,          "",           shown.own_line, shown.own_explain};
    };
    const auto is_more = [](double a, double b) { return a > 1 && a > error_factor * b; };
    if (is_more(*after_.own, *before_.own)) difference_.broke.push_back(change(after_));
    if (is_more(*before_.own, *after_.own)) difference_.fixed.push_back(change(before_));
  }

  /// Was each asked all of the same cases? Else counts are of different ones.
  bool is_whole() const { return before_.cases == after_.cases; }

 private:
  static bool is_no_answer(const RecordedOutcome& outcome) {
    return outcome.verdict == name(Verdict::crashed) ||
           outcome.verdict == name(Verdict::timed_out) || outcome.claim == name(Claim::ended) ||
           outcome.claim == name(Claim::hung);
  }

  /// One kind of wrong answer; null where there was none.
  void compare(const RecordedOutcome* before, const RecordedOutcome* after) {
    const std::uint64_t old_count = before != nullptr ? before->count : 0;
    const std::uint64_t new_count = after != nullptr ? after->count : 0;
    // The worst of the same cases is the same: where it is another, some case is.
    const bool others = is_whole() && old_count == new_count &&
                        difference_.before.shares == difference_.after.shares &&
                        read_case_line(before->line).words != read_case_line(after->line).words;
    const auto change = [&](const RecordedOutcome& shown) {
      return Change{after_.subject,
                    after_.shape,
                    after_.family,
                    shown.verdict,
                    shown.claim,
                    static_cast<double>(old_count),
                    static_cast<double>(new_count),
                    after_.cases,
                    others,
                    shown.cause,
                    shown.line,
                    shown.explain};
    };
    if (new_count > old_count || others) difference_.broke.push_back(change(*after));
    if (new_count < old_count || others) difference_.fixed.push_back(change(*before));
  }

  const RecordedAudit& before_;
  const RecordedAudit& after_;
  Difference& difference_;
};

/// Throws Error unless a pair of audits was asked the same, under the same convention.
void require_same_cases(const Difference& difference, const RecordedAudit& before,
                        const RecordedAudit& after) {
  const auto require = [&](bool same, std::string_view what) {
    if (!same)
      throw Error(fmt::format("`{}` and `{}` cannot be compared: {} {}", difference.before.name,
                              difference.after.name, words(after), what));
  };
  require(before.convention == after.convention, "declares another convention");
  require(before.drawn.empty() || after.drawn.empty() || before.drawn == after.drawn,
          "was asked other cases");
}

}  // namespace

Record read_record(std::string_view text, const std::string& name) {
  const json report = parsed(text, name);
  require_audit(report, name);
  try {
    Record record = {name,
                     report.at("tool").at("version"),
                     report.at("seed"),
                     report.at("cases"),
                     report.at("difficulty").dump(),
                     report.at("convention").dump(),
                     report.at("shares").dump(),
                     {}};
    for (const json& audit : report.at("audits"))
      record.audits.push_back(read_audit(audit, report.at("declared")));
    require_single(record);
    return record;
  } catch (const json::exception& fault) {
    const std::string_view why = fault.what();
    throw Error(fmt::format(
        "`{}` is no report of an audit that can be compared ({}): was it written by another "
        "version of rayaudit?",
        name, why.substr(std::min(why.find("] ") + 2, why.size()))));
  }
}

Record record_of(const Run& run, const std::string& name) {
  return read_record(write_json(run, {}), name);
}

void rename_subject(Record& record, std::string_view renaming) {
  const std::size_t equals = renaming.find('=');
  if (equals == renaming.npos || equals == 0 || equals + 1 == renaming.size())
    throw Error("--map: expected OLD=NEW, got " + quotation(renaming));
  const std::string_view old_name = renaming.substr(0, equals);
  bool any = false;
  std::set<std::string_view> known;
  for (RecordedAudit& audit : record.audits) {
    known.insert(audit.subject);
    if (audit.subject == old_name) any = true;
  }
  if (!any)
    throw Error("--map: " + unknown_name("subject of `" + record.name + "`", old_name,
                                         std::vector(known.begin(), known.end())));
  for (RecordedAudit& audit : record.audits)
    if (audit.subject == old_name) audit.subject = renaming.substr(equals + 1);
  require_single(record);
}

void require_same_cases(const Record& before, const Record& after) {
  const auto require = [&](std::string_view what, const auto& old_value, const auto& new_value) {
    if (old_value != new_value)
      throw Error(fmt::format("`{}` and `{}` cannot be compared: {} {} there, {} here", before.name,
                              after.name, what, old_value, new_value));
  };
  require("seed", before.seed, after.seed);
  require("cases", before.cases, after.cases);
  require("difficulty", before.difficulty, after.difficulty);
  require("convention", before.convention, after.convention);
}

Difference difference(Record before, Record after) {
  require_same_cases(before, after);
  Difference found = {std::move(before), std::move(after), {}, {}, {}, {}, 0, 0};
  using Key = std::tuple<std::string, std::string, std::string>;
  std::map<Key, const RecordedAudit*> old_audits;
  for (const RecordedAudit& audit : found.before.audits) old_audits[key(audit)] = &audit;
  for (const RecordedAudit& audit : found.after.audits) {
    const auto old_audit = old_audits.find(key(audit));
    if (old_audit == old_audits.end()) {
      found.added.push_back(audit);
      continue;
    }
    require_same_cases(found, *old_audit->second, audit);
    Pair pair(*old_audit->second, audit, found);
    pair.compare_outcomes();
    pair.compare_errors();
    ++found.compared;
    found.partly += !pair.is_whole();
    old_audits.erase(old_audit);
  }
  for (const RecordedAudit& audit : found.before.audits)
    if (old_audits.count(key(audit)) > 0) found.gone.push_back(audit);
  return found;
}

}  // namespace rayaudit
