#include "audit/bound.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "audit/audit.hpp"
#include "geometry/error.hpp"
#include "geometry/glob.hpp"
#include "geometry/quotation.hpp"
#include "geometry/unknown_name.hpp"

namespace rayaudit {
namespace {

template <Verdict verdict>
Quantity count_of() {
  return {name(verdict), true,
          [](const Tally& tally) { return static_cast<double>(tally.of(verdict)); },
          [](const Tally& tally) { return tally.worst(verdict); }};
}

/// The wrong case with the largest margin; where only invalid ones are mishandled, one of those.
const Worst* worst_of_wrong(const Tally& tally) {
  const Worst* widest = tally.widest();
  return widest != nullptr ? widest : tally.worst(Verdict::invalid_mishandled);
}

/// A quantity that is the severity of a case that the tally keeps.
template <auto worst_of>
double severity(const Tally& tally) {
  const Worst* worst = worst_of(tally);
  return worst == nullptr ? 0 : worst->severity;
}

const Worst* worst_ulps(const Tally& tally) {
  return tally.worst_ulps ? &*tally.worst_ulps : nullptr;
}

const Worst* worst_forced(const Tally& tally) {
  return tally.worst_forced ? &*tally.worst_forced : nullptr;
}

const Worst* worst_own(const Tally& tally) { return tally.worst_own ? &*tally.worst_own : nullptr; }

const Worst* widest(const Tally& tally) { return tally.widest(); }

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream text{std::string(line.substr(0, line.find('#')))};
  return {std::istream_iterator<std::string>(text), {}};
}

template <class List>
void require_known(std::string_view what, const std::string& pattern, const List& known) {
  if (is_glob(pattern)) return;
  if (std::find(known.begin(), known.end(), pattern) == known.end())
    throw Error(unknown_name(what, pattern, known));
}

void require_known_names(const Bound& bound, std::span<const std::string_view> subjects) {
  std::vector<std::string_view> ids;
  for (const Family& family : families()) ids.push_back(family.id);
  require_known("subject", bound.subject, subjects);
  require_known("shape", bound.shape, shape_names);
  require_known("family", bound.family, ids);
}

const Quantity& quantity_named(const std::string& name) {
  std::vector<std::string_view> known;
  for (const Quantity& quantity : quantities()) {
    if (quantity.name == name) return quantity;
    known.push_back(quantity.name);
  }
  throw Error(unknown_name("limit", name, known));
}

double read_most(const Quantity& quantity, const std::string& text) {
  double most = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), most);
  const bool is_number =
      fault == std::errc() && end == text.data() + text.size() && most >= 0 && std::isfinite(most);
  if (!is_number || (quantity.is_count && most != std::floor(most)))
    throw Error(std::string(quantity.name) + " must be a " + (quantity.is_count ? "whole " : "") +
                "number, 0 or more, got " + quotation(text));
  return most;
}

/// Reads what stands between the names and the last word, as `LIMIT VALUE LIMIT VALUE`.
std::vector<Limit> read_limits(std::span<const std::string> words) {
  if (words.empty()) throw Error("expected a limit after the family, as in `max_ulp 4`");
  std::vector<Limit> limits;
  for (; !words.empty(); words = words.subspan(2)) {
    const Quantity& quantity = quantity_named(words[0]);
    if (words.size() == 1)
      throw Error("limit " + quotation(words[0]) + " needs its value, as in `" + words[0] +
                  (quantity.is_count ? " 0`" : " 4`"));
    if (std::any_of(limits.begin(), limits.end(),
                    [&](const Limit& limit) { return limit.quantity == &quantity; }))
      throw Error("limit " + quotation(words[0]) + " is there twice");
    limits.push_back({&quantity, read_most(quantity, words[1])});
  }
  return limits;
}

Bound read_bound(const std::vector<std::string>& words,
                 std::span<const std::string_view> subjects) {
  if (words.size() < 4)
    throw Error(
        "expected SUBJECT SHAPE FAMILY, then limits with their values, then `proved` or "
        "`observed`");
  if (words.back() != "proved" && words.back() != "observed")
    throw Error("expected `proved` or `observed` at the end, got " + quotation(words.back()));
  Bound bound = {words[0], words[1], words[2], {}, words.back() == "proved"};
  require_known_names(bound, subjects);
  bound.limits = read_limits(std::span(words).subspan(3, words.size() - 4));
  return bound;
}

/// Were there cases of the kind that a verdict is given to: invalid ones, or others?
bool could_occur(const Quantity& verdict, const Tally& tally) {
  const std::uint64_t invalid =
      tally.of(Verdict::invalid_handled) + tally.of(Verdict::invalid_mishandled);
  return verdict.name == name(Verdict::invalid_mishandled) ? invalid > 0 : invalid < tally.cases;
}

/// Of fewer cases than these, how bad the worst is, or which verdict there is none of, is chance.
constexpr std::uint64_t few = 16;

/// Do many errors come near the largest, so that more cases would hardly show a much larger one?
bool ends_within(double room, const Histogram& errors) {
  if (errors.count() <= few) return false;
  const double others = static_cast<double>(few) / static_cast<double>(errors.count());
  return errors.largest() <= room * errors.quantile(1 - others);
}

/// Would a promise be kept in more cases too, and say more than that t is not wrong? No forced
/// error of such a t is larger either: it is counted in units that are no smaller than u |t|.
bool would_last(const Limit& promise, const Audit& audit, double room) {
  const auto& [quantity, most] = promise;
  const Tally& tally = audit.tally;
  if (quantity->is_count) return tally.wrong() == 0 || tally.wrong() >= few;
  if (quantity->worst == widest) return true;
  return most < std::ldexp(wrong_t_limit, audit.subject->format.precision) &&
         ends_within(room, quantity->worst == worst_ulps     ? tally.ulps
                           : quantity->worst == worst_forced ? tally.forced
                                                             : tally.own);
}

/// What is granted of a quantity of which so much was seen. Below 1 u, rounding the case excuses
/// any wrong answer.
double granted(const Quantity& quantity, double seen, double room) {
  const double least = room > 1 && quantity.worst == widest ? 1 : 0;
  return std::max(room * seen, least);
}

/// The least that can be promised of a quantity, if anything.
std::optional<Limit> least_promise(const Quantity& quantity, const Audit& audit, double room) {
  const Tally& tally = audit.tally;
  const double seen = quantity.seen(tally);
  if (quantity.is_count) {
    if (seen > 0 || !could_occur(quantity, tally)) return std::nullopt;
  } else if (quantity.worst(tally) == nullptr || !std::isfinite(room * seen)) {
    return std::nullopt;
  }
  const Limit promise = {&quantity, rounded_up(granted(quantity, seen, room))};
  if (room > 1 && !would_last(promise, audit, room)) return std::nullopt;
  return promise;
}

const Quantity& unasked() {
  static const Quantity& found = quantity_named("unasked");
  return found;
}

Bound observed(const Audit& audit, double room) {
  Bound bound = {audit.subject->name,
                 std::string(shape_names[audit.shape]),
                 std::string(audit.family->id),
                 {}};
  const bool is_never_wrong = audit.tally.wrong() == 0;
  for (const Quantity& quantity : quantities()) {
    const bool is_all_wrong = &quantity == quantities().data();
    if (quantity.is_count && is_never_wrong && !is_all_wrong) continue;  // said by `wrong 0`
    // Who answers here neither crashes nor hangs.
    const bool is_of_elsewhere = quantity.name == name(Verdict::crashed) ||
                                 quantity.name == name(Verdict::timed_out) ||
                                 &quantity == &unasked();
    if (is_of_elsewhere && !audit.subject->is_elsewhere) continue;
    if (const auto promise = least_promise(quantity, audit, room)) bound.limits.push_back(*promise);
  }
  // Unlike what is wrong, what could not be asked must be granted to be kept.
  if (const auto count = static_cast<double>(audit.tally.unasked); count > 0)
    bound.limits.push_back({&unasked(), std::ceil(rounded_up(room * count))});
  return bound;
}

/// Adds what an audit breaks of a bound.
void hold(const Bound& bound, const Audit& audit, std::vector<Broken>& all) {
  if (!bound.is_about(audit)) return;
  const auto keep = [&](const Limit& limit) {
    if (const double seen = limit.quantity->seen(audit.tally); seen > limit.most)
      all.push_back({&bound, &audit, limit, seen, limit.quantity->worst(audit.tally)});
  };
  for (const Limit& limit : bound.limits) keep(limit);
  // What was not asked keeps no promise, unless the row grants it.
  if (std::none_of(bound.limits.begin(), bound.limits.end(),
                   [](const Limit& limit) { return limit.quantity == &unasked(); }))
    keep({&unasked(), 0});
}

}  // namespace

std::span<const Quantity> quantities() {
  static const std::array all = {
      Quantity{"wrong", true, [](const Tally& tally) { return static_cast<double>(tally.wrong()); },
               worst_of_wrong},
      count_of<Verdict::false_hit>(),
      count_of<Verdict::false_miss>(),
      count_of<Verdict::wrong_root>(),
      count_of<Verdict::wrong_t>(),
      count_of<Verdict::not_finite>(),
      count_of<Verdict::crashed>(),
      count_of<Verdict::timed_out>(),
      count_of<Verdict::invalid_mishandled>(),
      Quantity{"unasked", true,
               [](const Tally& tally) { return static_cast<double>(tally.unasked); },
               worst_of_wrong},
      Quantity{"max_ulp", false, severity<worst_ulps>, worst_ulps},
      Quantity{"max_forced", false, severity<worst_forced>, worst_forced},
      Quantity{"max_own", false, severity<worst_own>, worst_own},
      Quantity{"wrong_margin", false, severity<widest>, widest}};
  return all;
}

bool Bound::is_about(const Audit& audit) const {
  return matches(subject, audit.subject->name) && matches(shape, shape_names[audit.shape]) &&
         matches(family, audit.family->id);
}

std::span<const std::string_view> subject_names() {
  static const std::vector<std::string_view> names = [] {
    std::vector<std::string_view> made;
    for (const Subject& subject : all_subjects()) made.push_back(subject.name);
    return made;
  }();
  return names;
}

std::vector<Bound> read_bounds(std::string_view text, const std::string& file,
                               std::span<const std::string_view> subjects) {
  std::vector<Bound> bounds;
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::vector<std::string> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (words.empty()) continue;
    const std::string place = file + ":" + std::to_string(number);
    try {
      bounds.push_back(read_bound(words, subjects));
    } catch (const Error& fault) {
      throw Error(place + ": " + fault.what());
    }
    bounds.back().place = place;
  }
  return bounds;
}

bool is_named(const Audit& audit, const std::vector<Bound>& bounds) {
  return std::any_of(bounds.begin(), bounds.end(),
                     [&](const Bound& bound) { return bound.is_about(audit); });
}

std::optional<double> most_ulps(const Audit& audit, const std::vector<Bound>& bounds) {
  std::optional<double> least;
  for (const Bound& bound : bounds) {
    if (!bound.is_about(audit)) continue;
    for (const auto& [quantity, most] : bound.limits)
      if (quantity->worst == worst_ulps) least = std::min(least.value_or(most), most);
  }
  return least;
}

std::vector<Broken> broken(const std::vector<Bound>& bounds, const Audit& audit) {
  std::vector<Broken> all;
  for (const Bound& bound : bounds) hold(bound, audit, all);
  return all;
}

std::vector<Broken> broken(const std::vector<Bound>& bounds, const std::vector<Audit>& audits) {
  std::vector<Broken> all;
  for (const Bound& bound : bounds)
    for (const Audit& audit : audits) hold(bound, audit, all);
  return all;
}

std::vector<Bound> observed(const std::vector<Audit>& audits, double room) {
  std::vector<Bound> bounds;
  for (const Audit& audit : audits)
    if (Bound bound = observed(audit, room); !bound.limits.empty())
      bounds.push_back(std::move(bound));
  return bounds;
}

double rounded_up(double x) {
  if (x == 0 || !std::isfinite(x)) return x;
  std::array<char, 16> text = {};  // as 1.2e+07
  std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::scientific, 1);
  const double nearest = std::strtod(text.data(), nullptr);
  if (nearest >= x) return nearest;
  const int digits = 10 * (text[0] - '0') + (text[2] - '0');
  const int exponent = std::atoi(text.data() + 4);
  const std::string above = std::to_string(digits + 1) + "e" + std::to_string(exponent - 1);
  return std::strtod(above.c_str(), nullptr);
}

}  // namespace rayaudit
