#include "oracle/replay/surd.hpp"

#include <CGAL/CORE/Expr.h>

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

using rayaudit::Real;
using rayaudit::replay::Surd;
using rayaudit::replay::Undefined;

namespace {

/// The same expression in both numbers, which share nothing.
struct Both {
  Surd surd;
  CORE::Expr expression;
};

Both both(double x) { return {Surd(x), CORE::Expr(x)}; }

/// Draws expressions of up to three roots, one within the other at times.
class Draws {
 public:
  explicit Draws(unsigned seed) : random_(seed) {}

  Both next(int depth) {
    if (depth == 0) return both(static_cast<double>(below(17)) / 4 - 2);
    const Both a = next(depth - 1), b = next(depth - 1);
    switch (below(6)) {
      case 0:
        return {a.surd - b.surd, a.expression - b.expression};
      case 1:
      case 2:
        return {a.surd * b.surd, a.expression * b.expression};
      case 3:
        if (b.surd.sign() != 0) return {a.surd / b.surd, a.expression / b.expression};
        return a;
      case 4:
        if (roots_ < 3 && a.surd.sign() > 0) {
          ++roots_;
          return {sqrt(a.surd), sqrt(a.expression)};
        }
        [[fallthrough]];
      default:
        return {a.surd + b.surd, a.expression + b.expression};
    }
  }
  void begin() {
    Surd::begin();
    roots_ = 0;
  }

 private:
  unsigned below(unsigned n) { return static_cast<unsigned>(random_()) % n; }

  std::mt19937 random_;
  int roots_ = 0;
};

}  // namespace

BOOST_AUTO_TEST_CASE(signs_and_order_are_those_of_an_independent_exact_number) {
  Draws draws(7);
  int with_roots = 0, zeros = 0;
  for (int i = 0; i < 3000; ++i) {
    draws.begin();
    const Both a = draws.next(4), b = draws.next(3);
    BOOST_REQUIRE_MESSAGE(a.surd.sign() == CORE::sign(a.expression), "expression " << i);
    BOOST_REQUIRE_MESSAGE((a.surd < b.surd) == (a.expression < b.expression), "expression " << i);
    BOOST_REQUIRE_MESSAGE((a.surd == b.surd) == (a.expression == b.expression), "expression " << i);
    zeros += a.surd.sign() == 0;
    with_roots += a.expression.doubleValue() != std::floor(a.expression.doubleValue());
  }
  BOOST_TEST(with_roots > 1000);
  BOOST_TEST(zeros > 100);
}

BOOST_AUTO_TEST_CASE(values_are_those_of_an_independent_exact_number) {
  Draws draws(8);
  for (int i = 0; i < 1000; ++i) {
    draws.begin();
    const Both a = draws.next(4);
    const Real value = a.surd.value();
    CORE::Expr off = a.expression - CORE::Expr(std::ldexp(value.high, value.exponent)) -
                     CORE::Expr(std::ldexp(value.middle, value.exponent)) -
                     CORE::Expr(std::ldexp(value.low, value.exponent));
    if (off < CORE::Expr(0)) off = -off;
    const CORE::Expr size = a.expression < CORE::Expr(0) ? -a.expression : a.expression;
    BOOST_REQUIRE_MESSAGE(off * CORE::Expr(0x1p150) <= size, "expression " << i);
  }
}

BOOST_AUTO_TEST_CASE(equal_roots_written_otherwise_are_equal) {
  Surd::begin();
  const Surd two = sqrt(Surd(2)), three = sqrt(Surd(3)),
             five = sqrt(Surd(5) + Surd(2) * two * three);
  BOOST_TEST((five == two + three));
  BOOST_TEST(((five - two - three).sign() == 0));
  BOOST_TEST((Surd(1) / (five - two) == Surd(1) / three));
  BOOST_TEST((sqrt(Surd(8)) == two + two));
  BOOST_TEST(((sqrt(Surd(4)) == Surd(2))));
}

BOOST_AUTO_TEST_CASE(what_has_no_value_is_told) {
  Surd::begin();
  const Surd two = sqrt(Surd(2));
  const auto words = [](const auto& operation) -> std::string {
    try {
      operation();
    } catch (const Undefined& undefined) {
      return std::string(undefined.words);
    }
    return "";
  };
  BOOST_TEST(words([&] { return Surd(1) / (two * two - Surd(2)); }) == "a division by 0");
  BOOST_TEST(words([&] { return sqrt(two - Surd(1.5)); }) == "the root of a negative number");
  BOOST_TEST(words([&] { return Surd(std::nan("")); }) == "NaN");
  BOOST_TEST(words([&] { return Surd(INFINITY) - Surd(INFINITY); }) == "infinity less infinity");
}

BOOST_AUTO_TEST_CASE(an_infinity_is_beyond_all) {
  Surd::begin();
  const Surd end(std::numeric_limits<double>::infinity()), two = sqrt(Surd(2));
  BOOST_TEST((two < end));
  BOOST_TEST((-end < two));
  BOOST_TEST((two * end == end));
  BOOST_TEST(((Surd(0) * end).sign() == 0));
  BOOST_TEST(((two / end).sign() == 0));
}

BOOST_AUTO_TEST_CASE(wild_exponents_keep_their_signs) {
  Surd::begin();
  const Surd tiny(0x1p-1074), huge(0x1p1023), one(1);
  BOOST_TEST(((one + tiny > one)));
  BOOST_TEST(((sqrt(huge * huge + tiny) > huge)));
  const Real value = (sqrt(huge * huge + tiny) - huge).value();
  BOOST_TEST(value.exponent + std::ilogb(value.high) == -1074 - 1024);
}
