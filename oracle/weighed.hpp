#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <utility>

#include "oracle/dual.hpp"
#include "oracle/radical.hpp"

/// Numbers for derivatives whose sums must be trusted to two digits: beside its value, double-word
/// or exact, each carries how large the sum of its weighted slopes could be if nothing cancelled.
namespace rayaudit::oracle::weighed {

using Exact = CGAL::Mpzf;

/// For slopes that all but cancel: fifty digits.
using Fine = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

/// x + y sqrt(d), exactly; its derivatives are numbers of L, long doubles first, whose exponents no
/// field of ours leaves. Numbers with a root share one d. For spread see Word.
template <class L>
struct Surd {
  Exact x = 0, y = 0, d = 0;
  L spread = 0;

  Surd() = default;
  explicit Surd(double v) : x(v) {}
  Surd(Exact a, Exact b, Exact c, L s)
      : x(std::move(a)), y(std::move(b)), d(std::move(c)), spread(std::move(s)) {}

  const Exact& common_square(const Surd& b) const { return y.sign() != 0 ? d : b.d; }

  friend Surd operator-(const Surd& a) { return {-a.x, -a.y, a.d, a.spread}; }
  friend Surd operator+(const Surd& a, const Surd& b) {
    return {a.x + b.x, a.y + b.y, a.common_square(b), a.spread + b.spread};
  }
  friend Surd operator-(const Surd& a, const Surd& b) { return a + -b; }
  friend Surd operator*(const Surd& a, const Surd& b) {
    using std::fabs;
    const L both = fabs(leading(a)) * b.spread + fabs(leading(b)) * a.spread;
    if (a.y.sign() == 0 && b.y.sign() == 0) return {a.x * b.x, 0, 0, both};
    const Exact& root = a.common_square(b);
    return {a.x * b.x + a.y * b.y * root, a.x * b.y + a.y * b.x, root, both};
  }
};

/// Is x within the exponents of double, or 0?
inline bool fits_double(const Exact& x) {
  static const Exact most = 0x1p900, least = 0x1p-900;
  const int sign = x.sign();
  const Exact size = sign < 0 ? -x : x;
  return sign == 0 || (least < size && size < most);
}

/// To the bits of an L, which takes two doubles, or to 150.
template <class L>
L leading(const Surd<L>& a) {
  using std::ldexp;
  constexpr int parts = std::is_same_v<L, long double> ? 2 : 3;
  if (a.y.sign() == 0 && fits_double(a.x)) {
    L sum = a.x.to_double();
    Exact rest = a.x;
    for (int i = 1; i < parts; ++i) {
      rest = rest - Exact(rest.to_double());
      sum += rest.to_double();
    }
    return sum;
  }
  const Radical exactly = {.p = a.x, .d = a.y * a.y * a.d, .e = a.y.sign()};
  const Real t = value(exactly, 50 * parts);
  return ldexp(L(t.high) + L(t.middle) + L(t.low), t.exponent);
}
template <class L>
Surd<L> sqrt(const Surd<L>& a) {
  const Surd<L> root = {0, 1, a.x, 0};
  return {root.x, root.y, root.d, a.spread / (2 * leading(root))};
}

/// A double-word number for dual numbers that are not inlined; fused where the processor has fused
/// multiplications, which changes nothing but the speed. Beside it, more than the sum of its
/// slopes, each by its weight, could come to if nothing cancelled: a measure of what rounding does
/// to them.
template <bool fused>
struct Word {
  Bounded x;
  double spread = 0;

  Word() = default;
  explicit Word(double v) : x(v) {}
  Word(const Bounded& v, double s) : x(v), spread(s) {}

  friend Word operator-(const Word& a) { return {-a.x, a.spread}; }
  friend Word operator+(const Word& a, const Word& b) { return {a.x + b.x, a.spread + b.spread}; }
  friend Word operator-(const Word& a, const Word& b) { return {a.x - b.x, a.spread + b.spread}; }
  friend Word operator*(const Word& a, const Word& b) {
    return {a.x * b.x, std::fabs(a.x.high) * b.spread + std::fabs(b.x.high) * a.spread};
  }
};

template <bool fused>
double leading(const Word<fused>& a) {
  return a.x.high;
}
template <bool fused>
Word<fused> sqrt(const Word<fused>& a) {
  const Bounded root = sqrt(a.x);
  return {root, a.spread / (2 * root.high)};
}

/// Is a sum of slopes of a, each by its weight, known to two digits?
template <bool fused>
bool is_known_sum(double sum, const Word<fused>& a) {
  return sum >= a.spread * 0x1p-40 && sum <= std::numeric_limits<double>::max();
}
inline bool is_known_sum(long double sum, const Surd<long double>& a) {
  return sum >= a.spread * 0x1p-51L;
}
inline bool is_known_sum(const Fine&, const Surd<Fine>&) { return true; }

template <bool fused>
void set_weight(Word<fused>& a, double weight) {
  a.spread = weight;
}
template <class L>
void set_weight(Surd<L>& a, double weight) {
  a.spread = weight;
}

/// Is a known to two digits?
template <bool fused>
bool is_known(const Word<fused>& a) {
  return known_to(a.x, 0x1p-7);
}
template <class L>
bool is_known(const Surd<L>&) {
  return true;
}

}  // namespace rayaudit::oracle::weighed

namespace rayaudit::oracle {

template <class L>
struct SlopeOf<weighed::Surd<L>> {
  using type = L;
};
template <bool fused>
struct SlopeOf<weighed::Word<fused>> {
  using type = double;
};

}  // namespace rayaudit::oracle

namespace rayaudit::oracle::weighed {

/// The operations of dual numbers, called and not inlined: a field is a hundred of them, and each
/// is long beside a call.
#ifdef __x86_64__
template <std::size_t n>
[[gnu::noinline, gnu::target("avx2,fma")]] Dual<Word<true>, n> operator+(
    const Dual<Word<true>, n>& a, const Dual<Word<true>, n>& b) {
  return oracle::operator+<Word<true>, n>(a, b);
}
template <std::size_t n>
[[gnu::noinline, gnu::target("avx2,fma")]] Dual<Word<true>, n> operator-(
    const Dual<Word<true>, n>& a, const Dual<Word<true>, n>& b) {
  return oracle::operator-<Word<true>, n>(a, b);
}
template <std::size_t n>
[[gnu::noinline, gnu::target("avx2,fma")]] Dual<Word<true>, n> operator*(
    const Dual<Word<true>, n>& a, const Dual<Word<true>, n>& b) {
  return oracle::operator*<Word<true>, n>(a, b);
}
#endif
template <std::size_t n>
[[gnu::noinline]] Dual<Word<false>, n> operator+(const Dual<Word<false>, n>& a,
                                                 const Dual<Word<false>, n>& b) {
  return oracle::operator+<Word<false>, n>(a, b);
}
template <std::size_t n>
[[gnu::noinline]] Dual<Word<false>, n> operator-(const Dual<Word<false>, n>& a,
                                                 const Dual<Word<false>, n>& b) {
  return oracle::operator-<Word<false>, n>(a, b);
}
template <std::size_t n>
[[gnu::noinline]] Dual<Word<false>, n> operator*(const Dual<Word<false>, n>& a,
                                                 const Dual<Word<false>, n>& b) {
  return oracle::operator*<Word<false>, n>(a, b);
}

template <class L, std::size_t n>
[[gnu::noinline]] Dual<Surd<L>, n> operator+(const Dual<Surd<L>, n>& a, const Dual<Surd<L>, n>& b) {
  return oracle::operator+<Surd<L>, n>(a, b);
}
template <class L, std::size_t n>
[[gnu::noinline]] Dual<Surd<L>, n> operator-(const Dual<Surd<L>, n>& a, const Dual<Surd<L>, n>& b) {
  return oracle::operator-<Surd<L>, n>(a, b);
}
template <class L, std::size_t n>
[[gnu::noinline]] Dual<Surd<L>, n> operator*(const Dual<Surd<L>, n>& a, const Dual<Surd<L>, n>& b) {
  return oracle::operator*<Surd<L>, n>(a, b);
}

}  // namespace rayaudit::oracle::weighed
