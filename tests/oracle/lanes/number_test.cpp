#include "oracle/lanes/number.hpp"

#include <boost/test/unit_test.hpp>
#include <string>

#include "tests/numbers/drawer.hpp"
#include "tests/oracle/dyadic.hpp"

/// What ARCHITECTURE.md proves of each operation, held against exact numbers: operands that use
/// what their type allows to the full, results that keep within theirs.
using namespace rayaudit;
using namespace rayaudit::oracle::HWY_NAMESPACE;

namespace {

constexpr int operations = 100'000;

V lane(double x) { return hn::Set(Tag(), x); }
double at_first(const V& x) { return hn::GetLane(x); }

template <class N>
struct Operand {
  N number;
  Dyadic exact;
};

template <int w, int e>
Dyadic told(const Lane<w, e>& x) {
  return Dyadic(at_first(x.high)) + Dyadic(at_first(x.low));
}
template <int w1, int w2, int e>
Dyadic told(const Wide<w1, w2, e>& x) {
  return Dyadic(at_first(x.high)) + Dyadic(at_first(x.middle)) + Dyadic(at_first(x.low));
}
Dyadic told(const Known& x) { return Dyadic(at_first(x.high)) + Dyadic(at_first(x.low)); }

/// At most k u^n magnitude, up to what the proof leaves to the roundings of the magnitude.
bool is_within(const Dyadic& x, int k, int n, const V& magnitude) {
  const Dyadic most = Dyadic(k * (1 + 0x1p-40)) * Dyadic(at_first(magnitude));
  return size(x) <= times_power(most, -53L * n);
}

template <int w, int e>
bool keeps_its_word(const Operand<Lane<w, e>>& x) {
  const auto& [number, exact] = x;
  return is_within(exact, 1, 0, number.magnitude) &&
         is_within(Dyadic(at_first(number.high)), 1, 0, number.magnitude) &&
         is_within(Dyadic(at_first(number.low)), w, 1, number.magnitude) &&
         is_within(told(number) - exact, e, 2, number.magnitude);
}
template <int w1, int w2, int e>
bool keeps_its_word(const Operand<Wide<w1, w2, e>>& x) {
  const auto& [number, exact] = x;
  return is_within(exact, 1, 0, number.magnitude) &&
         is_within(Dyadic(at_first(number.high)), 1, 0, number.magnitude) &&
         is_within(Dyadic(at_first(number.middle)), w1, 1, number.magnitude) &&
         is_within(Dyadic(at_first(number.low)), w2, 2, number.magnitude) &&
         is_within(told(number) - exact, e, 3, number.magnitude);
}
bool keeps_its_word(const Operand<Known>& x) {
  const auto& [number, exact] = x;
  return size(Dyadic(at_first(number.low))) <=
             times_power(size(Dyadic(at_first(number.high))), -53) &&
         size(told(number) - exact) <= Dyadic(at_first(number.error));
}

/// Operands, often at the very ends of what their type allows.
class Drawer : public NumberDrawer {
 public:
  using NumberDrawer::NumberDrawer;

  double share() { return below(2) == 0 ? symmetric() : below(2) == 0 ? -1 : 1; }
  double size_of_magnitude() { return std::fabs(number(-60, 60)); }

  template <class N>
  Operand<N> operand() {
    return draw(static_cast<N*>(nullptr));
  }

  Operand<Known> known_operand(int most_bits) {
    const double high = number(-60, 60), low = high * share() * 0x1p-54;
    const double error = std::fabs(high) * std::ldexp(1 + symmetric() / 2, -between(3, most_bits));
    const Pair sum = fast_two_sum(lane(high), lane(low));
    const Known known{sum.high, sum.low, lane(error)};
    return {known, told(known) + Dyadic(share()) * Dyadic(error)};
  }
  Operand<Known> positive() {
    auto x = known_operand(110);
    if (at_first(x.number.high) < 0) x = {-x.number, -x.exact};
    return x;
  }

 private:
  Operand<Word> draw(Word*) {
    const double x = number(-60, 60);
    return {{lane(x)}, Dyadic(x)};
  }
  Operand<WideWord> draw(WideWord*) {
    const double x = number(-60, 60);
    return {{lane(x)}, Dyadic(x)};
  }
  template <int w, int e>
  Operand<Lane<w, e>> draw(Lane<w, e>*) {
    const double m = size_of_magnitude(), high = m * share() * (1 - 0x1p-40);
    const double low = w * 0x1p-53 * m * share();
    const Lane<w, e> number(lane(high), lane(low), lane(m));
    return {number, told(number) + times_power(Dyadic(e * share()) * Dyadic(m), -106)};
  }
  template <int w1, int w2, int e>
  Operand<Wide<w1, w2, e>> draw(Wide<w1, w2, e>*) {
    const double m = size_of_magnitude(), high = m * share() * (1 - 0x1p-40);
    const double middle = w1 * 0x1p-53 * m * share(), low = w2 * 0x1p-106 * m * share();
    const Wide<w1, w2, e> number(lane(high), lane(middle), lane(low), lane(m));
    return {number, told(number) + times_power(Dyadic(e * share()) * Dyadic(m), -159)};
  }
};

template <class A, class B>
void hold_sums_and_products(unsigned seed) {
  Drawer draw(seed);
  for (int i = 0; i < operations; ++i) {
    const auto a = draw.operand<A>();
    const auto b = draw.operand<B>();
    const auto require = [&](const char* what, const auto& number, const Dyadic& exact) {
      const Operand<std::remove_cvref_t<decltype(number)>> result{number, exact};
      BOOST_REQUIRE_MESSAGE(keeps_its_word(result), what << " no. " << i << " of seed " << seed);
    };
    require("sum", a.number + b.number, a.exact + b.exact);
    require("difference", a.number - b.number, a.exact - b.exact);
    require("product", a.number * b.number, a.exact * b.exact);
    require("square", squared(a.number), a.exact * a.exact);
    // Both cancel in their leading words.
    auto c = b;
    c.number.high = hn::Neg(a.number.high);
    if constexpr (requires { c.number.magnitude; })
      c.number.magnitude = lane(std::max(std::fabs(at_first(a.number.high)) * (1 + 0x1p-40),
                                         at_first(b.number.magnitude)));
    c.exact = b.exact - Dyadic(at_first(b.number.high)) + Dyadic(at_first(c.number.high));
    require("sum that cancels", a.number + c.number, a.exact + c.exact);
  }
}

/// Is y^2 within the error of x, so that y is the root of something x may be?
bool is_root(const Known& root, const Dyadic& exact) {
  const Dyadic low = told(root) - Dyadic(at_first(root.error));
  const Dyadic high = told(root) + Dyadic(at_first(root.error));
  return (low.sign() <= 0 || low * low <= exact) && exact <= high * high;
}

}  // namespace

BOOST_AUTO_TEST_CASE(numbers_of_two_words_keep_the_bounds_of_their_types) {
  hold_sums_and_products<Word, Word>(1);
  hold_sums_and_products<Word, Lane<1, 0>>(2);
  hold_sums_and_products<Lane<1, 0>, Word>(3);
  hold_sums_and_products<Lane<1, 0>, Lane<1, 0>>(4);
  hold_sums_and_products<Lane<4, 14>, Lane<1, 0>>(5);
  hold_sums_and_products<Lane<4, 14>, Lane<9, 51>>(6);
  hold_sums_and_products<Lane<17, 195>, Lane<17, 195>>(7);
}

BOOST_AUTO_TEST_CASE(numbers_of_three_words_keep_the_bounds_of_their_types) {
  hold_sums_and_products<WideWord, WideWord>(11);
  hold_sums_and_products<WideWord, ExactWide>(12);
  hold_sums_and_products<ExactWide, WideWord>(13);
  hold_sums_and_products<ExactWide, ExactWide>(14);
  hold_sums_and_products<Wide<3, 9, 40>, ExactWide>(15);
  hold_sums_and_products<Wide<7, 60, 500>, Wide<9, 80, 900>>(16);
}

BOOST_AUTO_TEST_CASE(what_is_known_of_a_lane_holds) {
  Drawer draw(21);
  for (int i = 0; i < operations; ++i) {
    const auto two = draw.operand<Lane<4, 14>>();
    BOOST_REQUIRE(keeps_its_word({known(two.number), two.exact}));
    const auto three = draw.operand<Wide<7, 60, 500>>();
    BOOST_REQUIRE(keeps_its_word({known(three.number), three.exact}));
  }
}

BOOST_AUTO_TEST_CASE(a_sum_of_numbers_of_one_sign_is_known) {
  Drawer draw(22);
  for (int i = 0; i < operations; ++i) {
    const auto a = draw.positive(), b = draw.positive();
    BOOST_REQUIRE(keeps_its_word({plus_alike(a.number, b.number), a.exact + b.exact}));
    BOOST_REQUIRE(keeps_its_word({plus_alike(-a.number, -b.number), -a.exact - b.exact}));
  }
}

BOOST_AUTO_TEST_CASE(a_root_is_known_where_its_square_is_clear) {
  Drawer draw(23);
  int held = 0;
  for (int i = 0; i < operations; ++i) {
    const auto x = draw.positive();
    if (!hn::AllTrue(Tag(), is_clear(x.number))) continue;
    ++held;
    BOOST_REQUIRE(is_root(sqrt(x.number), x.exact));
  }
  BOOST_TEST(held > operations / 2);
}

BOOST_AUTO_TEST_CASE(a_quotient_is_known_where_the_divisor_is_clear) {
  Drawer draw(24);
  int held = 0;
  for (int i = 0; i < operations; ++i) {
    const auto a = draw.known_operand(110), b = draw.known_operand(110);
    if (!hn::AllTrue(Tag(), is_clear(b.number))) continue;
    ++held;
    const Known q = a.number / b.number;
    // |q b - a| <= error |b|
    const Dyadic off = told(q) * b.exact - a.exact;
    BOOST_REQUIRE(size(off) <= Dyadic(at_first(q.error)) * size(b.exact));
    BOOST_REQUIRE(std::fabs(at_first(q.low)) <= std::fabs(at_first(q.high)) * 0x1p-53);
  }
  BOOST_TEST(held > operations / 2);
}

BOOST_AUTO_TEST_CASE(a_sign_is_proved_only_beyond_the_bound) {
  Drawer draw(25);
  int proved = 0;
  for (int i = 0; i < operations; ++i) {
    auto x = draw.operand<Lane<4, 14>>();
    // So near to 0 that the error may turn it.
    x.exact = x.exact - Dyadic(at_first(x.number.high));
    x.number.high = lane(0);
    const Proof sign = proof(x.number, lane(0));
    const bool positive = hn::AllTrue(Tag(), sign.positive);
    const bool negative = hn::AllTrue(Tag(), sign.negative);
    proved += positive || negative ? 1 : 0;
    BOOST_REQUIRE(!positive || x.exact.sign() > 0);
    BOOST_REQUIRE(!negative || x.exact.sign() < 0);
  }
  BOOST_TEST(proved > operations / 2);
}
