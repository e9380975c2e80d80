#include <CGAL/Exact_predicates_exact_constructions_kernel.h>

#include "oracle/ways/by_signs.hpp"

namespace rayaudit::oracle {
namespace {

using Lazy = CGAL::Exact_predicates_exact_constructions_kernel::FT;

}  // namespace

/// The lazy number's own square is a shorter way to a tighter interval.
template <>
inline Lazy squared(const Lazy& x) {
  return CGAL::square(x);
}

template <>
struct Signs<Lazy> {
  bool unsure = false;

  int operator()(const Lazy& x) const { return CGAL::sign(x); }
};

void answer_by_epeck(std::span<const Case> cases, std::span<Answer> answers) {
  answer_by_signs<Lazy>(cases, answers, Near{});
}

}  // namespace rayaudit::oracle
