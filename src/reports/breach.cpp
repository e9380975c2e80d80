#include "reports/breach.hpp"

#include <fmt/format.h>

#include "reports/figures.hpp"

namespace rayaudit {

std::optional<Breach> breach(const FailOn& fail_on, const Tally& tally) {
  using figures::grouped;
  for (std::size_t i = 0; i < verdict_count; ++i) {
    if (!fail_on.verdicts[i] || tally.verdicts[i] == 0) continue;
    const auto verdict = Verdict{static_cast<std::uint8_t>(i)};
    return Breach{name(verdict),
                  fmt::format("{} of {} cases {}", grouped(tally.verdicts[i]), grouped(tally.cases),
                              name(verdict)),
                  tally.worst(verdict)};
  }
  if (fail_on.most_ulps && tally.ulps.largest() > *fail_on.most_ulps)
    return Breach{"max_ulp",
                  fmt::format("a t is off by {} ulps, more than {}",
                              figures::magnitude(tally.ulps.largest()), *fail_on.most_ulps),
                  &*tally.worst_ulps};
  if (fail_on.asks_anything() && tally.unasked > 0) {
    const Worst* widest = tally.widest();
    return Breach{"unasked",
                  fmt::format("{} cases were not asked after {}", grouped(tally.unasked),
                              grouped(tally.cases)),
                  widest != nullptr ? widest : tally.worst(Verdict::invalid_mishandled)};
  }
  return std::nullopt;
}

}  // namespace rayaudit
