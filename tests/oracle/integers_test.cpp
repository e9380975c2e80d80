#include <limits>
#include <random>

#include "oracle/integer.hpp"
#include "oracle/prepared.hpp"
#include "oracle/radical.hpp"
#include "oracle/stages.hpp"
#include "tests/families/drawn.hpp"
#include "tests/oracle/closed.hpp"
#include "tests/oracle/dyadic.hpp"

using namespace rayaudit;
using boost::multiprecision::cpp_int;
using oracle::ExactRoot;
using oracle::ExactRoots;
using oracle::InIntegers;
using oracle::Integer;
using oracle::Kind;
using oracle::Outlined;
using oracle::Standing;

namespace {

template <int bits>
cpp_int told(const Integer<bits>& x) {
  cpp_int sum = 0;
  for (int i = x.limbs - 1; i >= 0; --i) sum = (sum << 64) + x.limb[i];
  if (x.is_negative()) sum -= cpp_int(1) << 64 * x.limbs;
  return sum;
}

/// Numbers of so many bits: of any size, and often at the ends of what they may be.
template <int bits>
Integer<bits> drawn_integer(std::mt19937_64& random) {
  const auto ones = [](int count) {  // 2^count - 1
    Integer<bits> x = 0;
    for (int i = 0; i < count; ++i) x.limb[i / 64] |= std::uint64_t{1} << i % 64;
    return x;
  };
  const auto count = static_cast<int>(random() % (bits + 1));
  Integer<bits> x = ones(random() % 3 == 0 ? bits : count);
  if (random() % 2 == 0)
    for (std::uint64_t& limb : x.limb) limb &= random();
  return random() % 2 == 0 ? x : -x;
}

template <int bits>
bool is_what(const Integer<bits>& got, const cpp_int& exact) {
  return told(got) == exact && abs(exact) < cpp_int(1) << bits && got.sign() == exact.sign();
}

bool is_near(const oracle::Near& got, const cpp_int& exact, int exponent) {
  const Dyadic value = Dyadic(got.high) + Dyadic(got.low), x(exact, exponent);
  const bool is_short = std::fabs(got.low) <= 0x1p-53 * std::fabs(got.high);
  return is_short && times_power(size(value - x), 106 - 3) <= size(x);
}

template <int a, int b>
bool compute_alike(std::mt19937_64& random) {
  const Integer<a> x = drawn_integer<a>(random);
  const Integer<b> y = drawn_integer<b>(random);
  const cpp_int p = told(x), q = told(y);
  return is_what(x + y, p + q) && is_what(x - y, p - q) && is_what(x * y, p * q) &&
         is_what(y * x, p * q) && is_what(-x, -p) && is_what(twice(x), 2 * p) &&
         is_what(squared(x), p * p) && is_what(Integer<a + 70>(x), p) &&
         is_near(leading(x, -300), p, -300);
}

template <int a, int... b>
void require_alike(std::mt19937_64& random, std::integer_sequence<int, b...>) {
  for (std::size_t i = 0; i < 3'000 / one_in; ++i)
    BOOST_REQUIRE((compute_alike<a, b>(random) && ...));
}

using Widths = std::integer_sequence<int, 1, 18, 37, 59, 63, 64, 65, 118, 127, 128, 245, 368, 751>;

template <int... a>
void require_all_alike(std::mt19937_64& random, std::integer_sequence<int, a...>) {
  (require_alike<a>(random, Widths{}), ...);
}

}  // namespace

BOOST_AUTO_TEST_CASE(integers_compute_as_those_of_any_width_do) {
  std::mt19937_64 random(1);
  require_all_alike(random, Widths{});
}

namespace {

bool is_same(const Outlined& a, const Outlined& b) {
  return a.which == b.which && a.standing == b.standing && a.kind == b.kind && a.patch == b.patch;
}

/// Does a t with a bound lie that near to a root?
bool holds(const oracle::Bounded& t, const oracle::Radical& root, int exponent) {
  const Dyadic exact = exactly(oracle::value(root, 150));
  const Dyadic said = times_power(Dyadic(t.high) + Dyadic(t.low), exponent);
  const Dyadic error = times_power(Dyadic(t.error), exponent);
  return std::isfinite(t.error) && size(said - exact) <= error + times_power(size(exact), -149);
}

/// A case asked of integers: as it is, or with powers of two taken out.
struct Asked {
  oracle::Scaled scale;
  InIntegers found;
  bool settled;

  Asked(const Case& question, int most_bits)
      : scale(oracle::is_moderate(question) ? oracle::Scaled{question} : oracle::scaled(question)),
        settled(settle_in_integers(scale.question, most_bits, false, found)) {}

  bool agrees(const ExactRoots& to_first, const ExactRoots& all) const {
    const auto& [outline, constant, stretch, values] = found;
    if (constant != all.constant) return false;
    if (outline.within) return agrees_within(to_first);
    if (outline.count > all.count) return false;
    int crossings = 0;
    for (int i = 0; i < outline.count; ++i) {
      const Outlined& root = outline.listed[i];
      if (!is_same(root, all.listed[i].outlined)) return false;
      const bool is_end = root.kind == Kind::start || root.kind == Kind::end;
      if (!is_end && !holds(values[root.place()], all.listed[i].t, scale.t_exponent()))
        return false;
      if (root.standing == Standing::acceptable) ++crossings;
    }
    return crossings == to_first.count;
  }

 private:
  bool agrees_within(const ExactRoots& exact) const {
    const auto& [outline, constant, stretch, values] = found;
    if (stretch.empty) return exact.count == 0;
    if (exact.count != 1) return false;
    const ExactRoot& within = exact.listed[0];
    return within.outlined.kind == Kind::within && within.outlined.patch == outline.patch &&
           is_end(stretch.first, scale.question.ray.t_min, values[0], within.t) &&
           is_end(stretch.last, scale.question.ray.t_max, values[1], within.t_last);
  }
  bool is_end(const oracle::StretchEnd& end, double of_range, const oracle::Bounded& t,
              const oracle::Radical& exact) const {
    if (end.side >= 0) return holds(t, exact, scale.t_exponent());
    if (std::isinf(of_range)) return exact.infinite == (of_range < 0 ? -1 : 1);
    return exact.infinite == 0 && holds(oracle::Bounded(of_range), exact, scale.t_exponent());
  }
};

/// Ranges that begin or end at a crossing, or an ulp beside it.
std::vector<Case> with_ranges(std::vector<Case> cases) {
  std::size_t k = 0;
  for (Case& question : cases) {
    const oracle::Truth truth = oracle::truth(question);
    if (truth.count == 0 || !is_finite(truth.crossings()[0].t)) continue;
    const double infinity = std::numeric_limits<double>::infinity();
    double t = nearest<double>(truth.crossings()[0].t);
    if (k % 3 == 1) t = std::nextafter(t, infinity);
    if (k % 3 == 2) t = std::nextafter(t, -infinity);
    (k++ % 2 == 0 ? question.ray.t_min : question.ray.t_max) = t;
    if (!(question.ray.t_min < question.ray.t_max)) question.ray.t_min = -infinity;
  }
  return cases;
}

/// Cases of every family that are valid, of closed shapes too, with ranges and without ends.
template <class H>
void each_valid_case(H&& visit) {
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid") return;
    std::vector<Case> cases =
        closed_too(drawn(family, shape, format, {}, 5, 2 * chunk_cases / 5 / one_in));
    const std::vector<Case> ranged = with_ranges(cases);
    std::vector<Case> endless = cases;
    for (std::size_t i = 0; i < endless.size(); ++i)
      endless[i].extent = i % 2 == 0 ? Extent::unbounded : Extent::both_nappes;
    for (const std::vector<Case>& some : {cases, ranged, endless})
      require_each(family, shape, format, some, visit);
  });
}

}  // namespace

BOOST_AUTO_TEST_CASE(integers_of_each_width_find_what_exact_numbers_do) {
  std::array<std::size_t, 3> settled = {};
  constexpr std::array widths = oracle::widths_of_integers;
  std::size_t within = 0, all_cases = 0;
  each_valid_case([&](const Case& question) {
    ++all_cases;
    const ExactRoots to_first = oracle::exact_roots(question, false);
    const ExactRoots all = oracle::exact_roots(question, true);
    for (std::size_t i = 0; i < widths.size(); ++i) {
      const Asked asked(question, widths[i]);
      if (!asked.settled) continue;
      ++settled[i];
      within += asked.found.outline.within ? 1 : 0;
      if (!asked.agrees(to_first, all)) return false;
    }
    return true;
  });
  BOOST_TEST_MESSAGE("settled " << settled[0] << ", " << settled[1] << ", " << settled[2] << " of "
                                << all_cases << ", within " << within);
  BOOST_TEST(settled[0] * 100 > all_cases);
  BOOST_TEST(settled[1] * 2 > all_cases);
  BOOST_TEST(settled[2] > settled[1] + all_cases / 100);
  BOOST_TEST(within * 1'000 > all_cases);
}

BOOST_AUTO_TEST_CASE(all_roots_are_found_by_integers_as_by_exact_numbers) {
  each_valid_case([](const Case& question) {
    const oracle::Roots few = oracle::roots(question, 90), sharp = oracle::roots(question, 150);
    if (few.constant != sharp.constant || few.count != sharp.count) return false;
    for (int i = 0; i < few.count; ++i) {
      const oracle::Root &a = few.listed[i], &b = sharp.listed[i];
      if (a.standing != b.standing || a.kind != b.kind) return false;
      if (!agree(exactly(a.t), exactly(b.t), 89)) return false;
    }
    return true;
  });
}

BOOST_AUTO_TEST_CASE(what_does_not_fit_is_left_alone) {
  const auto settles = [](std::string_view line, int bits) {
    InIntegers found;
    return settle_in_integers(read_case_line(line).question, bits, false, found);
  };
  BOOST_TEST(settles("sphere 0 0 0 1 ray 0 1 -3 0 0 1", 18));
  BOOST_TEST(settles("sphere 0 0 0 131071 ray 0 1 -3 0 0 1", 18));
  BOOST_TEST(!settles("sphere 0 0 0 131071.125 ray 0 1 -3 0 0 1", 18));
  BOOST_TEST(settles("sphere 0 0 0 0.1 ray 0 0.1 -3 0 0 1.1", 59));
  BOOST_TEST(!settles("sphere 0 0 0 0.1 ray 0 1e-5 -3 0 0 1.1", 59));
  BOOST_TEST(settles("sphere 0 0 0 0.1 ray 0 1e-5 -3 0 0 1.1", 123));
  BOOST_TEST(!settles("sphere 0 0 0 0.1 ray 0 1e-30 -3 0 0 1.1", 123));
  // A range may take wider integers than the rest, up to the widest.
  BOOST_TEST(settles("sphere 0 0 0 1 ray 0 1 -3 0 0 1 range 0.5 inf", 18));
  BOOST_TEST(settles("sphere 0 0 0 1 ray 0 1 -3 0 0 1 range -inf 0", 18));
  BOOST_TEST(settles("sphere 0 0 0 1 ray 0 1 -3 0 0 1 range 1e-5 inf", 18));
  BOOST_TEST(!settles("sphere 0 0 0 1 ray 0 1 -3 0 0 1 range 1e-50 inf", 123));
  BOOST_TEST(!settles("sphere 0 0 0 1 ray 0 1 -3 0 0 1 range 0 1e60", 123));
  // What is far from 1, or not finite.
  BOOST_TEST(!settles("sphere 0 0 0 1e300 ray 0 1e300 0 0 0 1e300", 123));
  BOOST_TEST(!settles("sphere 0 0 0 1e-300 ray 0 1e-300 0 0 0 1", 123));
  Case question = read_case_line("sphere 0 0 0 1 ray 0 1 -3 0 0 1").question;
  InIntegers found;
  for (const double x :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    question.ray.origin.y = x;
    BOOST_TEST(!settle_in_integers(question, 123, false, found));
  }
}
