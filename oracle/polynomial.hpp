#pragma once

#include <algorithm>
#include <array>
#include <type_traits>

#include "geometry/vec3.hpp"

namespace rayaudit::oracle {

/// The number that the sum, or the product, of an N and an M is: most numbers stay what they are.
template <class N, class M>
struct Sum {
  using type = N;
};
template <class N, class M>
struct Product {
  using type = N;
};
template <class N, class M>
using SumOf = typename Sum<N, M>::type;
template <class N, class M>
using ProductOf = typename Product<N, M>::type;

/// A polynomial in t over the number N, of a degree that the compiler knows: c[0] + c[1] t + ...
/// Degree 0 is a constant. A field called with these yields its restriction to the ray.
template <class N, int degree>
struct Polynomial {
  std::array<N, degree + 1> c;

  template <class M>
  requires(!std::is_same_v<M, N> && std::is_convertible_v<N, M>) operator Polynomial<M, degree>()
      const {
    Polynomial<M, degree> wider;
    for (int i = 0; i <= degree; ++i) wider.c[i] = c[i];
    return wider;
  }
};

template <class N>
[[gnu::always_inline]] inline N squared(const N& x) {
  return x * x;
}

template <class N>
[[gnu::always_inline]] inline N twice(const N& x) {
  return x + x;
}

template <class N, class M, int A, int B>
[[gnu::always_inline]] inline auto operator+(const Polynomial<N, A>& a, const Polynomial<M, B>& b) {
  using Term = SumOf<N, M>;
  Polynomial<Term, std::max(A, B)> sum;
  for (int i = 0; i <= std::max(A, B); ++i)
    sum.c[i] = i > A ? Term(b.c[i]) : i > B ? Term(a.c[i]) : Term(a.c[i] + b.c[i]);
  return sum;
}

template <class N, class M, int A, int B>
[[gnu::always_inline]] inline auto operator-(const Polynomial<N, A>& a, const Polynomial<M, B>& b) {
  using Term = SumOf<N, M>;
  Polynomial<Term, std::max(A, B)> difference;
  for (int i = 0; i <= std::max(A, B); ++i)
    difference.c[i] = i > A ? Term(-b.c[i]) : i > B ? Term(a.c[i]) : Term(a.c[i] - b.c[i]);
  return difference;
}

template <class N, class M, int A, int B>
[[gnu::always_inline]] inline auto operator*(const Polynomial<N, A>& a, const Polynomial<M, B>& b) {
  static_assert(std::min(A, B) <= 1, "a coefficient is a sum of two products at most");
  using One = ProductOf<N, M>;
  using Term = std::conditional_t<std::min(A, B) == 0, One, SumOf<One, One>>;
  Polynomial<Term, A + B> product;
  for (int k = 0; k <= A + B; ++k) {
    const int first = std::max(0, k - B), last = std::min(k, A);
    const One one = a.c[first] * b.c[k - first];
    if (first == last)
      product.c[k] = one;
    else if constexpr (std::min(A, B) == 1)
      product.c[k] = one + a.c[last] * b.c[k - last];
  }
  return product;
}

template <class N>
[[gnu::always_inline]] inline Polynomial<ProductOf<N, N>, 0> squared(const Polynomial<N, 0>& a) {
  return {{squared(a.c[0])}};
}

template <class N>
[[gnu::always_inline]] inline auto squared(const Polynomial<N, 1>& a) {
  using Square = ProductOf<N, N>;
  using Term = SumOf<Square, Square>;
  return Polynomial<Term, 2>{
      {Term(squared(a.c[0])), Term(twice(Square(a.c[0] * a.c[1]))), Term(squared(a.c[1]))}};
}

}  // namespace rayaudit::oracle
