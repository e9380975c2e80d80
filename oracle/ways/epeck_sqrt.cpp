#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>

#include <mutex>

#include "oracle/ways/by_signs.hpp"

namespace rayaudit::oracle {
namespace {

using Algebraic = CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt::FT;

}  // namespace

template <>
struct Signs<Algebraic> {
  bool unsure = false;

  int operator()(const Algebraic& x) const { return CGAL::sign(x); }
};

/// A number with roots needs no algebra for the sign of g at t = m / 2A: it holds m.
template <>
struct QuadraticRoot<Algebraic> {
  QuadraticRoot(const Polynomial<Algebraic, 2>& f, int sign_a, Which which, Signs<Algebraic>& sign)
      : m_(-f.c[1]), twice_a_(twice(f.c[2])), sign_a_(sign_a), which_(which), sign_(sign) {
    if (which == Which::twofold) return;
    // Where rounding makes it negative, CORE writes a warning into a file in the user's folder, and
    // ends the program if it cannot: so the root is taken of its exact value.
    const Algebraic d = squared(f.c[1]) - twice(twice(Algebraic(f.c[2] * f.c[0])));
    const Algebraic root =
        CGAL::sqrt(Algebraic(d.approx(CORE::CORE_posInfty, CORE::CORE_posInfty)));
    m_ = (which == Which::smaller) == (sign_a > 0) ? m_ - root : m_ + root;
  }

  Which which() const { return which_; }
  int at(const Polynomial<Algebraic, 1>& g) const {
    return sign_(twice_a_ * g.c[0] + m_ * g.c[1]) * sign_a_;
  }
  int of_t() const { return sign_(m_) * sign_a_; }

 private:
  Algebraic m_, twice_a_;
  int sign_a_;
  Which which_;
  Signs<Algebraic>& sign_;
};

void answer_by_epeck_sqrt(std::span<const Case> cases, std::span<Answer> answers) {
  static std::mutex alone;
  const std::scoped_lock lock(alone);
  for (std::size_t i = 0; i < cases.size(); ++i) {
    // CORE's filter in double takes what underflows for a sure 0.
    CORE::setFpFilterFlag(is_moderate(cases[i]));
    answer_by_signs<Algebraic>(cases.subspan(i, 1), answers.subspan(i, 1), Nearest{});
  }
  CORE::setFpFilterFlag(true);
}

}  // namespace rayaudit::oracle
