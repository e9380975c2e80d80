#pragma once

/// Error-free transformations: a sum or a product of two numbers as the number nearest to it and
/// all that is left. Rounding must be to nearest; where the result overflows, low is NaN.
namespace rayaudit {

template <class N>
struct Unrounded {
  N high, low;
};

/// a + b (Knuth, "The Art of Computer Programming" 2, sec. 4.2.2).
template <class N>
[[gnu::always_inline]] inline Unrounded<N> two_sum(N a, N b) {
  const N s = a + b;
  const N t = s - a;
  return {s, (a - (s - t)) + (b - t)};
}

/// a + b, where |a| >= |b| or a = 0 (Dekker, "A floating-point technique for extending the
/// available precision", Numer. Math. 18, 1971).
template <class N>
[[gnu::always_inline]] inline Unrounded<N> fast_two_sum(N a, N b) {
  const N s = a + b;
  return {s, b - (s - a)};
}

/// a b, unless low underflows. The fused multiplication is a call of the library where the
/// instruction is not known to be there.
[[gnu::always_inline]] inline Unrounded<double> two_product(double a, double b) {
  const double p = a * b;
  return {p, __builtin_fma(a, b, -p)};
}

/// The same in long double, by halves (Veltkamp and Dekker, ibid.).
[[gnu::always_inline]] inline Unrounded<long double> two_product(long double a, long double b) {
  constexpr long double split = 0x1p32L + 1;
  const long double p = a * b;
  const long double a_high = a * split - (a * split - a), a_low = a - a_high;
  const long double b_high = b * split - (b * split - b), b_low = b - b_high;
  return {p, a_low * b_low - (((p - a_high * b_high) - a_low * b_high) - a_high * b_low)};
}

}  // namespace rayaudit
