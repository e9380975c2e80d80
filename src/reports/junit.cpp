#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "reports/failure_block.hpp"
#include "reports/failures.hpp"
#include "reports/figures.hpp"
#include "reports/report.hpp"
#include "reports/xml_text.hpp"

namespace rayaudit {
namespace {

using figures::grouped;

/// One subject on one shape and family, as continuous integration tells of it.
struct TestCase {
  const Audit* audit;
  std::vector<Failure> failures;
};

std::string message(const TestCase& of) {
  std::string text;
  for (const Failure& failure : of.failures) text += (text.empty() ? "" : "; ") + failure.told;
  return text;
}

/// What failed, and the worst case of each, in full.
std::string failure(const TestCase& of, const Convention& stated) {
  std::string text;
  for (const Failure& each : of.failures)
    text += fmt::format(
        "{}{}\n{}", text.empty() ? "" : "\n", each.told,
        each.worst == nullptr ? "" : failure_block(*each.worst, *of.audit->subject, stated));
  return "    <failure" + xml_attribute("type", of.failures.front().type) +
         xml_attribute("message", message(of)) + '>' + xml_text(text) + "</failure>\n";
}

std::string opening(const Audit& audit) {
  return "  <testcase" +
         xml_attribute("classname",
                       fmt::format("{}.{}", audit.subject->name, shape_names[audit.shape])) +
         xml_attribute("name", audit.family->id) + xml_attribute("time", "0");
}

std::string element(const TestCase& of, const Convention& stated) {
  std::string inside;
  if (!of.failures.empty()) inside += failure(of, stated);
  if (const std::uint64_t unasked = of.audit->tally.unasked; unasked > 0)
    inside += "    <system-out>" +
              xml_text(grouped(unasked) +
                       " cases were not asked: the subject crashed or timed out too often before") +
              "</system-out>\n";
  return opening(*of.audit) + (inside.empty() ? "/>\n" : ">\n" + inside + "  </testcase>\n");
}

/// Of an audit that the plan has and the run has not: its subject was not asked any more.
std::string skipped(const Audit& audit) {
  return opening(audit) + ">\n    <skipped" +
         xml_attribute("message", "not asked: the subject crashed or timed out too often before") +
         "/>\n  </testcase>\n";
}

auto key(const Audit& audit) { return std::tuple(audit.subject, audit.shape, audit.family); }

/// The suite of one subject.
struct Suite {
  const Subject* subject;
  std::uint64_t cases = 0, failed = 0, skipped = 0;
  std::string inside = {};

  std::string counts() const {
    return fmt::format(R"( tests="{}" failures="{}" errors="0" skipped="{}" time="0")", cases,
                       failed, skipped);
  }
};

std::vector<Suite> suites(const Run& run) {
  std::vector<Suite> all;
  const auto suite = [&](const Audit& audit) -> Suite& {
    const auto known = std::find_if(
        all.begin(), all.end(), [&](const Suite& each) { return each.subject == audit.subject; });
    Suite& found = known == all.end() ? all.emplace_back(Suite{audit.subject}) : *known;
    ++found.cases;
    return found;
  };
  std::set<decltype(key(run.audits.front()))> there;
  for (const Audit& audit : run.audits) {
    there.insert(key(audit));
    const TestCase made = {&audit, failures(audit, run)};
    Suite& here = suite(audit);
    here.failed += !made.failures.empty();
    here.inside += element(made, run.plan.convention);
  }
  for (const Audit& audit : planned(run.plan)) {
    if (there.count(key(audit)) > 0) continue;
    Suite& here = suite(audit);
    ++here.skipped;
    here.inside += skipped(audit);
  }
  return all;
}

}  // namespace

std::string write_junit(const Run& run, const Look&) {
  Suite sum = {nullptr};
  std::string inside;
  for (const Suite& suite : suites(run)) {
    sum.cases += suite.cases, sum.failed += suite.failed, sum.skipped += suite.skipped;
    inside += " <testsuite" + xml_attribute("name", suite.subject->name) + suite.counts() + ">\n" +
              suite.inside + " </testsuite>\n";
  }
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites" +
         xml_attribute("name", "rayaudit " + run.version) + sum.counts() + ">\n" + inside +
         "</testsuites>\n";
}

}  // namespace rayaudit
