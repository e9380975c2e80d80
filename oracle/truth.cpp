#include "oracle/truth.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "oracle/block.hpp"
#include "oracle/environment.hpp"
#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"
#include "oracle/stages.hpp"

namespace rayaudit::oracle {
namespace {

Truth exact_truth(const Case& question, int bits) {
  Truth truth{.stage = Stage::exact};
  const ExactRoots found = exact_roots(question, false);
  for (const ExactRoot& root : std::span(found.listed.data(), found.count)) {
    const Real t = value(root.t, bits);
    const bool stretch = root.outlined.kind == Kind::within;
    truth.listed[truth.count++] = {root.outlined.kind, t, stretch ? value(root.t_last, bits) : t};
  }
  return truth;
}

/// The roots of F that are no crossings, where the bounds know them well.
void fill_others(Truth& truth, const Outline& outline, const Values& values, int t_exponent) {
  const int roots = outline.listed[0].which == Which::smaller ? 2 : 1;
  truth.others_known = true;
  for (int j = 0; j < roots; ++j) {
    if (j < outline.count && outline.listed[j].standing == Standing::acceptable) continue;
    truth.others_known = truth.others_known && known_to(values[j], 0x1p-60);
    truth.other_roots[truth.other_count++] = {values[j].high, values[j].low, 0, t_exponent};
  }
}

/// The truth of an outline that intervals are sure of; false where the bounds leave t too wide.
bool fill(Truth& truth, const Case& question, const Outline& outline, const Values& values,
          double relative, int t_exponent) {
  for (int j = 0; j < outline.count; ++j) {
    const auto& [which, standing, kind] = outline.listed[j];
    if (standing != Standing::acceptable) continue;
    Real t{values[j].high, values[j].low, 0, t_exponent};
    if (kind == Kind::start || kind == Kind::end)
      t = {kind == Kind::start ? question.ray.t_min : question.ray.t_max, 0, 0, t_exponent};
    else if (!known_to(values[j], relative))
      return false;
    truth.listed[truth.count++] = {kind, t, t};
  }
  if (truth.count > 0) fill_others(truth, outline, values, t_exponent);
  return true;
}

void settle_block(std::span<const Case> cases, std::span<Truth> truths, int bits) {
  Block in;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const bool moderate = is_moderate(cases[i]);
    truths[i].clear();
    truths[i].invalid = invalid(cases[i], moderate);
    if (truths[i].invalid == Invalid::no && !in.ask(cases[i], i, moderate))
      truths[i] = exact_truth(cases[i], bits);
  }
  std::array<Outline, block> outlines;
  std::array<Stage, block> stages;
  std::array<Values, block> values;
  const std::span asked = in.cases();
  outline_by_intervals(asked, outlines);
  for (std::size_t i = 0; i < in.count; ++i) {
    stages[i] = outlines[i].unsure ? Stage::exact : Stage::interval;
    if (outlines[i].unsure) outlines[i] = outline_exactly(*asked[i]);
  }
  values_by_bounds(asked, outlines, values);
  const double relative = std::ldexp(1.0, -bits);
  for (std::size_t i = 0; i < in.count; ++i) {
    Truth& truth = truths[in.place[i]];
    if (outlines[i].within ||
        !fill(truth, *asked[i], outlines[i], values[i], relative, in.t_exponent[i]))
      truth = exact_truth(cases[in.place[i]], bits);
    truth.stage = stages[i];
  }
}

/// The exact t of a crossing: of the roots of its kind, the one nearest to the t it holds.
Radical found_again(const Case& question, const Crossing& crossing, bool last) {
  const ExactRoots found = exact_roots(question, false);
  const ExactRoot* best = nullptr;
  Real gap;
  for (const ExactRoot& root : std::span(found.listed.data(), found.count)) {
    if (root.outlined.kind != crossing.kind) continue;
    Real apart = difference(value(root.t, 150), crossing.t);
    if (sign(apart) < 0) apart = difference({}, apart);
    if (best == nullptr || compare(apart, gap) < 0) best = &root, gap = apart;
  }
  return last ? best->t_last : best->t;
}

/// t rounded to nearest in N: at once where every number within 2^-60 |t| rounds alike.
template <class N>
N rounded_t(const Case& question, const Crossing& crossing, const Real& t, bool last) {
  const double slack = std::ldexp(t.high, -60);
  const N below = rayaudit::nearest<N>(difference(t, {slack, 0, 0, t.exponent}));
  const N above = rayaudit::nearest<N>(difference(t, {-slack, 0, 0, t.exponent}));
  if (below == above && t.high != 0) return below;
  return oracle::nearest<N>(found_again(question, crossing, last));
}

}  // namespace

std::string_view name(Invalid invalid) {
  constexpr std::array<std::string_view, 8> names = {
      "no",          "nan",       "infinite", "zero_direction",
      "zero_normal", "zero_axis", "radius",   "empty_range"};
  return names[static_cast<std::size_t>(invalid)];
}

std::string_view name(Kind kind) {
  constexpr std::array<std::string_view, 7> names = {"proper", "tangent", "rim",   "apex",
                                                     "start",  "end",     "within"};
  return names[static_cast<std::size_t>(kind)];
}

std::string_view name(Standing standing) {
  constexpr std::array<std::string_view, 6> names = {"acceptable", "later",   "behind",
                                                     "past",       "clipped", "mirrored"};
  return names[static_cast<std::size_t>(standing)];
}

void truth(std::span<const Case> cases, std::span<Truth> truths, int bits) {
  require_plain_arithmetic();
  for (std::size_t i = 0; i < cases.size(); i += block) {
    const std::size_t size = std::min(block, cases.size() - i);
    settle_block(cases.subspan(i, size), truths.subspan(i, size), bits);
  }
}

Truth truth(const Case& question, int bits) {
  Truth answer;
  truth({&question, 1}, {&answer, 1}, bits);
  return answer;
}

Roots roots(const Case& question, int bits) {
  const ExactRoots found = exact_roots(question, true);
  Roots listed{.constant = found.constant};
  for (const ExactRoot& root : std::span(found.listed.data(), found.count))
    listed.listed[listed.count++] = {value(root.t, bits), root.outlined.standing,
                                     root.outlined.kind};
  return listed;
}

template <class N>
N rounded(const Case& question, const Crossing& crossing) {
  return rounded_t<N>(question, crossing, crossing.t, false);
}
template float rounded(const Case&, const Crossing&);
template double rounded(const Case&, const Crossing&);
template long double rounded(const Case&, const Crossing&);

template <class N>
N rounded_last(const Case& question, const Crossing& crossing) {
  return rounded_t<N>(question, crossing, crossing.t_last, true);
}
template float rounded_last(const Case&, const Crossing&);
template double rounded_last(const Case&, const Crossing&);
template long double rounded_last(const Case&, const Crossing&);

Spelled spelled(const Case& question, const Crossing& crossing, int digits) {
  return spelled(found_again(question, crossing, false), digits);
}

Spelled spelled_last(const Case& question, const Crossing& crossing, int digits) {
  return spelled(found_again(question, crossing, true), digits);
}

}  // namespace rayaudit::oracle
