#include "oracle/truth.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "oracle/block.hpp"
#include "oracle/checked.hpp"
#include "oracle/environment.hpp"
#include "oracle/lanes/lanes.hpp"
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
    truth.listed[truth.count++] = {root.outlined.kind, t, stretch ? value(root.t_last, bits) : t,
                                   root.outlined.patch};
  }
  return truth;
}

/// The roots that are no crossings, where the bounds know them well.
void fill_others(Truth& truth, const Outline& outline, const Values& values, int t_exponent) {
  truth.others_known = true;
  const auto add = [&](const Bounded& t) {
    truth.others_known = truth.others_known && known_to(t, 0x1p-60);
    truth.other_roots[truth.other_count++] = {t.high, t.low, 0, t_exponent};
  };
  for (int j = 0; j < outline.count; ++j)
    if (outline.listed[j].standing != Standing::acceptable) add(values[outline.listed[j].place()]);
  // Of an open shape the second root is not listed where the first is the hit.
  const bool is_left_out =
      !outline.complete && outline.count == 1 && outline.listed[0].which == Which::smaller;
  if (is_left_out) add(values[1]);
}

/// The truth of an outline that intervals are sure of; false where the bounds leave t too wide.
bool fill(Truth& truth, const Case& question, const Outline& outline, const Values& values,
          double relative, int t_exponent) {
  for (int j = 0; j < outline.count; ++j) {
    const Outlined& root = outline.listed[j];
    if (root.standing != Standing::acceptable) continue;
    const Kind kind = root.kind;
    const Bounded& known = values[root.place()];
    Real t{known.high, known.low, 0, t_exponent};
    if (kind == Kind::start || kind == Kind::end)
      t = {kind == Kind::start ? question.ray.t_min : question.ray.t_max, 0, 0, t_exponent};
    else if (!known_to(known, relative))
      return false;
    truth.listed[truth.count++] = {kind, t, t, root.patch};
  }
  if (truth.count > 0) fill_others(truth, outline, values, t_exponent);
  return true;
}

/// Some of the cases of a block: the i-th by bit i.
using Some = std::uint64_t;

constexpr Some one(std::size_t i) { return Some{1} << i; }

/// Calls visit(i) for each of them, in order.
template <class Visit>
void each(Some some, const Visit& visit) {
  for (; some != 0; some &= some - 1) visit(static_cast<std::size_t>(std::countr_zero(some)));
}

Some that_fit_lanes(std::span<const Case> cases, int bits) {
  Some some = 0;
  if (bits <= most_bits_in_lanes)
    for (std::size_t i = 0; i < cases.size(); ++i)
      if (fits_lanes(cases[i])) some |= one(i);
  return some;
}

/// Puts some cases that fit to lanes, one shape after another.
InLanes put_to_lanes(std::span<const Case> cases, Some left, std::span<Truth> truths, int bits,
                     Words words) {
  InLanes found = {0, 0};
  while (left != 0) {
    const std::size_t shape = cases[std::countr_zero(left)].shape.index();
    std::array<const Case*, block> asked;
    std::array<Truth*, block> told;
    std::array<std::uint8_t, block> place;
    std::size_t count = 0;
    each(left, [&](std::size_t i) {
      if (cases[i].shape.index() != shape) return;
      asked[count] = &cases[i], told[count] = &truths[i];
      place[count++] = static_cast<std::uint8_t>(i);
      left ^= one(i);
    });
    const InLanes part =
        settle_in_lanes({asked.data(), count}, {told.data(), count}, bits, words, widest_lanes());
    each(part.settled, [&](std::size_t k) { found.settled |= one(place[k]); });
    each(part.doubtful, [&](std::size_t k) { found.doubtful |= one(place[k]); });
  }
  return found;
}

/// What lanes leave: by intervals, where those do not tell by wider lanes, and at last exactly.
void settle_rest(std::span<const Case> cases, Some rest, Some fitting, std::span<Truth> truths,
                 int bits) {
  Block in;
  each(rest, [&](std::size_t i) {
    const bool moderate = is_moderate(cases[i]);
    truths[i].clear();
    truths[i].invalid = invalid(cases[i], moderate);
    if (truths[i].invalid == Invalid::no && !in.ask(cases[i], i, moderate))
      truths[i] = exact_truth(cases[i], bits);
  });
  if (in.count == 0) return;
  std::array<Outline, block> outlines;
  std::array<Stage, block> stages;
  std::array<Values, block> values;
  const std::span asked = in.cases();
  outline_by_intervals(asked, outlines);
  Some unsure = 0;
  for (std::size_t i = 0; i < in.count; ++i)
    if (outlines[i].unsure) unsure |= one(in.place[i]) & fitting;
  const Some settled = put_to_lanes(cases, unsure, truths, bits, Words::three).settled;
  const auto is_settled = [&](std::size_t i) { return (settled >> in.place[i] & 1U) != 0; };
  for (std::size_t i = 0; i < in.count; ++i) {
    stages[i] = outlines[i].unsure ? Stage::exact : Stage::interval;
    if (outlines[i].unsure && !is_settled(i)) outlines[i] = outline_exactly(*asked[i]);
  }
  values_by_bounds(asked, outlines, values);
  const double relative = std::ldexp(1.0, -bits);
  for (std::size_t i = 0; i < in.count; ++i) {
    if (is_settled(i)) continue;
    Truth& truth = truths[in.place[i]];
    if (outlines[i].within ||
        !fill(truth, *asked[i], outlines[i], values[i], relative, in.t_exponent[i]))
      truth = exact_truth(cases[in.place[i]], bits);
    truth.stage = stages[i];
  }
}

void settle_block(std::span<const Case> cases, std::span<Truth> truths, int bits) {
  const Some all = ~Some{0} >> (block - cases.size()), fitting = that_fit_lanes(cases, bits);
  const InLanes found = put_to_lanes(cases, fitting, truths, bits, Words::two);
  Some settled = found.settled;
  // What is no tie, but not known well enough.
  const Some close = fitting & ~settled & ~found.doubtful;
  settled |= put_to_lanes(cases, close, truths, bits, Words::three).settled;
  // What three words do not know either is no question for them a second time.
  if (settled != all) settle_rest(cases, all & ~settled, fitting & found.doubtful, truths, bits);
}

/// The exact t of a crossing: of the roots of its kind, the one nearest to the t it holds.
Radical found_again(const Case& question, const Crossing& crossing, bool last) {
  const ExactRoots found = exact_roots(question, false);
  const ExactRoot* best = nullptr;
  Real gap;
  for (const ExactRoot& root : std::span(found.listed.data(), found.count)) {
    if (root.outlined.kind != crossing.kind) continue;
    // A ray lies in one patch at most, and that stretch may have no end.
    if (crossing.kind == Kind::within) return last ? root.t_last : root.t;
    Real apart = difference(value(root.t, 150), crossing.t);
    if (sign(apart) < 0) apart = difference({}, apart);
    if (best == nullptr || compare(apart, gap) < 0) best = &root, gap = apart;
  }
  return last ? best->t_last : best->t;
}

/// t rounded to nearest in N: at once where every number within 2^-60 |t| rounds alike.
template <class N>
N rounded_t(const Case& question, const Crossing& crossing, const Real& t, bool last) {
  if (is_infinite(t)) return static_cast<N>(t.high);
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

std::string_view name(Stage stage) {
  constexpr std::array<std::string_view, stage_count> names = {"lanes", "wide_lanes", "interval",
                                                               "exact"};
  return names[static_cast<std::size_t>(stage)];
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
  if (checks_every_decision())
    for (std::size_t i = 0; i < cases.size(); ++i) confirm(cases[i], truths[i], bits);
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
