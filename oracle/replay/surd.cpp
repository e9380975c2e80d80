#include "oracle/replay/surd.hpp"

#include <CGAL/Gmpq.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rayaudit::replay {

struct Surd::Sum {
  Surd whole, factor;
};

namespace {

/// Roots within roots square the work; no sound routine needs more than three.
constexpr int most_roots = 5;
/// Operations on rationals that one run may have, and bits that one of them may: some tens of
/// milliseconds.
constexpr int most_work = 20'000;
constexpr int most_bits = 200'000;
/// Bits of a value told: 150 and more than the few operations of its evaluation lose.
constexpr mp_bitcnt_t value_bits = 256;

thread_local std::vector<Surd> radicands;
thread_local int work = 0;

void spend(int bits) {
  if (++work > most_work || bits > most_bits) throw GivenUp{};
}

mpq_class rational(const CGAL::Mpzf& x) { return mpq_class(CGAL::Gmpq(x).mpq()); }

mpf_class in_digits(const CGAL::Mpzf& x) {
  const mpq_class plain = rational(x);
  mpf_class quotient(plain.get_num(), value_bits);
  quotient /= mpf_class(plain.get_den(), value_bits);
  return quotient;
}

/// 1 / x where x is a power of two with an inverse among the doubles, else nothing.
std::optional<double> inverse_power_of_two(const CGAL::Mpzf& x) {
  const double near = x.to_double();
  int exponent = 0;
  if (std::frexp(near, &exponent) != 0.5 || !std::isnormal(1 / near) || x != CGAL::Mpzf(near))
    return {};
  return 1 / near;
}

}  // namespace

void Surd::begin() {
  radicands.clear();
  work = 0;
}

Surd::Surd(double x) {
  if (std::isnan(x)) throw Undefined{"NaN"};
  if (std::isinf(x))
    infinite_ = x > 0 ? 1 : -1;
  else
    rational_ = {.over = x, .bits = 53};
}

Surd::Surd(Fraction x) : rational_(std::move(x)) {}

Surd::Fraction Surd::sum(const Fraction& a, const Fraction& b) {
  if (!a.divided && !b.divided) {
    const int bits = std::max(a.bits, b.bits) + 1;
    spend(bits);
    return {.over = a.over + b.over, .bits = bits};
  }
  const int bits = a.bits + b.bits + 1;
  spend(bits);
  if (a.divided == b.divided && a.under == b.under)
    return {a.over + b.over, a.under, true, std::max(a.bits, b.bits) + 1};
  return {a.over * b.under + b.over * a.under, a.under * b.under, true, bits};
}

Surd::Fraction Surd::product(const Fraction& a, const Fraction& b) {
  const int bits = a.bits + b.bits;
  spend(bits);
  if (!a.divided && !b.divided) return {.over = a.over * b.over, .bits = bits};
  return {a.over * b.over, a.under * b.under, true, bits};
}

Surd::Fraction Surd::quotient(const Fraction& a, const Fraction& b) {
  const int bits = a.bits + b.bits;
  spend(bits);
  if (!b.divided)
    if (const auto inverse = inverse_power_of_two(b.over))
      return {a.over * CGAL::Mpzf(*inverse), a.under, a.divided, a.bits};
  const CGAL::Mpzf under = a.under * b.over, over = a.over * b.under;
  if (under.sign() < 0) return {-over, -under, true, bits};
  return {over, under, true, bits};
}

/// sqrt(p / q) = sqrt(p q) / q, where that is rational.
std::optional<Surd::Fraction> Surd::root(const Fraction& x) {
  const mpq_class squared = rational(x.over * x.under);
  const mpz_class &over = squared.get_num(), &under = squared.get_den();
  if (mpz_perfect_square_p(over.get_mpz_t()) == 0 || mpz_perfect_square_p(under.get_mpz_t()) == 0)
    return {};
  const auto number = [](const mpz_class& square) {
    return CGAL::Mpzf(CGAL::Gmpz(mpz_class(sqrt(square)).get_mpz_t()));
  };
  const Fraction root = {.over = number(over), .bits = x.bits};
  return quotient(quotient(root, {.over = number(under), .bits = x.bits}),
                  {.over = x.under, .bits = x.bits});
}

Surd Surd::infinity(int sign) {
  Surd x;
  x.infinite_ = sign;
  return x;
}

Surd Surd::with_root(const Surd& a, const Surd& b, int level) {
  if (b.is_plain_zero()) return a;
  Surd x;
  x.level_ = level;
  x.sum_ = std::make_shared<const Sum>(Sum{a, b});
  return x;
}

Surd Surd::whole() const { return sum_->whole; }
Surd Surd::factor() const { return sum_->factor; }
Surd Surd::radicand() const { return radicands[level_ - 1]; }
Surd Surd::conjugate() const { return with_root(whole(), -factor(), level_); }
Surd Surd::norm() const { return whole() * whole() - factor() * factor() * radicand(); }

Surd operator+(const Surd& a, const Surd& b) {
  if (a.infinite_ != 0 || b.infinite_ != 0) {
    if (a.infinite_ == -b.infinite_) throw Undefined{"infinity less infinity"};
    return Surd::infinity(a.infinite_ != 0 ? a.infinite_ : b.infinite_);
  }
  if (a.level_ < b.level_) return b + a;
  if (a.level_ == 0) return Surd(Surd::sum(a.rational_, b.rational_));
  if (b.level_ < a.level_) return Surd::with_root(a.whole() + b, a.factor(), a.level_);
  return Surd::with_root(a.whole() + b.whole(), a.factor() + b.factor(), a.level_);
}

Surd operator-(const Surd& a) {
  if (a.infinite_ != 0) return Surd::infinity(-a.infinite_);
  if (a.level_ == 0) {
    Surd negative = a;
    negative.rational_.over = -a.rational_.over;
    return negative;
  }
  return Surd::with_root(-a.whole(), -a.factor(), a.level_);
}

Surd operator-(const Surd& a, const Surd& b) { return a + -b; }

Surd operator*(const Surd& a, const Surd& b) {
  if (a.infinite_ != 0 || b.infinite_ != 0) {
    const int sign = a.sign() * b.sign();
    return sign == 0 ? Surd() : Surd::infinity(sign);
  }
  if (a.level_ < b.level_) return b * a;
  if (a.level_ == 0) return Surd(Surd::product(a.rational_, b.rational_));
  if (b.level_ < a.level_) return Surd::with_root(a.whole() * b, a.factor() * b, a.level_);
  return Surd::with_root(a.whole() * b.whole() + a.factor() * b.factor() * a.radicand(),
                         a.whole() * b.factor() + a.factor() * b.whole(), a.level_);
}

Surd operator/(const Surd& a, const Surd& b) {
  if (b.sign() == 0) throw Undefined{"a division by 0"};
  if (b.infinite_ != 0) {
    if (a.infinite_ != 0) throw Undefined{"infinity by infinity"};
    return Surd();
  }
  if (a.infinite_ != 0) return Surd::infinity(a.infinite_ * b.sign());
  if (b.level_ > 0) {
    // Where the norm is 0 and b is not, the conjugate is: the two terms of b are equal.
    const Surd norm = b.norm();
    if (norm.sign() == 0) return a / (Surd(2) * b.whole());
    return a * b.conjugate() / norm;
  }
  if (a.level_ > 0) return Surd::with_root(a.whole() / b, a.factor() / b, a.level_);
  return Surd(Surd::quotient(a.rational_, b.rational_));
}

Surd sqrt(const Surd& a) {
  const int sign = a.sign();
  if (sign < 0) throw Undefined{"the root of a negative number"};
  if (sign == 0 || a.infinite_ != 0) return a.infinite_ != 0 ? a : Surd();
  if (a.level_ == 0)
    if (const auto root = Surd::root(a.rational_)) return Surd(*root);
  for (std::size_t i = 0; i < radicands.size(); ++i) {
    const Surd& known = radicands[i];
    if (known.level_ != a.level_) continue;
    const auto level = static_cast<int>(i) + 1;
    if (a.level_ == 0)
      if (const auto root = Surd::root(Surd::quotient(a.rational_, known.rational_)))
        return Surd::with_root(Surd(), Surd(*root), level);
    if (a.level_ > 0 && a == known) return Surd::with_root(Surd(), Surd(1), level);
  }
  if (radicands.size() == most_roots) throw GivenUp{};
  radicands.push_back(a);
  return Surd::with_root(Surd(), Surd(1), static_cast<int>(radicands.size()));
}

int Surd::sign() const {
  if (infinite_ != 0) return infinite_;
  if (level_ == 0) return rational_.over.sign();
  const int whole_sign = whole().sign(), root_sign = factor().sign();
  if (whole_sign == 0 || whole_sign == root_sign) return root_sign;
  if (root_sign == 0) return whole_sign;
  return whole_sign * norm().sign();
}

int Surd::compare(const Surd& a, const Surd& b) {
  if (a.infinite_ != 0 || b.infinite_ != 0)
    return (a.infinite_ > b.infinite_) - (a.infinite_ < b.infinite_);
  return (a - b).sign();
}

/// Of two terms that cancel, x = norm / conjugate, in which nothing does.
mpf_class Surd::number() const {
  if (level_ == 0)
    return mpf_class(in_digits(rational_.over) / in_digits(rational_.under), value_bits);
  const int whole_sign = whole().sign(), root_sign = factor().sign();
  if (whole_sign * root_sign < 0) {
    const Surd top = norm();
    if (top.sign() == 0) return mpf_class(0, value_bits);
    return mpf_class(top.number() / conjugate().number(), value_bits);
  }
  mpf_class root(radicand().number(), value_bits);
  root = mpf_class(::sqrt(root) * factor().number(), value_bits);
  return mpf_class(whole().number() + root, value_bits);
}

Real Surd::value() const {
  if (infinite_ != 0) return {infinite_ * std::numeric_limits<double>::infinity(), 0, 0, 0};
  mpf_class rest = number();
  if (sgn(rest) == 0) return {};
  long exponent = 0;
  (void)mpf_get_d_2exp(&exponent, rest.get_mpf_t());
  if (exponent > 0)
    rest >>= static_cast<mp_bitcnt_t>(exponent);
  else
    rest <<= static_cast<mp_bitcnt_t>(-exponent);
  Real x{.exponent = static_cast<int>(exponent)};
  x.high = rest.get_d(), rest -= x.high;
  x.middle = rest.get_d(), rest -= x.middle;
  x.low = rest.get_d();
  return normal(x);
}

}  // namespace rayaudit::replay
