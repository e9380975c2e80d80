#include "oracle/interval.hpp"

#include "oracle/fused.hpp"
#include "oracle/stages.hpp"

namespace rayaudit::oracle {
namespace {

template <template <class> class S>
Outline outline(const Ray<double>& ray, const S<double>& shape, Extent extent) {
  Signs<Interval> sign;
  Outline found =
      settle<S<double>>(along_ray<Interval>(ray, shape), Range<Interval>(ray), sign, extent, false);
  // Where the stretch within the surface begins and ends is left to exact numbers.
  found.unsure |= found.within;
  return found;
}

/// Alone under upward rounding: nothing in here but intervals, and what leaves it leaves through
/// memory. Compilers move plain arithmetic across the protector's end where they can see it.
[[gnu::noinline]] void outline_rounding_upward(std::span<const Case* const> cases,
                                               std::span<Outline> outlines) {
  const Interval::Protector upward;
  for (std::size_t i = 0; i < cases.size(); ++i)
    with_shape(cases[i]->shape, [&](const auto& shape) {
      outlines[i] = outline(cases[i]->ray, shape, cases[i]->extent);
    });
}

}  // namespace

void outline_by_intervals(std::span<const Case* const> cases, std::span<Outline> outlines) {
  outline_rounding_upward(cases, outlines);
}

}  // namespace rayaudit::oracle
