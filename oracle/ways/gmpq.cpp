#include <CGAL/Gmpq.h>

#include "oracle/ways/by_signs.hpp"

namespace rayaudit::oracle {

template <>
struct Signs<CGAL::Gmpq> {
  bool unsure = false;

  int operator()(const CGAL::Gmpq& x) const { return x.sign(); }
};

void answer_by_gmpq(std::span<const Case> cases, std::span<Answer> answers) {
  answer_by_signs<CGAL::Gmpq>(cases, answers, Nearest{});
}

}  // namespace rayaudit::oracle
