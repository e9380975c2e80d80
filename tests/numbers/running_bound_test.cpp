#include "numbers/running_bound.hpp"

#include <algorithm>
#include <boost/mpl/list.hpp>
#include <boost/test/unit_test.hpp>
#include <functional>
#include <vector>

#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "numbers/wide_bound.hpp"
#include "routines/routines.hpp"
#include "tests/numbers/drawer.hpp"

using namespace rayaudit;

namespace {

constexpr int operations = 30'000;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Numbers = boost::mpl::list<float, double, long double, DoubleDouble>;
template <class N>
constexpr int bits = std::numeric_limits<N>::digits;
template <>
constexpr int bits<DoubleDouble> = 106;

/// A number with its bound, and an exact value that lies within it.
template <class N>
struct Operand {
  RunningBound<N> bound;
  Dyadic exact;
};

template <class N>
Dyadic middle(const RunningBound<N>& x) {
  return exactly(x.value) + Dyadic(x.off);
}
template <class N>
bool holds(const Operand<N>& x) {
  return is_at_most(x.exact - middle(x.bound), Dyadic(x.bound.slack())) &&
         is_at_most(x.exact - exactly(x.bound.value), Dyadic(x.bound.error()));
}

template <class N>
std::string shown(const RunningBound<N>& x) {
  std::string words;
  write(words, static_cast<double>(x.value)), words += " + ";
  write(words, x.off), words += " most ";
  write(words, x.most);
  return words;
}

template <class N>
N in_number(const DoubleDouble& x) {
  if constexpr (std::is_same_v<N, DoubleDouble>)
    return x;
  else
    return static_cast<N>(x.high) + static_cast<N>(x.low);
}

template <class N>
class Drawer : public NumberDrawer {
 public:
  using NumberDrawer::NumberDrawer;

  /// The exact value lies anywhere within the bound, often near its very end.
  Operand<N> bounded(N value, int least_bits) {
    RunningBound<N> x(value);
    if (below(4) != 0) {
      x.most = std::ldexp(std::fabs(static_cast<double>(value)), -between(least_bits, bits<N> + 3));
      x.most = std::fmax(x.most, running_bound::smallest);
      if (!std::is_same_v<N, DoubleDouble>) x.off = x.most * symmetric() * 0.999;
    }
    const double end = below(3) == 0 ? symmetric() : between(-1, 1);
    return {x, middle(x) + Dyadic(end * (1 - 0x1p-10)) * Dyadic(x.slack())};
  }
  Operand<N> operand(int least, int most, int least_bits = 0) {
    return bounded(in_number<N>(word(least, most)), least_bits);
  }
  Operand<N> positive(int least, int most, int least_bits) {
    const N x = in_number<N>(word(least, most));
    return bounded(x < N(0) ? -x : x, least_bits);
  }
  /// One of which rounding has left nothing, perhaps: the error may be larger than the value.
  Operand<N> cancelled() { return bounded(in_number<N>(word(-3, 3)), -8); }
  /// One about where x exactly is, or one or two last places off it.
  Operand<N> at(const Operand<N>& x) {
    const auto value = static_cast<double>(x.bound.value);
    const double last = std::ldexp(std::fabs(value + x.bound.off), 1 - bits<N>);
    const DoubleDouble place = DoubleDouble(value) + DoubleDouble(x.bound.off);
    return bounded(in_number<N>(place + DoubleDouble(last * between(-2, 2))), bits<N>);
  }
  Operand<N> beside(const Operand<N>& x) {
    const DoubleDouble wide(static_cast<double>(x.bound.value));
    return bounded(in_number<N>(near(wide)), 0);
  }
};

template <class N>
void require(const char* what, bool holds, const Operand<N>& a, const Operand<N>& b,
             const RunningBound<N>& got) {
  if (!holds)
    BOOST_FAIL(what << " of " << shown(a.bound) << " and " << shown(b.bound) << " is not "
                    << shown(got));
}

template <class N>
void require_holds(const char* what, const Operand<N>& a, const Operand<N>& b,
                   const RunningBound<N>& got, const Dyadic& exact) {
  if (got.is_bounded()) require(what, holds<N>({got, exact}), a, b, got);
}

template <class N>
void require_sum_and_product(const Operand<N>& a, const Operand<N>& b) {
  require_holds("sum", a, b, a.bound + b.bound, a.exact + b.exact);
  require_holds("difference", a, b, a.bound - b.bound, a.exact - b.exact);
  require_holds("product", a, b, a.bound * b.bound, a.exact * b.exact);
}

/// Where an order is said to be proved, it is that of the exact numbers.
template <class N>
bool require_order(const Operand<N>& a, const Operand<N>& b) {
  const int exact = (a.exact - b.exact).sign();
  const auto hold = [&](const char* what, bool said, bool is_so, bool proved) {
    if (proved) require(what, said == is_so, a, b, a.bound);
    return proved;
  };
  bool proved = true;
  const auto compared = [&](const char* what, const auto& order, bool is_so) {
    const ProofWatch<N> watch;
    const bool said = order(a.bound, b.bound);
    proved = hold(what, said, is_so, watch.all_proved()) && proved;
  };
  compared("<", std::less<>(), exact < 0);
  compared(">", std::greater<>(), exact > 0);
  compared("<=", std::less_equal<>(), exact <= 0);
  compared(">=", std::greater_equal<>(), exact >= 0);
  compared("==", std::equal_to<>(), exact == 0);
  return proved;
}

template <class N>
bool require_quotient(const Operand<N>& a, const Operand<N>& b) {
  const RunningBound<N> q = a.bound / b.bound;
  if (!q.is_bounded()) return false;
  require("quotient",
          is_at_most(a.exact - middle(q) * b.exact, Dyadic(q.slack()) * size(b.exact)) &&
              is_at_most(a.exact - exactly(q.value) * b.exact, Dyadic(q.error()) * size(b.exact)),
          a, b, q);
  return true;
}

template <class N>
bool require_root(const Operand<N>& x) {
  const RunningBound<N> root = sqrt(x.bound);
  if (!root.is_bounded()) return false;
  const Dyadic most = middle(root) + Dyadic(root.slack());
  const Dyadic least = middle(root) - Dyadic(root.slack());
  require(
      "root",
      most.sign() >= 0 && x.exact <= most * most && (least.sign() < 0 || least * least <= x.exact),
      x, x, root);
  return true;
}

constexpr int range(float) { return 30; }
constexpr int range(double) { return 300; }
constexpr int range(long double) { return 300; }
int range(const DoubleDouble&) { return 300; }

/// Every case that the families draw for a shape in a format, few of each.
std::vector<Case> drawn(std::size_t shape, const Format& format, std::size_t of_each) {
  std::vector<Case> cases;
  for (const Family& family : families()) {
    if (family.draw[shape] == nullptr || family.id == "invalid") continue;
    std::vector<Case> some(of_each);
    draw(family, shape, format, {}, 7, 0, some);
    cases.insert(cases.end(), some.begin(), some.end());
  }
  return cases;
}

template <class N>
const Format& drawn_in() {
  return std::is_same_v<N, float> ? float_format : double_format;
}

template <class N>
bool is_same(const N& a, const N& b) {
  return a == b || (a != a && b != b);
}

/// Runs every routine on the families' cases, as visit(routine, question, shape).
template <class N, class V>
void each_run(std::size_t of_each, V&& visit) {
  const auto with = [&]<class Routine>(const Routine& routine) {
    const auto on = [&]<class S>(const S&, std::size_t index) {
      using Shape = decltype(in<N>(S()));
      if constexpr (!std::is_same_v<Routine, Handout> &&
                    std::is_invocable_v<const Routine&, const Ray<N>&, const Shape&>)
        for (const Case& question : drawn(index, drawn_in<N>(), of_each))
          visit(routine, question, *std::get_if<S>(&question.shape));
    };
    on(Disk<double>(), 0), on(Sphere<double>(), 1);
    on(Cylinder<double>(), 2), on(Cone<double>(), 3);
    on(CappedCylinder<double>(), 4), on(CappedCone<double>(), 5);
  };
  std::apply([&](const auto&... routine) { (with(routine), ...); }, Routines());
}

}  // namespace

BOOST_AUTO_TEST_CASE_TEMPLATE(operations_lie_within_their_bounds, N, Numbers) {
  Drawer<N> drawer(1);
  const int far = range(N(0));
  int wide = 0;
  for (int i = 0; i < operations; ++i) {
    const Operand<N> a = drawer.operand(-far, far), b = drawer.operand(-far, far);
    require_sum_and_product(a, b);
    require_sum_and_product(a, drawer.beside(a));
    wide += !require_quotient(a, drawer.operand(-far, far, 4));
    require_quotient(a, b);
    wide += !require_root(drawer.positive(-far, far, 3));
    require_root(drawer.positive(-far, far, 0));
  }
  BOOST_TEST(wide == 0, wide << " of well-known numbers are unbounded");
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_order_that_is_proved_is_the_exact_one, N, Numbers) {
  Drawer<N> drawer(9);
  const int far = range(N(0));
  int proved = 0, open = 0;
  for (int i = 0; i < operations; ++i) {
    const Operand<N> a = drawer.operand(-far, far);
    ++(require_order(a, drawer.operand(-far, far)) ? proved : open);
    // Where the values alone say nothing, or the wrong thing.
    const Operand<N> b = drawer.cancelled(), c = drawer.at(b);
    ++(require_order(b, c) ? proved : open);
    ++(require_order(c, b) ? proved : open);
  }
  BOOST_TEST(proved > operations);
  BOOST_TEST(open > operations / 10);
}

BOOST_AUTO_TEST_CASE(a_float_that_cancelled_is_compared_without_rounding) {
  // In floats the difference of the values is rounded by more than the numbers are open.
  using Bound = RunningBound<float>;
  const Bound a(0x1.f8a2f6p-25f, -0x1p-49, 0x1.8p-49), b(0x1.f8a2f4p-25f);
  const Bound far(3.0f, 0x1p-24, 0x1p-23), near(0x1p-23f);
  for (const auto& [x, y] : {std::pair(a, b), std::pair(far, near)}) {
    const ProofWatch<float> watch;
    const bool said = x < y;
    const double gap =
        (static_cast<double>(x.value) + x.off) - (static_cast<double>(y.value) + y.off);
    if (watch.all_proved()) BOOST_TEST(said == (gap < 0));
  }
}

BOOST_AUTO_TEST_CASE(values_too_far_apart_for_their_format_are_no_proof) {
  using Bound = RunningBound<float>;
  const Bound p(-3e38f, 9e38, 9.5e38), q(3e38f);
  const ProofWatch<float> watch;
  const bool said = p > q;
  BOOST_TEST((said || !watch.all_proved()));
}

BOOST_AUTO_TEST_CASE_TEMPLATE(bounds_hold_where_numbers_underflow, N, Numbers) {
  Drawer<N> drawer(2);
  const int tiny = std::is_same_v<N, float> ? -149 : -1074;
  for (int i = 0; i < operations; ++i) {
    const Operand<N> a = drawer.operand(tiny, tiny + 60);
    require_sum_and_product(a, drawer.operand(tiny, tiny + 60));
    require_sum_and_product(a, drawer.operand(-3, 3));
    const Operand<N> half = drawer.operand(tiny / 2 - 20, tiny / 2 + 20);
    require_sum_and_product(half, drawer.operand(tiny / 2 - 20, tiny / 2 + 20));
    require_quotient(a, drawer.operand(tiny, tiny + 60, 3));
    require_quotient(a, drawer.operand(-3, 60, 3));
    require_quotient(half, drawer.operand(tiny / 2 - 20, tiny / 2 + 20, 3));
    require_root(drawer.positive(tiny, tiny + 200, 3));
  }
}

/// The bound of what is divided is far below the numbers themselves; brought to a scale where it
/// underflows, it would be gone.
BOOST_AUTO_TEST_CASE(a_tiny_bound_divided_by_a_small_number_is_not_lost) {
  const double off = 0x1p-1060;
  for (const double divisor : {0x1p-370, 0x1.8p-500, -0x1p-19, 0x1p-1000, 0x1p200}) {
    const WideBound a(DoubleDouble(0x1p-1027), 0, off), b{DoubleDouble(divisor)};
    const WideBound quotient = a / b;
    BOOST_TEST(quotient.most >= off / std::fabs(divisor), divisor);
  }
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_overflow_proves_nothing, N, Numbers) {
  using Bound = RunningBound<N>;
  const auto greatest = std::is_same_v<N, float> ? static_cast<double>(3e38f) : 1.7e308;
  const Bound huge(static_cast<N>(greatest));
  const Bound double_range = huge * huge;
  for (const Bound& x : {double_range, -double_range, double_range * double_range,
                         huge * Bound(2) * double_range, double_range - double_range}) {
    const ProofWatch<N> watch;
    (void)(x < Bound(1));
    BOOST_TEST((!watch.all_proved() || x.is_bounded()), shown(x));
  }
  // Beyond double, and within long double: nothing is taken for an infinity that was given.
  const Bound beyond = (huge + huge) * (huge + huge);
  BOOST_TEST(!(beyond.most == 0), shown(beyond));
  if (!std::is_same_v<N, long double>) BOOST_TEST(!double_range.is_bounded());
  if (!std::is_same_v<N, long double>) BOOST_TEST(!(huge + huge).is_bounded());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_given_infinity_is_exact, N, Numbers) {
  using Bound = RunningBound<N>;
  const Bound endless{infinity}, third = Bound(1) / Bound(3);
  const ProofWatch<N> watch;
  BOOST_TEST((third < endless));
  BOOST_TEST((third < endless * third));
  BOOST_TEST((-third > third * -endless));
  BOOST_TEST(watch.all_proved());
  BOOST_TEST(!(endless * (third - third)).is_bounded());
  BOOST_TEST(!(third < endless * (third - third)));
  BOOST_TEST(!watch.all_proved());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_exact_zero_stays_exact, N, Numbers) {
  using Bound = RunningBound<N>;
  const Bound third = Bound(1) / Bound(3), zero(0);
  for (const Bound& x : {zero * third, third * zero, zero / third, sqrt(zero), zero + zero,
                         Bound(3) - Bound(3), -zero}) {
    BOOST_TEST(x.error() == 0);
    BOOST_TEST((x.value == N(0)));
  }
  BOOST_TEST((third - third).error() > 0);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(what_may_be_divided_by_zero_or_rooted_below_it_is_unbounded, N,
                              Numbers) {
  using Bound = RunningBound<N>;
  const Bound third = Bound(1) / Bound(3), nothing = third * Bound(3) - Bound(1);
  BOOST_TEST(nothing.error() > 0);
  BOOST_TEST(!(third / nothing).is_bounded());
  BOOST_TEST(!(third / Bound(0)).is_bounded());
  BOOST_TEST(!(Bound(0) / Bound(0)).is_bounded());
  BOOST_TEST(!sqrt(nothing).is_bounded());
  BOOST_TEST(!sqrt(-third).is_bounded());
}

BOOST_AUTO_TEST_CASE_TEMPLATE(an_order_that_is_open_is_not_proved, N, Numbers) {
  using Bound = RunningBound<N>;
  const auto is_proved = [](const Bound& a, const Bound& b) {
    const ProofWatch<N> watch;
    (void)(a < b);
    return watch.all_proved();
  };
  const Bound third = Bound(1) / Bound(3), one = third + third + third;
  BOOST_TEST(is_proved(third, Bound(1)));
  BOOST_TEST(is_proved(Bound(1), Bound(1)));
  BOOST_TEST(!is_proved(one, Bound(1)));
  BOOST_TEST(!is_proved(third, third));
  for (const bool less : {false, true})
    for (const auto& holds :
         {std::function<bool(Bound, Bound)>([](Bound a, Bound b) { return a == b; }),
          std::function<bool(Bound, Bound)>([](Bound a, Bound b) { return a <= b; }),
          std::function<bool(Bound, Bound)>([](Bound a, Bound b) { return a > b; }),
          std::function<bool(Bound, Bound)>([](Bound a, Bound b) { return a >= b; })}) {
      const ProofWatch<N> watch;
      (void)holds(less ? third : one, Bound(1));
      BOOST_TEST(watch.all_proved() == less);
    }
}

BOOST_AUTO_TEST_CASE(an_answer_that_rounding_turned_is_not_proved) {
  using Bound = RunningBound<float>;
  // 2^24 + 1 is no float: as floats the two are equal, exactly they are not.
  const Bound big(16777216.0f), more = big + Bound(1);
  const auto is_proved = [&](auto order) {
    const ProofWatch<float> watch;
    (void)order(more, big);
    return watch.all_proved();
  };
  BOOST_TEST(!is_proved([](Bound a, Bound b) { return a == b; }));
  BOOST_TEST(!is_proved([](Bound a, Bound b) { return a <= b; }));
  BOOST_TEST(!is_proved([](Bound a, Bound b) { return a > b; }));
  BOOST_TEST(is_proved([](Bound a, Bound b) { return a < b; }));
  BOOST_TEST(is_proved([](Bound a, Bound b) { return a >= b; }));
}

BOOST_AUTO_TEST_CASE(a_double_brings_in_its_distance_from_the_float) {
  BOOST_TEST(RunningBound<float>(0.5).error() == 0);
  BOOST_TEST(RunningBound<float>(0.1f).error() == 0);
  const double off = 0.1 - static_cast<double>(0.1f);
  BOOST_TEST(RunningBound<float>(0.1).error() >= std::fabs(off));
  BOOST_TEST(RunningBound<float>(0.1).off == off);
}

BOOST_AUTO_TEST_CASE(a_power_of_two_is_the_routines_own_and_proved_only_away_from_the_next) {
  NumberDrawer drawer(5);
  for (int i = 0; i < operations; ++i) {
    const double x = std::fabs(drawer.number(-1074, 1020));
    const double got = power_of_two(RunningBound<double>(x)).value;
    if (got != power_of_two(x)) BOOST_FAIL("of " << x);
    const float y = static_cast<float>(std::fabs(drawer.number(-149, 120)));
    if (power_of_two(RunningBound<float>(y)).value != power_of_two(y)) BOOST_FAIL("of " << y);
    const DoubleDouble w = drawer.word(-900, 900);
    if (!(power_of_two(WideBound(w)).value == power_of_two(w))) BOOST_FAIL("of " << shown(w));
  }
  for (const double x : {0.0, -3.0, infinity})
    BOOST_TEST(power_of_two(RunningBound<double>(x)).value == power_of_two(x));
  using Bound = RunningBound<double>;
  const Bound third = Bound(1) / Bound(3), one = third + third + third;
  const ProofWatch<double> watch;
  (void)power_of_two(third);
  BOOST_TEST(watch.all_proved());
  (void)power_of_two(one);
  BOOST_TEST(!watch.all_proved());
}

using Formats = boost::mpl::list<float, double, long double>;

BOOST_AUTO_TEST_CASE_TEMPLATE(a_routine_in_bounds_says_bit_for_bit_what_it_says_in_its_format, N,
                              Formats) {
  each_run<N>(12, [](const auto& routine, const Case& question, const auto& shape) {
    using Bound = RunningBound<N>;
    const Ray<N> ray = in<N>(question.ray);
    const auto plain = routine(ray, in<N>(shape));
    const auto got = routine(in<Bound>(ray), in<Bound>(in<N>(shape)));
    if (plain.has_value() != got.has_value() || (plain && !is_same(got->value, *plain)))
      BOOST_FAIL(routine.name << " differs: " << case_line(question));
  });
}

BOOST_AUTO_TEST_CASE_TEMPLATE(a_certified_answer_agrees_with_that_of_a_wider_number, N, Formats) {
  int proved = 0, both = 0;
  each_run<N>(12, [&](const auto& routine, const Case& question, const auto& shape) {
    using Bound = RunningBound<N>;
    const ProofWatch<N> watch;
    const auto got = routine(in<Bound>(in<N>(question.ray)), in<Bound>(in<N>(shape)));
    if (!watch.all_proved() || (got && !got->is_bounded())) return;
    ++proved;
    const ProofWatch<DoubleDouble> wide_watch;
    const auto wide = routine(in<WideBound>(question.ray), in<WideBound>(shape));
    if (!wide_watch.all_proved()) return;
    ++both;
    if (got.has_value() != wide.has_value())
      BOOST_FAIL(routine.name << " takes two ways: " << case_line(question));
    if (!got || !wide->is_bounded()) return;
    const Dyadic off = exactly(wide->value) - exactly(got->value);
    if (!is_at_most(off, Dyadic(got->error()) + Dyadic(wide->error())) ||
        !is_at_most(off - Dyadic(got->off), Dyadic(got->slack()) + Dyadic(wide->error())))
      BOOST_FAIL(routine.name << " is out of bounds: " << case_line(question));
  });
  BOOST_TEST(both > 1000);
  BOOST_TEST(both > proved * 9 / 10);
}

BOOST_AUTO_TEST_CASE_TEMPLATE(the_bound_of_a_certified_hit_is_tight, N, Formats) {
  std::vector<double> looseness;
  double proved = 0, observed = 0;
  std::vector<Case> cases(chunk_cases);
  draw(families()[0], 1, drawn_in<N>(), {}, 1, 0, cases);
  for (const Case& question : cases) {
    using Bound = RunningBound<N>;
    const auto& sphere = *std::get_if<Sphere<double>>(&question.shape);
    const ProofWatch<N> watch;
    const auto got = ClosestApproach()(in<Bound>(in<N>(question.ray)), in<Bound>(in<N>(sphere)));
    const auto wide = ClosestApproach()(in<WideBound>(question.ray), in<WideBound>(sphere));
    if (!got || !wide || !watch.all_proved()) continue;
    const double off = std::fabs(nearly(exactly(wide->value) - exactly(got->value)));
    const double ulp = std::fabs(static_cast<double>(got->value)) * std::ldexp(1.0, -bits<N>);
    proved = std::fmax(proved, got->error() / ulp), observed = std::fmax(observed, off / ulp);
    if (off > ulp / 100) looseness.push_back(got->error() / off);
  }
  BOOST_TEST_REQUIRE(looseness.size() > 100u);
  std::ranges::sort(looseness);
  BOOST_TEST(looseness[looseness.size() / 2] < 1.01);
  BOOST_TEST(proved < 1.1 * observed);
}
