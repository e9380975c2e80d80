#include "oracle/replay/surd.hpp"

#include <cmath>
#include <limits>

namespace rayaudit::replay {

struct Surd::Sum {
  Surd whole, factor;
};

namespace {

/// Roots within roots square the work; no sound routine needs more than three.
constexpr int most_roots = 5;
/// Limbs that the operations of one run may have among them: some tens of milliseconds.
constexpr std::size_t most_work = 2'000'000;
/// Bits of a value told: 150 and more than the few operations of its evaluation lose.
constexpr mp_bitcnt_t value_bits = 256;

thread_local std::vector<Surd> radicands;
thread_local std::size_t work = 0;

std::size_t limbs(const mpq_class& x) {
  return mpz_size(x.get_num_mpz_t()) + mpz_size(x.get_den_mpz_t());
}

void spend(const mpq_class& a, const mpq_class& b) {
  work += 4 + limbs(a) + limbs(b);
  if (work > most_work) throw GivenUp{};
}

/// The root of a rational that is a square, else nothing.
bool is_square(const mpq_class& x, mpq_class& root) {
  if (mpz_perfect_square_p(x.get_num_mpz_t()) == 0 || mpz_perfect_square_p(x.get_den_mpz_t()) == 0)
    return false;
  root = mpq_class(sqrt(x.get_num()), sqrt(x.get_den()));
  return true;
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
    rational_ = x;
}

Surd::Surd(mpq_class x) : rational_(std::move(x)) {}

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
  if (a.level_ == 0) {
    spend(a.rational_, b.rational_);
    return Surd(mpq_class(a.rational_ + b.rational_));
  }
  if (b.level_ < a.level_) return Surd::with_root(a.whole() + b, a.factor(), a.level_);
  return Surd::with_root(a.whole() + b.whole(), a.factor() + b.factor(), a.level_);
}

Surd operator-(const Surd& a) {
  if (a.infinite_ != 0) return Surd::infinity(-a.infinite_);
  if (a.level_ == 0) return Surd(mpq_class(-a.rational_));
  return Surd::with_root(-a.whole(), -a.factor(), a.level_);
}

Surd operator-(const Surd& a, const Surd& b) { return a + -b; }

Surd operator*(const Surd& a, const Surd& b) {
  if (a.infinite_ != 0 || b.infinite_ != 0) {
    const int sign = a.sign() * b.sign();
    return sign == 0 ? Surd() : Surd::infinity(sign);
  }
  if (a.level_ < b.level_) return b * a;
  if (a.level_ == 0) {
    spend(a.rational_, b.rational_);
    return Surd(mpq_class(a.rational_ * b.rational_));
  }
  if (b.level_ < a.level_) return Surd::with_root(a.whole() * b, a.factor() * b, a.level_);
  return Surd::with_root(a.whole() * b.whole() + a.factor() * b.factor() * a.radicand(),
                         a.whole() * b.factor() + a.factor() * b.whole(), a.level_);
}

Surd operator/(const Surd& a, const Surd& b) {
  if (b.sign() == 0) throw Undefined{"a division by 0"};
  if (b.infinite_ != 0) {
    if (a.infinite_ != 0) throw Undefined{"infinity by infinity"};
    return {};
  }
  if (a.infinite_ != 0) return Surd::infinity(a.infinite_ * b.sign());
  if (b.level_ > 0) {
    // Where the norm is 0 and b is not, the conjugate is: the two terms of b are equal.
    const Surd norm = b.norm();
    if (norm.sign() == 0) return a / (Surd(2) * b.whole());
    return a * b.conjugate() / norm;
  }
  if (a.level_ > 0) return Surd::with_root(a.whole() / b, a.factor() / b, a.level_);
  spend(a.rational_, b.rational_);
  return Surd(mpq_class(a.rational_ / b.rational_));
}

Surd sqrt(const Surd& a) {
  const int sign = a.sign();
  if (sign < 0) throw Undefined{"the root of a negative number"};
  if (sign == 0 || a.infinite_ != 0) return a.infinite_ != 0 ? a : Surd();
  mpq_class root;
  if (a.level_ == 0 && is_square(a.rational_, root)) return Surd(root);
  for (std::size_t i = 0; i < radicands.size(); ++i) {
    const Surd& known = radicands[i];
    if (known.level_ != a.level_) continue;
    const auto level = static_cast<int>(i) + 1;
    if (a.level_ == 0 && is_square(mpq_class(a.rational_ / known.rational_), root))
      return Surd::with_root(Surd(), Surd(root), level);
    if (a.level_ > 0 && a == known) return Surd::with_root(Surd(), Surd(1), level);
  }
  if (radicands.size() == most_roots) throw GivenUp{};
  radicands.push_back(a);
  return Surd::with_root(Surd(), Surd(1), static_cast<int>(radicands.size()));
}

int Surd::sign() const {
  if (infinite_ != 0) return infinite_;
  if (level_ == 0) return sgn(rational_);
  const int whole_sign = whole().sign(), root_sign = factor().sign();
  if (whole_sign == 0 || whole_sign == root_sign) return root_sign;
  if (root_sign == 0) return whole_sign;
  return whole_sign * norm().sign();
}

int Surd::compare(const Surd& a, const Surd& b) {
  if (a.infinite_ != 0 || b.infinite_ != 0)
    return (a.infinite_ > b.infinite_) - (a.infinite_ < b.infinite_);
  if (a.level_ == 0 && b.level_ == 0) return cmp(a.rational_, b.rational_);
  return (a - b).sign();
}

/// Of two terms that cancel, x = norm / conjugate, in which nothing does.
mpf_class Surd::number() const {
  if (level_ == 0) {
    mpf_class quotient(rational_.get_num(), value_bits);
    quotient /= mpf_class(rational_.get_den(), value_bits);
    return quotient;
  }
  const int whole_sign = whole().sign(), root_sign = factor().sign();
  if (whole_sign * root_sign < 0) {
    const Surd top = norm();
    if (top.sign() == 0) return {0, value_bits};
    return {top.number() / conjugate().number(), value_bits};
  }
  mpf_class root(radicand().number(), value_bits);
  root = mpf_class(::sqrt(root) * factor().number(), value_bits);
  return {whole().number() + root, value_bits};
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
