#include "oracle/bounded.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "geometry/case_line.hpp"
#include "tests/numbers/drawer.hpp"
#include "tests/oracle/dyadic.hpp"

using namespace rayaudit;
using oracle::Bounded;
using oracle::known_to;
using oracle::proved_sign;

namespace {

constexpr int operations = 200'000;

/// A number with its bound, and an exact value that lies within it.
struct Operand {
  Bounded bounded;
  Dyadic exact;
};

Dyadic middle(const Bounded& x) { return Dyadic(x.high) + Dyadic(x.low); }

bool holds(const Operand& x) {
  return size(x.exact - middle(x.bounded)) <= Dyadic(x.bounded.error);
}

std::string shown(const Bounded& x) {
  std::string words;
  write(words, x.high), words += " + ";
  write(words, x.low), words += " +- ";
  write(words, x.error);
  return words;
}

/// Operands of every kind: with and without low words and errors, of few bits and of many.
class Drawer : public NumberDrawer {
 public:
  using NumberDrawer::NumberDrawer;

  Bounded exact_word(int least, int most) {
    const double high = number(least, most);
    const double low = below(4) == 0 ? 0 : std::ldexp(high * symmetric(), -53);
    return oracle::double_word::fast_two_sum(high, low);
  }

  /// The exact value lies anywhere within the error, often at its very end.
  Operand with_error(Bounded word, int least_bits) {
    const double share = below(3) == 0 ? symmetric() : between(-1, 1);
    if (below(4) != 0)
      word.error = std::ldexp(std::fabs(word.high * symmetric()), -between(least_bits, 110));
    return {word, middle(word) + Dyadic(share) * Dyadic(word.error)};
  }

  Operand operand(int least, int most, int least_bits = 0) {
    return with_error(exact_word(least, most), least_bits);
  }
  Operand positive(int least, int most) {
    Bounded word = exact_word(least, most);
    return with_error(word.high < 0 ? -word : word, 3);
  }

  /// One that leaves little of x in a sum.
  Operand near(const Operand& x) {
    const double off = std::ldexp(symmetric(), -between(0, 110));
    const Bounded word =
        oracle::double_word::fast_two_sum(-x.bounded.high, -x.bounded.low + off * x.bounded.high);
    return with_error(word, 0);
  }
};

/// Requires the bound of op on many operands that draw() gives; an infinite one counts as wide.
template <class O, class D>
void require_bound(const char* what, O&& op, D&& draw, double widest_share = 0) {
  int wide = 0;
  for (int i = 0; i < operations; ++i) {
    const auto [a, b] = draw(i);
    const Operand result = {op(a.bounded, b.bounded), op(a.exact, b.exact)};
    if (!std::isfinite(result.bounded.error)) {
      ++wide;
      continue;
    }
    if (holds(result)) continue;
    BOOST_FAIL(what << " of " << shown(a.bounded) << " and " << shown(b.bounded) << " is not "
                    << shown(result.bounded));
    return;
  }
  BOOST_TEST(wide <= widest_share * operations, what << ": " << wide << " infinite bounds");
}

constexpr auto sum = [](const auto& a, const auto& b) { return a + b; };
constexpr auto difference_of = [](const auto& a, const auto& b) { return a - b; };
constexpr auto product = [](const auto& a, const auto& b) { return a * b; };

/// Requires the bound of quotients: |a - q b| <= error |b|.
template <class D>
void require_quotients(D&& draw, double widest_share = 0) {
  int wide = 0;
  for (int i = 0; i < operations; ++i) {
    const auto [a, b] = draw(i);
    const Bounded q = a.bounded / b.bounded;
    if (!std::isfinite(q.error)) {
      ++wide;
      continue;
    }
    if (size(a.exact - middle(q) * b.exact) <= Dyadic(q.error) * size(b.exact)) continue;
    BOOST_FAIL(shown(a.bounded) << " by " << shown(b.bounded) << " is not " << shown(q));
    return;
  }
  BOOST_TEST(wide <= widest_share * operations, wide << " infinite bounds");
}

/// Does the root of x lie within s - e and s + e?
bool is_root(const Dyadic& x, const Bounded& root) {
  const Dyadic above = middle(root) + Dyadic(root.error);
  const Dyadic below = middle(root) - Dyadic(root.error);
  return above.sign() >= 0 && x <= above * above && (below.sign() < 0 || below * below <= x);
}

template <class D>
void require_roots(D&& draw) {
  for (int i = 0; i < operations; ++i) {
    const Operand x = draw(i);
    const Bounded root = sqrt(x.bounded);
    if (std::isfinite(root.error) && is_root(x.exact, root)) continue;
    BOOST_FAIL("root of " << shown(x.bounded) << " is not " << shown(root));
    return;
  }
}

bool is_tight(const Bounded& x) { return x.error <= std::ldexp(std::fabs(x.high), -100); }

template <class N>
N discriminant(const N& a, const N& b, const N& c) {
  const N ac = a * c;
  const N twice = ac + ac;
  return b * b - (twice + twice);
}

template <class N>
N quadratic(const N& a, const N& b, const N& c, const N& t) {
  return (a * t + b) * t + c;
}

template <class N>
N determinant(const std::array<N, 9>& m) {
  return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
         m[2] * (m[3] * m[7] - m[4] * m[6]);
}

void require_holds(const Operand& result) {
  if (!holds(result)) BOOST_FAIL("not within " << shown(result.bounded));
}

}  // namespace

BOOST_AUTO_TEST_CASE(sums_and_differences_lie_within_their_bounds) {
  Drawer drawer(1);
  const auto wild = [&](int) {
    return std::pair(drawer.operand(-300, 300), drawer.operand(-300, 300));
  };
  const auto beside = [&](int) {
    return std::pair(drawer.operand(-5, 5), drawer.operand(-60, 60));
  };
  const auto cancelling = [&](int) {
    const Operand a = drawer.operand(-100, 100);
    return std::pair(a, drawer.near(a));
  };
  require_bound("sum", sum, wild);
  require_bound("sum", sum, beside);
  require_bound("sum", sum, cancelling);
  require_bound("difference", difference_of, wild);
  require_bound("difference", difference_of, beside);
}

BOOST_AUTO_TEST_CASE(products_lie_within_their_bounds) {
  Drawer drawer(2);
  require_bound("product", product, [&](int) {
    return std::pair(drawer.operand(-300, 300), drawer.operand(-300, 300));
  });
}

BOOST_AUTO_TEST_CASE(quotients_lie_within_their_bounds) {
  Drawer drawer(3);
  require_quotients(
      [&](int) { return std::pair(drawer.operand(-300, 300), drawer.operand(-300, 300, 2)); });
}

BOOST_AUTO_TEST_CASE(roots_lie_within_their_bounds) {
  Drawer drawer(4);
  require_roots([&](int) { return drawer.positive(-800, 800); });
}

BOOST_AUTO_TEST_CASE(bounds_hold_where_numbers_underflow) {
  Drawer drawer(5);
  const auto tiny = [&](int) {
    return std::pair(drawer.operand(-1074, -900), drawer.operand(-1074, -900));
  };
  const auto to_tiny = [&](int) {
    return std::pair(drawer.operand(-560, -480), drawer.operand(-560, -480));
  };
  const auto tiny_by_one = [&](int) {
    return std::pair(drawer.operand(-1074, -900), drawer.operand(-20, 20, 2));
  };
  const auto tiny_by_tiny = [&](int) {
    return std::pair(drawer.operand(-1074, -900), drawer.operand(-1060, -900, 2));
  };
  require_bound("sum", sum, tiny);
  require_bound("difference", difference_of, tiny);
  require_bound("product", product, to_tiny);
  require_bound("product", product, tiny_by_one);
  require_bound("product", product, tiny);
  require_quotients(tiny_by_one);
  require_quotients(to_tiny);
  require_quotients(tiny_by_tiny, 0.9);
}

BOOST_AUTO_TEST_CASE(sums_and_products_of_numbers_of_a_case_are_exact) {
  Drawer drawer(14);
  const auto require_exact = [](const Bounded& got, const Dyadic& exact, double most) {
    if (!holds({got, exact}) || !(got.error <= most)) BOOST_FAIL("inexact: " << shown(got));
  };
  for (int i = 0; i < operations; ++i) {
    const double x = drawer.number(-400, 400), y = drawer.number(-400, 400);
    // Exact but for underflow where the compiler sees that the low words are 0; without
    // optimization it does not.
    const double most = 0x1p-1060 + std::fabs(x * y) * 0x1p-100;
    require_exact(Bounded(x) * Bounded(y), Dyadic(x) * Dyadic(y), most);
    const double slack = std::fabs(x + y) * 0x1p-100;
    require_exact(Bounded(x) + Bounded(y), Dyadic(x) + Dyadic(y), slack);
    require_exact(Bounded(x) - Bounded(x), Dyadic(), 0);
    const double tiny = drawer.number(-560, -480), other = drawer.number(-560, -480);
    require_exact(Bounded(tiny) * Bounded(other), Dyadic(tiny) * Dyadic(other), 0x1p-960);
    require_exact(twice(Bounded(x)), Dyadic(x) + Dyadic(x), 0);
    const Operand word = drawer.operand(-300, 300);
    if (!holds({twice(word.bounded), word.exact + word.exact})) BOOST_FAIL("twice");
  }
}

BOOST_AUTO_TEST_CASE(bounds_hold_or_are_infinite_where_numbers_overflow) {
  Drawer drawer(6);
  const auto huge = [&](int) {
    return std::pair(drawer.operand(960, 1020), drawer.operand(960, 1020));
  };
  const auto to_huge = [&](int) {
    return std::pair(drawer.operand(480, 530), drawer.operand(480, 530));
  };
  const auto by_tiny = [&](int) {
    return std::pair(drawer.operand(480, 530), drawer.operand(-530, -480, 2));
  };
  require_bound("sum", sum, huge, 0.5);
  require_bound("product", product, to_huge, 0.5);
  require_quotients(by_tiny, 0.5);
}

BOOST_AUTO_TEST_CASE(discriminants_that_cancel_lie_within_their_bounds) {
  Drawer drawer(7);
  int cancelled = 0;
  for (int i = 0; i < operations; ++i) {
    const Operand a = drawer.operand(-30, 30, 60), b = drawer.operand(-30, 30, 60);
    const double c = b.bounded.high * b.bounded.high / (4 * a.bounded.high);
    const Operand near = drawer.with_error(Bounded(c), 60);
    const Bounded d = discriminant(a.bounded, b.bounded, near.bounded);
    require_holds({d, discriminant(a.exact, b.exact, near.exact)});
    cancelled += std::fabs(d.high) < 0x1p-40 * b.bounded.high * b.bounded.high;
  }
  BOOST_TEST(cancelled > operations / 2);
}

BOOST_AUTO_TEST_CASE(polynomials_near_their_roots_lie_within_their_bounds) {
  Drawer drawer(8);
  for (int i = 0; i < operations; ++i) {
    const Operand a = drawer.operand(-9, 9), b = drawer.operand(-9, 9), t = drawer.operand(-9, 9);
    const double at = (a.bounded.high * t.bounded.high + b.bounded.high) * t.bounded.high;
    const Operand c = drawer.with_error(Bounded(-at), 0);
    require_holds({quadratic(a.bounded, b.bounded, c.bounded, t.bounded),
                   quadratic(a.exact, b.exact, c.exact, t.exact)});
  }
}

BOOST_AUTO_TEST_CASE(determinants_lie_within_their_bounds) {
  Drawer drawer(9);
  for (int i = 0; i < operations / 4; ++i) {
    std::array<Bounded, 9> bounded;
    std::array<Dyadic, 9> exact;
    for (std::size_t j = 0; j < 9; ++j) {
      // The last row is near to a multiple of the first.
      const Operand x = j < 6 ? drawer.operand(-20, 20, 40)
                              : drawer.with_error(Bounded(bounded[j - 6].high * 3), 40);
      bounded[j] = x.bounded, exact[j] = x.exact;
    }
    require_holds({determinant(bounded), determinant(exact)});
  }
}

BOOST_AUTO_TEST_CASE(a_root_of_a_quadratic_lies_within_its_bound) {
  Drawer drawer(10);
  int proved = 0;
  for (int i = 0; i < operations; ++i) {
    const Bounded a = drawer.exact_word(-20, 20), b = drawer.exact_word(-20, 20),
                  c = drawer.exact_word(-20, 20);
    const Bounded root = sqrt(discriminant(a, b, c));
    const Bounded t = (b.high > 0 ? -(b + root) : root - b) / (a + a);
    if (!known_to(t, 0x1p-40)) continue;
    ++proved;
    const auto sign_at = [&](const Dyadic& at) {
      return quadratic(middle(a), middle(b), middle(c), at).sign();
    };
    const int around = sign_at(middle(t) - Dyadic(t.error)) * sign_at(middle(t) + Dyadic(t.error));
    if (around > 0)
      BOOST_FAIL("no root of " << shown(a) << ", " << shown(b) << ", " << shown(c) << " in "
                               << shown(t));
  }
  BOOST_TEST(proved > operations / 4);
}

BOOST_AUTO_TEST_CASE(bounds_of_exact_operands_are_tight) {
  Drawer drawer(11);
  for (int i = 0; i < operations; ++i) {
    const Bounded a = drawer.exact_word(-300, 300), b = drawer.exact_word(-300, 300);
    const Bounded positive = a.high > 0 ? a : -a;
    const bool tight = is_tight(a + b) && is_tight(a - b) && is_tight(a * b) && is_tight(a / b) &&
                       is_tight(sqrt(positive));
    if (!tight) BOOST_FAIL("not tight: " << shown(a) << " and " << shown(b));
  }
}

BOOST_AUTO_TEST_CASE(a_quotient_by_what_may_be_0_has_an_infinite_bound) {
  for (const Bounded& divisor : {Bounded(0), Bounded(1, 0, 1), Bounded(-1, 0, 2),
                                 Bounded(0x1p-600, 0, 0x1p-600), Bounded(0, 0, 0x1p-1074)}) {
    BOOST_TEST(!std::isfinite((Bounded(1) / divisor).error));
    BOOST_TEST(!std::isfinite((Bounded(0) / divisor).error));
  }
  BOOST_TEST(std::isfinite((Bounded(1) / Bounded(1, 0, 0.5)).error));
}

BOOST_AUTO_TEST_CASE(a_root_of_what_may_be_negative_has_an_infinite_bound) {
  for (const Bounded& square : {Bounded(0), Bounded(-1), Bounded(1, 0, 1), Bounded(1, 0, 1.5),
                                Bounded(-1, 0, 0.25), Bounded(0, 0, 0x1p-1074)})
    BOOST_TEST(!std::isfinite(sqrt(square).error));
  BOOST_TEST(std::isfinite(sqrt(Bounded(1, 0, 0.25)).error));
}

BOOST_AUTO_TEST_CASE(a_sign_is_told_only_where_the_bound_proves_it) {
  Drawer drawer(12);
  int told = 0, open = 0;
  for (int i = 0; i < operations; ++i) {
    Bounded x = drawer.exact_word(-100, 100);
    x.error = std::ldexp(std::fabs(x.high), drawer.between(-60, 2));
    if (drawer.below(2) == 0)
      x.error = std::fabs(x.high) + drawer.between(-1, 1) * std::fabs(x.low);
    const int least = (middle(x) - Dyadic(x.error)).sign();
    const int most = (middle(x) + Dyadic(x.error)).sign();
    const int sign = proved_sign(x);
    ++(sign == 0 ? open : told);
    if (sign != 0 && (least != sign || most != sign)) BOOST_FAIL("not proved: " << shown(x));
    if (sign == 0 && x.error < 0.99 * std::fabs(x.high)) BOOST_FAIL("proved: " << shown(x));
  }
  BOOST_TEST(told > operations / 4);
  BOOST_TEST(open > operations / 4);
  BOOST_TEST(proved_sign(Bounded(0)) == 0);
}

BOOST_AUTO_TEST_CASE(a_value_is_known_only_where_the_bound_proves_it) {
  Drawer drawer(13);
  int known = 0, open = 0;
  for (int i = 0; i < operations; ++i) {
    Bounded x = drawer.exact_word(-100, 100);
    const int bits = drawer.between(10, 100);
    x.error = std::ldexp(std::fabs(x.high) + drawer.between(-1, 1) * std::fabs(x.low),
                         -bits + drawer.between(-1, 1));
    // Wherever in the bound the value lies, the middle is within 2^-bits of it.
    const Dyadic least = size(middle(x)) - Dyadic(x.error);
    const bool proved = times_power(Dyadic(x.error), bits) <= least;
    const bool said = known_to(x, std::ldexp(1.0, -bits));
    ++(said ? known : open);
    // known_to speaks of the middle where the bound is that narrow: off by 2^-bits at most.
    const bool nearly = times_power(Dyadic(x.error), bits) <= size(middle(x));
    if (said && !nearly) BOOST_FAIL("not known to " << bits << " bits: " << shown(x));
    if (proved && !said && times_power(Dyadic(x.error), bits + 1) <= least)
      BOOST_FAIL("known to " << bits << " bits: " << shown(x));
  }
  BOOST_TEST(known > operations / 4);
  BOOST_TEST(open > operations / 4);
  BOOST_TEST(!known_to(Bounded(0, 0, 0x1p-1074), 0x1p-10));
}

BOOST_AUTO_TEST_CASE(no_comparison_accepts_an_overflow) {
  const Bounded large(0x1p1000);
  for (const Bounded& x :
       {large * large, Bounded(0x1p1023) + Bounded(0x1p1023), large / Bounded(0x1p-1000),
        large * large + large, large / (large * large), large * large - large * large}) {
    BOOST_TEST(!known_to(x, 0x1p-10));
    BOOST_TEST(proved_sign(x) == 0);
  }
}
