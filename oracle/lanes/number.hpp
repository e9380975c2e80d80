/// Numbers in lanes, compiled anew for each instruction set (no include guard of the usual kind).
/// The type of a number holds what is proved of its error; ARCHITECTURE.md, "The bound of the
/// lanes", has the proof, operation by operation.
#if defined(RAYAUDIT_ORACLE_LANES_NUMBER) == defined(HWY_TARGET_TOGGLE)
#ifdef RAYAUDIT_ORACLE_LANES_NUMBER
#undef RAYAUDIT_ORACLE_LANES_NUMBER
#else
#define RAYAUDIT_ORACLE_LANES_NUMBER
#endif

#include <hwy/highway.h>

#include <algorithm>

#include "oracle/fields.hpp"

HWY_BEFORE_NAMESPACE();
namespace rayaudit::oracle::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using Tag = hn::ScalableTag<double>;
using V = hn::Vec<Tag>;
using Mask = hn::Mask<Tag>;
inline constexpr std::size_t lanes = hn::MaxLanes(Tag());
inline constexpr double u = 0x1p-53;

/// a b + c, rounded once: also where there is no such instruction.
HWY_API V fused(const V& a, const V& b, const V& c) {
#if HWY_TARGET == HWY_EMU128 || HWY_TARGET == HWY_SCALAR
  HWY_ALIGN double x[lanes], y[lanes], z[lanes];
  hn::Store(a, Tag(), x), hn::Store(b, Tag(), y), hn::Store(c, Tag(), z);
  for (std::size_t i = 0; i < lanes; ++i) x[i] = __builtin_fma(x[i], y[i], z[i]);
  return hn::Load(Tag(), x);
#else
  return hn::MulAdd(a, b, c);
#endif
}
/// c - a b, rounded once.
HWY_API V fused_rest(const V& a, const V& b, const V& c) { return fused(hn::Neg(a), b, c); }

HWY_API V all(double x) { return hn::Set(Tag(), x); }

/// high + low.
struct Pair {
  V high, low;
};
HWY_API Pair two_sum(const V& a, const V& b) {
  const V s = hn::Add(a, b), t = hn::Sub(s, a);
  return {s, hn::Add(hn::Sub(a, hn::Sub(s, t)), hn::Sub(b, t))};
}
/// The same where |a| >= |b| or a = 0.
HWY_API Pair fast_two_sum(const V& a, const V& b) {
  const V s = hn::Add(a, b);
  return {s, hn::Sub(b, hn::Sub(s, a))};
}
HWY_API Pair two_product(const V& a, const V& b) {
  const V p = hn::Mul(a, b);
  return {p, fused(a, b, hn::Neg(p))};
}

/// What is known to be 0: a coefficient that a polynomial does not have.
struct Nothing {};

/// A number of the case, exactly.
struct Word {
  V high;
};

/// high + low, an approximation of a number x. magnitude is the expression of x with every minus a
/// plus, over the absolute values of what is exact in it. For w the low_bound and e the
/// error_bound, up to the factor 1 + 2^-40: |x| <= magnitude, |high| <= magnitude, |low| <= w u
/// magnitude, |high + low - x| <= e u^2 magnitude.
template <int low_bound, int error_bound>
struct Lane {
  static constexpr int w = low_bound, e = error_bound;
  static_assert(e < 1 << 11, "the proof leaves no room for more");
  V high, low, magnitude;

  Lane() = default;
  HWY_INLINE Lane(const V& h, const V& l, const V& m) : high(h), low(l), magnitude(m) {}
  /// What holds of less holds of more.
  template <int w2, int e2>
  requires(w2 <= w && e2 <= e) HWY_INLINE Lane(const Lane<w2, e2>& x)
      : high(x.high), low(x.low), magnitude(x.magnitude) {}
};

HWY_API Word operator-(const Word& a) { return {hn::Neg(a.high)}; }
template <int w, int e>
HWY_API Lane<w, e> operator-(const Lane<w, e>& a) {
  return {hn::Neg(a.high), hn::Neg(a.low), a.magnitude};
}

/// Exact: two words hold it.
HWY_API Lane<1, 0> operator+(const Word& a, const Word& b) {
  const Pair s = two_sum(a.high, b.high);
  return {s.high, s.low, hn::Abs(s.high)};
}
HWY_API Lane<1, 0> operator-(const Word& a, const Word& b) { return a + -b; }
template <int w, int e>
HWY_API Lane<w + 1, e + w + 1> operator+(const Word& a, const Lane<w, e>& b) {
  const Pair s = two_sum(a.high, b.high);
  return {s.high, hn::Add(b.low, s.low), hn::Add(hn::Abs(a.high), b.magnitude)};
}
template <int w, int e>
HWY_API auto operator+(const Lane<w, e>& a, const Word& b) {
  return b + a;
}
template <int w, int e>
HWY_API auto operator-(const Lane<w, e>& a, const Word& b) {
  return -b + a;
}
template <int w, int e>
HWY_API auto operator-(const Word& a, const Lane<w, e>& b) {
  return a + -b;
}
template <int w1, int e1, int w2, int e2>
HWY_API auto operator+(const Lane<w1, e1>& a, const Lane<w2, e2>& b) {
  constexpr int w = std::max(w1, w2), e = std::max(e1, e2);
  const Pair s = two_sum(a.high, b.high);
  return Lane<w + 1, e + 2 * w + 1>{s.high, hn::Add(hn::Add(a.low, b.low), s.low),
                                    hn::Add(a.magnitude, b.magnitude)};
}
template <int w1, int e1, int w2, int e2>
HWY_API auto operator-(const Lane<w1, e1>& a, const Lane<w2, e2>& b) {
  return a + -b;
}

/// Exact.
HWY_API Lane<1, 0> operator*(const Word& a, const Word& b) {
  const Pair p = two_product(a.high, b.high);
  return {p.high, p.low, hn::Abs(p.high)};
}
template <int w, int e>
HWY_API Lane<w + 1, e + w + 1> operator*(const Word& a, const Lane<w, e>& b) {
  const Pair p = two_product(a.high, b.high);
  return {p.high, fused(a.high, b.low, p.low), hn::Mul(hn::Abs(a.high), b.magnitude)};
}
template <int w, int e>
HWY_API auto operator*(const Lane<w, e>& a, const Word& b) {
  return b * a;
}
template <int w1, int e1, int w2, int e2>
HWY_API auto operator*(const Lane<w1, e1>& a, const Lane<w2, e2>& b) {
  const Pair p = two_product(a.high, b.high);
  return Lane<w1 + w2 + 1, e1 + e2 + w1 * w2 + 2 * w1 + w2 + 2>{
      p.high, fused(a.high, b.low, fused(a.low, b.high, p.low)), hn::Mul(a.magnitude, b.magnitude)};
}

HWY_API Lane<1, 0> squared(const Word& a) { return a * a; }
template <int w, int e>
HWY_API auto squared(const Lane<w, e>& a) {
  const Pair p = two_product(a.high, a.high);
  return Lane<2 * w + 1, 2 * e + w * w + 2 * w + 1>{
      p.high, fused(hn::Add(a.high, a.high), a.low, p.low), hn::Mul(a.magnitude, a.magnitude)};
}

/// Exact.
HWY_API Word twice(const Word& a) { return {hn::Add(a.high, a.high)}; }
template <int w, int e>
HWY_API Lane<w, e> twice(const Lane<w, e>& a) {
  return {hn::Add(a.high, a.high), hn::Add(a.low, a.low), hn::Add(a.magnitude, a.magnitude)};
}

/// A number of the case where three words are kept.
struct WideWord {
  V high;
};

/// high + middle + low, as Lane has two words: |middle| <= w1 u magnitude, |low| <= w2 u^2
/// magnitude, |high + middle + low - x| <= e u^3 magnitude.
template <int middle_bound, int low_bound, int error_bound>
struct Wide {
  static constexpr int w1 = middle_bound, w2 = low_bound, e = error_bound;
  static_assert(w2 < 1 << 11 && e < 1 << 20, "the proof leaves no room for more");
  V high, middle, low, magnitude;

  Wide() = default;
  HWY_INLINE Wide(const V& h, const V& m, const V& l, const V& size)
      : high(h), middle(m), low(l), magnitude(size) {}
  template <int v1, int v2, int e2>
  requires(v1 <= w1 && v2 <= w2 && e2 <= e) HWY_INLINE Wide(const Wide<v1, v2, e2>& x)
      : high(x.high), middle(x.middle), low(x.low), magnitude(x.magnitude) {}
};
using ExactWide = Wide<1, 0, 0>;

HWY_API WideWord operator-(const WideWord& a) { return {hn::Neg(a.high)}; }
template <int w1, int w2, int e>
HWY_API Wide<w1, w2, e> operator-(const Wide<w1, w2, e>& a) {
  return {hn::Neg(a.high), hn::Neg(a.middle), hn::Neg(a.low), a.magnitude};
}
HWY_API WideWord twice(const WideWord& a) { return {hn::Add(a.high, a.high)}; }
template <int w1, int w2, int e>
HWY_API Wide<w1, w2, e> twice(const Wide<w1, w2, e>& a) {
  return {hn::Add(a.high, a.high), hn::Add(a.middle, a.middle), hn::Add(a.low, a.low),
          hn::Add(a.magnitude, a.magnitude)};
}

HWY_API ExactWide operator+(const WideWord& a, const WideWord& b) {
  const Pair s = two_sum(a.high, b.high);
  return {s.high, s.low, hn::Zero(Tag()), hn::Abs(s.high)};
}
HWY_API ExactWide operator-(const WideWord& a, const WideWord& b) { return a + -b; }
template <int a1, int a2, int ea, int b1, int b2, int eb>
HWY_API auto operator+(const Wide<a1, a2, ea>& a, const Wide<b1, b2, eb>& b) {
  constexpr int w1 = std::max(a1, b1), w2 = std::max(a2, b2) + 2 * w1 + 1;
  const Pair s = two_sum(a.high, b.high), p = two_sum(a.middle, b.middle);
  const Pair q = two_sum(s.low, p.high);
  const V low = hn::Add(hn::Add(hn::Add(a.low, b.low), p.low), q.low);
  return Wide<w1 + 1, w2, std::max(ea, eb) + 3 * w2>{s.high, q.high, low,
                                                     hn::Add(a.magnitude, b.magnitude)};
}
template <int a1, int a2, int ea, int b1, int b2, int eb>
HWY_API auto operator-(const Wide<a1, a2, ea>& a, const Wide<b1, b2, eb>& b) {
  return a + -b;
}
template <int w1, int w2, int e>
HWY_API auto operator+(const WideWord& a, const Wide<w1, w2, e>& b) {
  return ExactWide{a.high, hn::Zero(Tag()), hn::Zero(Tag()), hn::Abs(a.high)} + b;
}
template <int w1, int w2, int e>
HWY_API auto operator+(const Wide<w1, w2, e>& a, const WideWord& b) {
  return b + a;
}
template <int w1, int w2, int e>
HWY_API auto operator-(const Wide<w1, w2, e>& a, const WideWord& b) {
  return -b + a;
}
template <int w1, int w2, int e>
HWY_API auto operator-(const WideWord& a, const Wide<w1, w2, e>& b) {
  return a + -b;
}

HWY_API ExactWide operator*(const WideWord& a, const WideWord& b) {
  const Pair p = two_product(a.high, b.high);
  return {p.high, p.low, hn::Zero(Tag()), hn::Abs(p.high)};
}
template <int w1, int w2, int e>
HWY_API auto operator*(const WideWord& a, const Wide<w1, w2, e>& b) {
  constexpr int w = w2 + 2 * w1 + 1;
  const Pair p = two_product(a.high, b.high), x = two_product(a.high, b.middle);
  const Pair s = two_sum(p.low, x.high);
  return Wide<w1 + 1, w, e + 2 * w1 + 1 + w>{p.high, s.high,
                                             fused(a.high, b.low, hn::Add(x.low, s.low)),
                                             hn::Mul(hn::Abs(a.high), b.magnitude)};
}
template <int w1, int w2, int e>
HWY_API auto operator*(const Wide<w1, w2, e>& a, const WideWord& b) {
  return b * a;
}
template <int a1, int a2, int ea, int b1, int b2, int eb>
HWY_API auto operator*(const Wide<a1, a2, ea>& a, const Wide<b1, b2, eb>& b) {
  constexpr int w1 = a1 + b1 + 1, w2 = a2 + b2 + a1 * b1 + a1 + b1 + (1 + b1) + w1;
  const Pair p = two_product(a.high, b.high);
  const Pair x = two_product(a.high, b.middle), y = two_product(a.middle, b.high);
  const Pair s = two_sum(p.low, x.high), t = two_sum(s.high, y.high);
  const V small = hn::Add(hn::Add(x.low, y.low), hn::Add(s.low, t.low));
  const V low = fused(a.high, b.low, fused(a.low, b.high, fused(a.middle, b.middle, small)));
  return Wide<w1, w2, ea + eb + a1 * b2 + a2 * b1 + 6 * w2 + 1>{p.high, t.high, low,
                                                                hn::Mul(a.magnitude, b.magnitude)};
}
HWY_API ExactWide squared(const WideWord& a) { return a * a; }
template <int w1, int w2, int e>
HWY_API auto squared(const Wide<w1, w2, e>& a) {
  return a * a;
}

HWY_API Nothing operator-(Nothing) { return {}; }
HWY_API Nothing operator+(Nothing, Nothing) { return {}; }
HWY_API Nothing operator-(Nothing, Nothing) { return {}; }
HWY_API Nothing operator*(Nothing, Nothing) { return {}; }
HWY_API Nothing squared(Nothing) { return {}; }
HWY_API Nothing twice(Nothing) { return {}; }
template <class A>
HWY_API A operator+(const A& a, Nothing) {
  return a;
}
template <class A>
HWY_API A operator+(Nothing, const A& a) {
  return a;
}
template <class A>
HWY_API A operator-(const A& a, Nothing) {
  return a;
}
template <class A>
HWY_API A operator-(Nothing, const A& a) {
  return -a;
}
template <class A>
HWY_API Nothing operator*(const A&, Nothing) {
  return {};
}
template <class A>
HWY_API Nothing operator*(Nothing, const A&) {
  return {};
}

/// A polynomial in t whose coefficients have each what is proved of it.
template <class C0, class C1 = Nothing, class C2 = Nothing>
struct Terms {
  C0 c0;
  [[no_unique_address]] C1 c1 = {};
  [[no_unique_address]] C2 c2 = {};

  template <class B0, class B1, class B2>
  HWY_INLINE operator Terms<B0, B1, B2>() const {
    return {c0, c1, c2};
  }
};
template <class C0, class C1, class C2>
Terms(C0, C1, C2) -> Terms<C0, C1, C2>;

template <class A0, class A1, class A2, class B0, class B1, class B2>
HWY_API auto operator+(const Terms<A0, A1, A2>& a, const Terms<B0, B1, B2>& b) {
  return Terms{a.c0 + b.c0, a.c1 + b.c1, a.c2 + b.c2};
}
template <class A0, class A1, class A2, class B0, class B1, class B2>
HWY_API auto operator-(const Terms<A0, A1, A2>& a, const Terms<B0, B1, B2>& b) {
  return Terms{a.c0 - b.c0, a.c1 - b.c1, a.c2 - b.c2};
}
template <class A0, class A1, class A2, class B0, class B1, class B2>
HWY_API auto operator*(const Terms<A0, A1, A2>& a, const Terms<B0, B1, B2>& b) {
  static_assert(std::is_same_v<decltype(a.c1 * b.c2 + a.c2 * b.c1), Nothing>);
  return Terms{a.c0 * b.c0, a.c0 * b.c1 + a.c1 * b.c0, a.c0 * b.c2 + a.c1 * b.c1 + a.c2 * b.c0};
}
template <class A0, class A1>
HWY_API auto squared(const Terms<A0, A1, Nothing>& a) {
  return Terms{squared(a.c0), twice(a.c0 * a.c1), squared(a.c1)};
}

/// A number with a bound of its own, as Bounded: the exact value lies within error of high + low,
/// and |low| <= u |high|.
struct Known {
  V high, low, error;
};

/// More than the few roundings of a bound, and than what u^2 and higher powers of 2^-40 add.
inline constexpr double upward = 1 + 0x1p-38;

template <int w, int e>
HWY_API V error_of(const Lane<w, e>& x) {
  return hn::Mul(x.magnitude, all(e * u * u * upward));
}
template <int w, int e>
HWY_API Known known(const Lane<w, e>& x) {
  const Pair sum = two_sum(x.high, x.low);
  return {sum.high, sum.low, error_of(x)};
}
template <int w1, int w2, int e>
HWY_API Known known(const Wide<w1, w2, e>& x) {
  const Pair a = two_sum(x.high, x.middle), b = two_sum(a.low, x.low);
  const Pair c = two_sum(a.high, b.high);
  const V low = hn::Add(c.low, b.low);
  const Pair sum = two_sum(c.high, low);
  const V error = hn::Add(hn::Mul(x.magnitude, all(e * u * u * u)), hn::Mul(hn::Abs(low), all(u)));
  return {sum.high, sum.low, hn::Mul(error, all(upward))};
}
HWY_API Known operator-(const Known& a) { return {hn::Neg(a.high), hn::Neg(a.low), a.error}; }
HWY_API Known twice(const Known& a) {
  return {hn::Add(a.high, a.high), hn::Add(a.low, a.low), hn::Add(a.error, a.error)};
}

/// A coefficient as a lane of two words; what they leave out.
template <int w, int e>
HWY_API Lane<w, e> lane_of(const Lane<w, e>& x) {
  return x;
}
HWY_API Lane<1, 0> lane_of(const Known& x) { return {x.high, x.low, hn::Abs(x.high)}; }
template <int w1, int w2, int e>
HWY_API Lane<1, 0> lane_of(const Wide<w1, w2, e>& x) {
  return lane_of(known(x));
}
template <int w, int e>
HWY_API V left_out(const Lane<w, e>&) {
  return hn::Zero(Tag());
}
template <int w1, int w2, int e>
HWY_API V left_out(const Wide<w1, w2, e>& x) {
  return known(x).error;
}

/// Is it at least four times its error away from 0?
HWY_API Mask is_clear(const Known& a) {
  return hn::Gt(hn::Abs(a.high), hn::Mul(all(4 * upward), a.error));
}

/// The root of a number that is clear and positive; else no bound holds.
HWY_API Known sqrt(const Known& a) {
  const V high = hn::Sqrt(a.high);
  const V inverse = hn::Div(all(1), high);
  const V rest = hn::Add(fused_rest(high, high, a.high), a.low);
  const Pair z = fast_two_sum(high, hn::Mul(rest, hn::Mul(all(0.5), inverse)));
  const V error = hn::Add(hn::Mul(a.error, inverse), hn::Mul(z.high, all(6 * u * u)));
  return {z.high, z.low, hn::Mul(error, all(upward))};
}

/// a + b of numbers of one sign.
HWY_API Known plus_alike(const Known& a, const Known& b) {
  const Pair s = two_sum(a.high, b.high);
  const Pair z = fast_two_sum(s.high, hn::Add(s.low, hn::Add(a.low, b.low)));
  const V error = hn::Add(hn::Add(a.error, b.error), hn::Mul(hn::Abs(z.high), all(4 * u * u)));
  return {z.high, z.low, hn::Mul(error, all(upward))};
}

/// a / b, b clear; else no bound holds.
HWY_API Known operator/(const Known& a, const Known& b) {
  const V inverse = hn::Div(all(1), b.high);
  const V high = hn::Mul(a.high, inverse);
  const V rest = fused_rest(high, b.low, hn::Add(fused_rest(high, b.high, a.high), a.low));
  const Pair z = fast_two_sum(high, hn::Mul(rest, inverse));
  const V size = hn::Abs(z.high);
  const V brought = hn::Mul(fused(size, b.error, a.error), hn::Abs(inverse));
  const V error = fused(brought, all(1.5), hn::Mul(size, all(24 * u * u)));
  return {z.high, z.low, hn::Mul(error, all(upward))};
}

/// Where a number is proved positive, and where negative.
struct Proof {
  Mask positive, negative;
};
HWY_API Proof proof(const V& x, const V& error) {
  return {hn::Gt(x, error), hn::Lt(x, hn::Neg(error))};
}
HWY_API Proof proof(const Known& x) { return proof(x.high, hn::Mul(x.error, all(upward))); }
/// Of a number that is uncertain by a further error.
template <int w, int e>
HWY_API Proof proof(const Lane<w, e>& x, const V& further) {
  const V value = hn::Add(x.high, x.low);
  const V rounding = hn::Mul(hn::Abs(value), all(2 * u));
  return proof(value, hn::Mul(hn::Add(hn::Add(error_of(x), rounding), further), all(upward)));
}

}  // namespace rayaudit::oracle::HWY_NAMESPACE

#define RAYAUDIT_LAW_NAMESPACE rayaudit::oracle::HWY_NAMESPACE
#include "oracle/law.hpp"
#undef RAYAUDIT_LAW_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
