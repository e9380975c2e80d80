#include "oracle/radical.hpp"

#include <CGAL/Gmpq.h>
#include <gmpxx.h>

#include <cmath>
#include <optional>
#include <utility>

#include "oracle/bounded.hpp"

namespace rayaudit::oracle {
namespace {

/// x as a double-word number, or nothing where its exponent is far from 0. Mpzf::to_double is off
/// by up to an ulp, never more, and says nothing of overflow.
std::optional<Bounded> bounded(const CGAL::Mpzf& x) {
  static const CGAL::Mpzf most = 0x1p450, least = 0x1p-450;
  if (x.sign() == 0) return Bounded(0);
  const CGAL::Mpzf size = x.sign() < 0 ? -x : x;
  if (most < size || size < least) return {};
  const double high = x.to_double();
  const double low = (x - CGAL::Mpzf(high)).to_double();
  const Bounded sum = double_word::fast_two_sum(high, low);
  return Bounded{sum.high, sum.low, std::fabs(sum.high) * 0x1p-103};
}

/// Do p and e sqrt(d) pull against one another?
bool cancels(const Radical& x) { return x.e != 0 && x.p.sign() == -x.e; }

/// p^2 - d = (p + e sqrt(d)) (p - e sqrt(d)).
CGAL::Mpzf norm(const Radical& x) { return CGAL::square(x.p) - x.d; }

bool is_zero(const Radical& x) {
  return x.e == 0 ? x.p.sign() == 0 : cancels(x) && norm(x).sign() == 0;
}

std::optional<Bounded> bounded(const Radical& x) {
  const auto p = bounded(x.p), d = bounded(x.d), q = bounded(x.q);
  if (!p || !d || !q) return {};
  if (x.e == 0) return *p / *q;
  const Bounded root = x.e > 0 ? sqrt(*d) : -sqrt(*d);
  if (!cancels(x)) return (*p + root) / *q;
  const auto n = bounded(norm(x));
  if (!n) return {};
  return *n / (*q * (*p - root));
}

/// |x| = (mantissa + rest) 2^exponent, 0 <= rest < 1, rest 0 where exact.
struct Digits {
  int sign;
  mpz_class mantissa;
  long exponent;
  bool exact;
};

/// A radical over the integers, with q > 0: (p + e sqrt(d)) / q.
struct IntegerRadical {
  mpz_class p, d, q;
  int e;
};

mpq_class rational(const CGAL::Mpzf& x) { return mpq_class(CGAL::Gmpq(x).mpq()); }

/// How often 2 divides the denominator, a power of two.
std::size_t halvings(const mpq_class& x) { return mpz_sizeinbase(x.get_den_mpz_t(), 2) - 1; }

mpz_class times_power(const mpq_class& x, std::size_t exponent) {
  return x.get_num() << (exponent - halvings(x));
}

IntegerRadical integers(const Radical& x) {
  const mpq_class p = rational(x.p), d = rational(x.d), q = rational(x.q);
  const std::size_t k = std::max({halvings(p), halvings(q), (halvings(d) + 1) / 2});
  IntegerRadical whole{times_power(p, k), times_power(d, 2 * k), times_power(q, k), x.e};
  if (whole.q < 0) whole = {-whole.p, whole.d, -whole.q, -whole.e};
  if (whole.e != 0 && mpz_perfect_square_p(whole.d.get_mpz_t()) != 0)
    whole = {whole.p + whole.e * sqrt(whole.d), 0, whole.q, 0};
  return whole;
}

int sign_of(const IntegerRadical& x) {
  const int sign_p = sgn(x.p);
  if (x.e == 0 || sign_p == x.e) return sign_p;
  if (sign_p == 0) return x.e;
  return x.p * x.p > x.d ? sign_p : x.e;  // never equal: d is no square here
}

/// At least this many bits of |x|, x != 0, rounded down.
Digits digits_of(IntegerRadical x, std::size_t bits) {
  const int sign = sign_of(x);
  if (sign < 0) x.p = -x.p, x.e = -x.e;
  const auto length = [](const mpz_class& n) { return mpz_sizeinbase(n.get_mpz_t(), 2); };
  for (std::size_t shift = 0;;) {
    // floor((p + e sqrt(d)) 2^shift): a root that is no integer lies strictly between two.
    mpz_class numerator = x.p << shift;
    if (x.e != 0) {
      const mpz_class root = sqrt(mpz_class(x.d << (2 * shift)));
      numerator += x.e > 0 ? root : mpz_class(-root - 1);
    }
    const std::size_t wanted = bits + length(x.q) + 1;
    if (numerator > 0 && length(numerator) >= wanted) {
      mpz_class quotient, rest;
      mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), numerator.get_mpz_t(), x.q.get_mpz_t());
      return {sign, quotient, -static_cast<long>(shift), x.e == 0 && rest == 0};
    }
    shift += numerator > 0 ? wanted - length(numerator) + 1 : wanted + length(x.p);
  }
}

/// A mantissa's leading bits as a Real of three parts, to 2^-155.
Real real(const Digits& digits) {
  const auto length = static_cast<long>(mpz_sizeinbase(digits.mantissa.get_mpz_t(), 2));
  const long dropped = std::max(0L, length - 159);
  mpz_class rest = digits.mantissa >> dropped;
  const auto take = [&] {
    const double part = rest.get_d();
    rest -= mpz_class(part);
    return digits.sign * std::ldexp(part, -159);
  };
  const double high = take(), middle = take(), low = take();
  return normal({high, middle, low, static_cast<int>(digits.exponent + dropped + 159)});
}

/// The digits of |x| rounded to nearest in N.
template <class N>
N rounded(const Digits& digits) {
  constexpr Format format = format_of<N>;
  const long length = static_cast<long>(mpz_sizeinbase(digits.mantissa.get_mpz_t(), 2));
  const long binade = length - 1 + digits.exponent;
  const long spacing = std::max<long>(binade, format.min_exponent) - (format.precision - 1);
  const long shift = spacing - digits.exponent;
  mpz_class kept = digits.mantissa >> shift;
  const mpz_class cut = digits.mantissa - (kept << shift);
  const mpz_class half = mpz_class(1) << (shift - 1);
  const int beside = cmp(cut, half);
  if (beside > 0 || (beside == 0 && (!digits.exact || mpz_odd_p(kept.get_mpz_t()) != 0))) ++kept;
  const bool carried = mpz_sizeinbase(kept.get_mpz_t(), 2) > std::size_t{format.precision};
  if (carried) kept >>= 1;
  const N size =
      std::ldexp(static_cast<N>(kept.get_ui()), static_cast<int>(spacing) + (carried ? 1 : 0));
  return digits.sign < 0 ? -size : size;
}

/// Takes the squares of small primes out of d: f^2 d' = d.
std::pair<mpz_class, mpz_class> without_squares(mpz_class d) {
  mpz_class factor = 1;
  for (unsigned long prime = 2; prime < 1000; ++prime)
    while (mpz_divisible_ui_p(d.get_mpz_t(), prime * prime) != 0)
      d /= prime * prime, factor *= prime;
  return {factor, d};
}

std::string in_words(const mpz_class& p, const mpz_class& f, int e, const mpz_class& d,
                     const mpz_class& q) {
  const std::string over = q == 1 ? "" : " / " + q.get_str();
  if (e == 0) return p.get_str() + over;
  const std::string root = (f == 1 ? "" : f.get_str() + " ") + "sqrt(" + d.get_str() + ")";
  if (p == 0) return (e < 0 ? "-" : "") + root + over;
  const std::string sum = p.get_str() + (e < 0 ? " - " : " + ") + root;
  return q == 1 ? sum : "(" + sum + ")" + over;
}

/// The closed form, where it is short enough to be read.
std::optional<std::string> closed_form(IntegerRadical x, int exponent) {
  constexpr std::size_t readable = 64;
  if (exponent > 0)
    x.p <<= exponent, x.d <<= 2UL * static_cast<unsigned long>(exponent);
  else
    x.q <<= static_cast<unsigned long>(-static_cast<long>(exponent));
  if (mpz_sizeinbase(x.d.get_mpz_t(), 10) > readable) return {};
  auto [f, d] = x.e == 0 ? std::pair<mpz_class, mpz_class>{0, 0} : without_squares(x.d);
  const mpz_class shared = gcd(gcd(x.p, f), x.q);
  x.p /= shared, x.q /= shared, f /= shared;
  std::string words = in_words(x.p, f, x.e, d, x.q);
  if (words.size() > readable) return {};
  return words;
}

/// 0.DIGITS 10^exponent as a decimal, with an exponent where the point would be far away.
std::string with_point(const std::string& digits, long exponent) {
  const auto size = static_cast<long>(digits.size());
  if (exponent > 40 || exponent < -4)
    return digits.substr(0, 1) + (size > 1 ? "." + digits.substr(1) : "") + "e" +
           std::to_string(exponent - 1);
  if (exponent <= 0) return "0." + std::string(-exponent, '0') + digits;
  if (exponent >= size) return digits + std::string(exponent - size, '0');
  return digits.substr(0, exponent) + "." + digits.substr(exponent);
}

double infinity_of(int sign) { return sign * std::numeric_limits<double>::infinity(); }

}  // namespace

Real value(const Radical& x, int bits) {
  if (x.infinite != 0) return rayaudit::real(infinity_of(x.infinite));
  if (is_zero(x)) return {};
  if (const auto quick = bounded(x); quick && known_to(*quick, std::ldexp(1.0, -bits)))
    return {quick->high, quick->low, 0, x.exponent};
  Real t = real(digits_of(integers(x), 160));
  t.exponent += x.exponent;
  return t;
}

template <class N>
N nearest(const Radical& x) {
  if (x.infinite != 0) return static_cast<N>(infinity_of(x.infinite));
  if (is_zero(x)) return 0;
  Digits digits = digits_of(integers(x), 160);
  digits.exponent += x.exponent;
  return rounded<N>(digits);
}
template float nearest(const Radical&);
template double nearest(const Radical&);
template long double nearest(const Radical&);

Spelled spelled(const Radical& x, int digits) {
  if (x.infinite != 0) return {{}, x.infinite < 0 ? "-inf" : "inf", true};
  if (is_zero(x)) return {"0", "0", true};
  const IntegerRadical whole = integers(x);
  const auto bits = 4 * static_cast<std::size_t>(digits) + 64;
  Digits leading = digits_of(whole, bits);
  leading.exponent += x.exponent;
  const std::size_t size = mpz_sizeinbase(leading.mantissa.get_mpz_t(), 2);
  mpf_class number(leading.mantissa, size + 64);
  if (leading.exponent < 0)
    number >>= static_cast<unsigned long>(-leading.exponent);
  else
    number <<= static_cast<unsigned long>(leading.exponent);
  mp_exp_t point = 0;
  const std::string all = number.get_str(point);
  const bool terminates = leading.exact && all.size() <= static_cast<std::size_t>(digits);
  const std::string decimals = number.get_str(point, 10, static_cast<std::size_t>(digits));
  return {closed_form(whole, x.exponent),
          (leading.sign < 0 ? "-" : "") + with_point(decimals, point), terminates};
}

}  // namespace rayaudit::oracle
