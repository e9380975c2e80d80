#include "reports/steps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reports/figures.hpp"

namespace rayaudit {
namespace {

using figures::grouped;
using figures::magnitude;

/// The wrong verdict that a step does most about.
Verdict most_mended(const Step& step) {
  constexpr std::array wrong = {Verdict::false_hit,  Verdict::false_miss,
                                Verdict::wrong_root, Verdict::wrong_t,
                                Verdict::not_finite, Verdict::invalid_mishandled};
  const auto less = [&](Verdict verdict) {
    return step.from->accuracy.per_million(verdict) - step.to->accuracy.per_million(verdict);
  };
  return *std::ranges::max_element(wrong, {}, less);
}

std::string plural(Verdict verdict) {
  switch (verdict) {
    case Verdict::false_hit:
      return "false hits";
    case Verdict::false_miss:
      return "false misses";
    case Verdict::wrong_root:
      return "wrong roots";
    case Verdict::wrong_t:
      return "wrong t";
    case Verdict::invalid_mishandled:
      return "invalid cases mishandled";
    default:
      return "t that are not finite";
  }
}

}  // namespace

std::string whole(double per_million) {
  if (per_million > 0 && per_million < 0.5) return "< 1";
  return grouped(static_cast<std::uint64_t>(std::llround(per_million)));
}

std::string per_million(const Accuracy& accuracy) {
  if (accuracy.wrong == 0) {
    const double most = 3e6 / static_cast<double>(accuracy.cases);
    return "0, < " + (most < 1 ? magnitude(most) : whole(most));
  }
  return whole(1e6 * accuracy.share());
}

std::string told(const Step& step) {
  const auto& [from, to, times] = step;
  std::string text =
      fmt::format("from {} to {}: {:.3g} times the time ({:.3g} to {:.3g})", from->subject->name,
                  to->subject->name, times.median, times.low, times.high);
  const double before = 1e6 * from->accuracy.share(), after = 1e6 * to->accuracy.share();
  if (before != after) {
    text += fmt::format(", wrong {} to {} per million", whole(before), whole(after));
    const Verdict mended = most_mended(step);
    text += fmt::format(" ({} {} to {})", plural(mended), whole(from->accuracy.per_million(mended)),
                        whole(to->accuracy.per_million(mended)));
  } else if (from->accuracy.bare > 0) {
    text += ", and t is told";
  } else {
    text += fmt::format(", worst error {} to {} units of float", magnitude(from->accuracy.error),
                        magnitude(to->accuracy.error));
  }
  return text;
}

}  // namespace rayaudit
