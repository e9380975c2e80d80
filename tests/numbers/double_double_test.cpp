#include "numbers/double_double.hpp"

#include <boost/test/unit_test.hpp>
#include <limits>

#include "tests/numbers/drawer.hpp"

using namespace rayaudit;

namespace {

constexpr int operations = 100'000;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_within(const Dyadic& off, double share, const Dyadic& of) {
  return size(off) <= Dyadic(share) * size(of);
}

void require(bool holds, const char* what, const DoubleDouble& a, const DoubleDouble& b) {
  if (!holds) BOOST_FAIL(what << " of " << shown(a) << " and " << shown(b));
}

bool is_normal(const DoubleDouble& x) { return x.high + x.low == x.high; }

}  // namespace

BOOST_AUTO_TEST_CASE(operations_keep_the_relative_errors_that_are_proved) {
  NumberDrawer drawer(1);
  for (int i = 0; i < operations; ++i) {
    const DoubleDouble a = drawer.word(-200, 200), b = drawer.word(-200, 200);
    const DoubleDouble near = i % 2 ? b : drawer.near(a);
    const Dyadic x = exactly(a), y = exactly(b), z = exactly(near);
    require(is_within(exactly(a + near) - (x + z), DoubleDouble::sum_error, x + z), "sum", a, near);
    require(is_within(exactly(a - near) - (x - z), DoubleDouble::sum_error, x - z), "difference", a,
            near);
    require(is_within(exactly(a * b) - x * y, DoubleDouble::product_error, x * y), "product", a, b);
    const DoubleDouble quotient = a / b, root = sqrt(a.high < 0 ? -a : a);
    require(is_within(exactly(quotient) * y - x, DoubleDouble::quotient_error, x), "quotient", a,
            b);
    require(is_within(exactly(root) * exactly(root) - size(x), 2.001 * DoubleDouble::root_error, x),
            "root", a, a);
    require(is_normal(a + near) && is_normal(a * b) && is_normal(quotient) && is_normal(root),
            "normal form", a, b);
  }
}

BOOST_AUTO_TEST_CASE(the_relative_errors_are_no_idle_ones) {
  NumberDrawer drawer(2);
  double worst_sum = 0, worst_product = 0, worst_quotient = 0;
  const auto share = [](const Dyadic& off, const Dyadic& of) {
    return of.sign() == 0 ? 0 : nearly(off) / nearly(of);
  };
  for (int i = 0; i < operations; ++i) {
    const DoubleDouble a = drawer.word(0, 2), b = drawer.word(0, 2);
    const Dyadic x = exactly(a), y = exactly(b);
    worst_sum = std::fmax(worst_sum, std::fabs(share(exactly(a + b) - (x + y), x + y)));
    worst_product = std::fmax(worst_product, std::fabs(share(exactly(a * b) - x * y, x * y)));
    worst_quotient = std::fmax(worst_quotient, std::fabs(share(exactly(a / b) * y - x, x)));
  }
  BOOST_TEST(worst_sum > DoubleDouble::sum_error / 8);
  BOOST_TEST(worst_product > DoubleDouble::product_error / 8);
  BOOST_TEST(worst_quotient > DoubleDouble::quotient_error / 8);
}

BOOST_AUTO_TEST_CASE(the_order_is_that_of_the_exact_sums) {
  NumberDrawer drawer(3);
  for (int i = 0; i < operations; ++i) {
    const DoubleDouble a = drawer.word(-3, 3), b = i % 3 ? -drawer.near(a) : (i % 2 ? a : -a);
    const int sign = (exactly(a) - exactly(b)).sign();
    require((a < b) == (sign < 0) && (a > b) == (sign > 0) && (a == b) == (sign == 0) &&
                (a <= b) == (sign <= 0) && (a >= b) == (sign >= 0),
            "order", a, b);
  }
}

BOOST_AUTO_TEST_CASE(infinities_go_through_operations_as_in_double) {
  const DoubleDouble huge(infinity), third = DoubleDouble(1) / DoubleDouble(3);
  BOOST_TEST((huge * third == huge));
  BOOST_TEST((third * -huge == -huge));
  BOOST_TEST((huge + third == huge));
  BOOST_TEST((third - huge == -huge));
  BOOST_TEST((huge / third == huge));
  BOOST_TEST((third / huge == DoubleDouble(0)));
  BOOST_TEST((third / DoubleDouble(0) == huge));
  BOOST_TEST((sqrt(huge) == huge));
  BOOST_TEST((sqrt(DoubleDouble(0)) == DoubleDouble(0)));
  BOOST_TEST((third < huge && !(huge < third) && huge <= huge && -huge < third));
  BOOST_TEST(std::isnan((huge - huge).high));
  BOOST_TEST(std::isnan((huge * DoubleDouble(0)).high));
  BOOST_TEST(std::isnan(sqrt(DoubleDouble(-1)).high));
  const DoubleDouble most(std::numeric_limits<double>::max());
  BOOST_TEST((most + most == huge));
  BOOST_TEST((most * DoubleDouble(-2) == -huge));
}

BOOST_AUTO_TEST_CASE(a_double_double_is_a_real) {
  const DoubleDouble third = DoubleDouble(1) / DoubleDouble(3);
  BOOST_TEST((exactly(real(third)).m == exactly(third).m));
}
