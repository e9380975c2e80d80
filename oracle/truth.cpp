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

/// Written member by member: a copy of what was just written waits for it.
void set(Real& t, double high, double middle, int exponent) {
  t.high = high, t.middle = middle, t.low = 0, t.exponent = exponent;
}
void add_crossing(Truth& truth, Kind kind, std::uint8_t patch, double high, double middle,
                  int exponent) {
  Crossing& crossing = truth.listed[truth.count++];
  crossing.kind = kind, crossing.patch = patch;
  set(crossing.t, high, middle, exponent);
  set(crossing.t_last, high, middle, exponent);
}

/// The roots that are no crossings, where the bounds know them well.
void fill_others(Truth& truth, const Outline& outline, const Values& values, int t_exponent) {
  truth.others_known = true;
  const auto add = [&](const Bounded& t) {
    truth.others_known = truth.others_known && known_to(t, 0x1p-60);
    set(truth.other_roots[truth.other_count++], t.high, t.low, t_exponent);
  };
  for (int j = 0; j < outline.count; ++j)
    if (outline.listed[j].standing != Standing::acceptable) add(values[outline.listed[j].place()]);
  // Of an open shape the second root is not listed where the first is the hit.
  const bool is_left_out =
      !outline.complete && outline.count == 1 && outline.listed[0].which == Which::smaller;
  if (is_left_out) add(values[1]);
}

/// The truth of an outline that is sure; false where the bounds leave t too wide.
bool fill(Truth& truth, const Case& question, const Outline& outline, const Values& values,
          double relative, int t_exponent) {
  for (int j = 0; j < outline.count; ++j) {
    const Outlined& root = outline.listed[j];
    if (root.standing != Standing::acceptable) continue;
    const Bounded& known = values[root.place()];
    if (root.kind == Kind::start)
      add_crossing(truth, root.kind, root.patch, question.ray.t_min, 0, t_exponent);
    else if (root.kind == Kind::end)
      add_crossing(truth, root.kind, root.patch, question.ray.t_max, 0, t_exponent);
    else if (known_to(known, relative))
      add_crossing(truth, root.kind, root.patch, known.high, known.low, t_exponent);
    else
      return false;
  }
  if (truth.count > 0) fill_others(truth, outline, values, t_exponent);
  return true;
}

/// The same of what integers find.
bool fill(Truth& truth, const Case& question, const InIntegers& found, double relative,
          int t_exponent) {
  const auto& [outline, unused, stretch, values] = found;
  if (!outline.within) return fill(truth, question, outline, values, relative, t_exponent);
  bool known = true;
  const auto real = [&](const StretchEnd& end, double of_range, const Bounded& t) -> Real {
    if (end.side < 0) return {of_range, 0, 0, std::isinf(of_range) ? 0 : t_exponent};
    known = known && known_to(t, relative);
    return {t.high, t.low, 0, t_exponent};
  };
  if (stretch.empty) return true;
  const Real first = real(stretch.first, question.ray.t_min, values[0]);
  const Real last = real(stretch.last, question.ray.t_max, values[1]);
  truth.listed[truth.count++] = {Kind::within, first, last, outline.patch};
  return known;
}

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

/// Notes who decided; where t is not filled in as well as is asked, exact numbers do it.
void conclude(Truth& truth, const Case& question, bool filled, int bits, Stage stage) {
  if (!filled) truth = exact_truth(question, bits);
  truth.stage = stage;
}

/// Settles one case by integers where those take no more bits than allowed.
bool settle_by_integers(const Case& asked, const Case& given, int t_exponent, int most_bits,
                        InIntegers& found, Truth& truth, int bits) {
  if (!settle_in_integers(asked, most_bits, false, found)) return false;
  const bool filled = fill(truth, asked, found, power_of_two(-bits), t_exponent);
  conclude(truth, given, filled, bits, Stage::integers);
  return true;
}

/// Those of some cases that are short enough to be settled by integers sooner than by anything.
Some settle_short(std::span<const Case> cases, Some some, std::span<Truth> truths, int bits) {
  constexpr int most_bits = widths_of_integers.front();
  Some settled = 0;
  InIntegers found;
  each(some, [&](std::size_t i) {
    if (invalid(cases[i], true) != Invalid::no) return;  // what is not finite is not short
    truths[i].clear();
    if (settle_by_integers(cases[i], cases[i], 0, most_bits, found, truths[i], bits))
      settled |= one(i);
  });
  return settled;
}

/// Those of a block that integers of any width settle.
Some settle_by_integers(std::span<const Case> cases, const Block& in, Some some,
                        std::span<Truth> truths, int bits) {
  Some settled = 0;
  InIntegers found;
  for (std::size_t i = 0; i < in.count; ++i) {
    const std::size_t at = in.place[i];
    if ((some & one(at)) != 0 &&
        settle_by_integers(*in.asked[i], cases[at], in.t_exponent[i], widths_of_integers.back(),
                           found, truths[at], bits))
      settled |= one(at);
  }
  return settled;
}

/// By intervals; where those do not tell by integers, if they have not refused, and at last
/// exactly.
void settle_by_intervals(std::span<const Case> cases, const Block& in, Some refused,
                         std::span<Truth> truths, int bits) {
  std::array<Outline, block> outlines;
  std::array<Values, block> values;
  const std::span asked = in.cases();
  outline_by_intervals(asked, outlines);
  Some unsure = 0;
  for (std::size_t i = 0; i < in.count; ++i)
    if (outlines[i].unsure) unsure |= one(in.place[i]);
  const Some settled = settle_by_integers(cases, in, unsure & ~refused, truths, bits);
  for (std::size_t i = 0; i < in.count; ++i)
    if ((unsure & ~settled & one(in.place[i])) != 0) outlines[i] = outline_exactly(*asked[i]);
  values_by_bounds(asked, outlines, values);
  const double relative = power_of_two(-bits);
  for (std::size_t i = 0; i < in.count; ++i) {
    const std::size_t at = in.place[i];
    if ((settled & one(at)) != 0) continue;
    const bool filled = !outlines[i].within && fill(truths[at], *asked[i], outlines[i], values[i],
                                                    relative, in.t_exponent[i]);
    conclude(truths[at], cases[at], filled, bits,
             (unsure & one(at)) != 0 ? Stage::exact : Stage::interval);
  }
}

/// What lanes leave. What may be a tie is one, most often, and intervals would not tell.
void settle_rest(std::span<const Case> cases, Some rest, Some doubtful, std::span<Truth> truths,
                 int bits) {
  Block in;
  each(rest, [&](std::size_t i) {
    const bool moderate = is_moderate(cases[i]);
    truths[i].clear();
    truths[i].invalid = invalid(cases[i], moderate);
    if (truths[i].invalid == Invalid::no && !in.ask(cases[i], i, moderate))
      truths[i] = exact_truth(cases[i], bits);
  });
  in.leave_out(settle_by_integers(cases, in, doubtful, truths, bits));
  if (in.count != 0) settle_by_intervals(cases, in, doubtful, truths, bits);
}

void settle_block(std::span<const Case> cases, std::span<Truth> truths, int bits) {
  const Some all = ~Some{0} >> (block - cases.size()), fitting = that_fit_lanes(cases, bits);
  const InLanes narrow = put_to_lanes(cases, fitting, truths, bits, Words::two);
  Some settled = narrow.settled;
  settled |= settle_short(cases, fitting & narrow.doubtful & ~settled, truths, bits);
  const InLanes wide = put_to_lanes(cases, fitting & ~settled, truths, bits, Words::three);
  settled |= wide.settled;
  if (settled != all) settle_rest(cases, all & ~settled, fitting & wide.doubtful, truths, bits);
}

/// Every root, where integers of a fixed width know it well enough.
std::optional<Roots> roots_by_integers(const Case& question, int bits) {
  const Scaled scale = is_moderate(question) ? Scaled{question} : scaled(question);
  InIntegers found;
  if (!settle_in_integers(scale.question, widths_of_integers.back(), true, found)) return {};
  Roots listed{.constant = found.constant};
  for (const Outlined& root : std::span(found.outline.listed.data(), found.outline.count)) {
    const Bounded& t = found.values[root.place()];
    if (!known_to(t, power_of_two(-bits))) return {};
    listed.listed[listed.count++] = {
        {t.high, t.low, 0, scale.t_exponent()}, root.standing, root.kind};
  }
  return listed;
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
                                                               "integers", "exact"};
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
  if (const auto found = roots_by_integers(question, bits)) return *found;
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
