#include "reports/touches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <tuple>

#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using Counts = decltype(Tally::touches);

std::uint64_t offered(const TouchCount& count) { return count.taken + count.passed; }

/// The touches of one subject on one shape, over all families.
struct Seen {
  std::size_t shape;
  std::string_view subject;
  Counts counts = {};

  std::string_view routine() const { return subject.substr(0, subject.rfind('/')); }
};

std::vector<Seen> seen(const Run& run) {
  std::vector<Seen> all;
  for (const std::size_t shape : run.plan.shapes)
    for (const Audit& audit : run.audits) {
      if (audit.shape != shape) continue;
      if (all.empty() || all.back().shape != shape || all.back().subject != audit.subject->name)
        all.push_back({shape, audit.subject->name});
      for (std::size_t kind = 0; kind < all.back().counts.size(); ++kind) {
        all.back().counts[kind].taken += audit.tally.touches[kind].taken;
        all.back().counts[kind].passed += audit.tally.touches[kind].passed;
      }
    }
  return all;
}

/// `hit`, `miss`, or how many per cent were taken for a hit: the least and the most of the
/// subjects.
std::string manner(std::span<const Seen> subjects, std::size_t kind) {
  std::vector<TouchCount> counts;
  for (const Seen& each : subjects)
    if (offered(each.counts[kind]) > 0) counts.push_back(each.counts[kind]);
  if (counts.empty()) return "";
  const auto [least, most] = std::minmax_element(
      counts.begin(), counts.end(), [](const TouchCount& a, const TouchCount& b) {
        return a.taken * offered(b) < b.taken * offered(a);
      });
  if (least->passed == 0) return "hit";
  if (most->taken == 0) return "miss";
  const auto per_cent = [](const TouchCount& count) {
    return count.taken == 0 ? "0" : figures::percent(count.taken, offered(count));
  };
  const std::string low = per_cent(*least), high = per_cent(*most);
  return (low == high ? low : low + '-' + high) + '%';
}

}  // namespace

std::string write_touches(const Run& run, const Ink& ink) {
  const std::vector<Seen> all = seen(run);
  std::vector<std::size_t> kinds;
  for (std::size_t kind = 1; kind < std::tuple_size_v<Counts>; ++kind)
    if (std::any_of(all.begin(), all.end(),
                    [&](const Seen& each) { return offered(each.counts[kind]) > 0; }))
      kinds.push_back(kind);
  if (kinds.empty()) return "";
  std::size_t shape_width = 9;
  for (const Seen& each : all)
    shape_width = std::max(shape_width, shape_names[each.shape].size() + 1);
  std::string text = ink.heading("Touches") +
                     ": a hit or a miss by convention, never counted as wrong; how many each "
                     "routine took for a hit\n(78.8-90.1%: the least and the most over its "
                     "numbers)\n" +
                     std::string(2 + shape_width + 17, ' ');
  for (const std::size_t kind : kinds)
    text += fmt::format("{:<14}", name(static_cast<oracle::Kind>(kind)));
  text.erase(text.find_last_not_of(' ') + 1);
  text += '\n';
  for (auto first = all.begin(); first != all.end();) {
    const auto last = std::find_if(first, all.end(), [&](const Seen& each) {
      return each.shape != first->shape || each.routine() != first->routine();
    });
    text +=
        fmt::format("  {:<{}}{:<17.16}", shape_names[first->shape], shape_width, first->routine());
    for (const std::size_t kind : kinds) text += fmt::format("{:<14}", manner({first, last}, kind));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
    first = last;
  }
  return text;
}

}  // namespace rayaudit
