#include "oracle/checked.hpp"

#include <atomic>
#include <cmath>
#include <string>

#include "geometry/case_line.hpp"
#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"

namespace rayaudit::oracle {
namespace {

std::atomic<bool> checks = false;

constexpr int ample_bits = 150;

/// |a - b| <= 2^-bits |b|, of which both are known to a few units of 2^-150 only.
bool is_near(const Real& a, const Real& b, int bits) {
  if (is_infinite(b) || b.high == 0) return compare(a, b) == 0;
  const Real apart = difference(a, b);
  return std::fabs(scaled(apart, binade(b))) <=
         scaled(b, binade(b)) * std::ldexp(1 + 0x1p-40, -bits);
}

bool is_said(const Crossing& said, const ExactRoot& known, int bits) {
  return said.kind == known.outlined.kind && said.patch == known.outlined.patch &&
         is_near(said.t, value(known.t, ample_bits), bits) &&
         (said.kind != Kind::within || is_near(said.t_last, value(known.t_last, ample_bits), bits));
}

bool has_root_near(const ExactRoots& all, const Real& t) {
  for (const ExactRoot& root : std::span(all.listed.data(), all.count))
    if (is_near(t, value(root.t, ample_bits), 60)) return true;
  return false;
}

/// What is wrong with a truth, or nothing.
std::string_view flaw(const Case& question, const Truth& truth, int bits) {
  const bool moderate = is_moderate(question);
  if (invalid(question, moderate) != truth.invalid) return "whether the case is valid";
  if (truth.invalid != Invalid::no) return {};
  const ExactRoots known = exact_roots(question, false);
  if (known.count != truth.count) return "how many crossings there are";
  for (int i = 0; i < truth.count; ++i)
    if (!is_said(truth.listed[i], known.listed[i], bits)) return "where the ray crosses, or how";
  if (truth.count == 0 || !truth.others_known) return {};
  const ExactRoots all = exact_roots(question, true);
  for (const Real& other : truth.others())
    if (!has_root_near(all, other)) return "the other roots";
  return {};
}

}  // namespace

void check_every_decision() { checks = true; }
bool checks_every_decision() { return checks.load(std::memory_order_relaxed); }

void confirm(const Case& question, const Truth& truth, int bits) {
  if (const std::string_view what = flaw(question, truth, bits); !what.empty())
    throw Disagreement("the oracle does not agree with itself: " + std::string(name(truth.stage)) +
                       " and exact numbers differ in " + std::string(what) + ": " +
                       case_line(question));
}

}  // namespace rayaudit::oracle
