#include "audit/drawn.hpp"

#include <algorithm>
#include <array>

#include "geometry/digest.hpp"

namespace rayaudit {
namespace {

/// Cases depend on seed, family, shape, format, difficulty and convention alone, and on the text
/// that draws them: the first few show a change of any of these.
constexpr std::size_t looked_at = 16;

}  // namespace

std::optional<std::uint64_t> drawn(const Plan& plan, const Audit& audit) {
  if (audit.family->draw[audit.shape] == nullptr) return {};
  const Format format = plan.drawn_in ? *plan.drawn_in : audit.subject->drawn_in();
  std::array<Case, looked_at> cases;
  const auto count = std::min<std::uint64_t>(looked_at, plan.cases);
  draw(*audit.family, audit.shape, format, plan.difficulty, plan.seed, 0, {cases.data(), count});
  Digest digest;
  for (std::size_t i = 0; i < count; ++i) {
    const Case question = posed(cases[i], convention_of(plan, *audit.subject), format);
    each_number(question, [&](double number) { digest.add(number); });
    digest.add(question.ray.t_min);
    digest.add(question.ray.t_max);
    if (question.extent != Extent::bounded) digest.add(static_cast<double>(question.extent));
  }
  return digest.value();
}

}  // namespace rayaudit
