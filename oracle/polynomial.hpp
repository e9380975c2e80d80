#pragma once

#include <algorithm>
#include <array>

#include "geometry/vec3.hpp"

namespace rayaudit::oracle {

/// A polynomial in t over the number N, of a degree that the compiler knows: c[0] + c[1] t + ...
/// Degree 0 is a constant. A field called with these yields its restriction to the ray.
template <class N, int degree>
struct Polynomial {
  std::array<N, degree + 1> c;
};

template <class N>
[[gnu::always_inline]] inline N squared(const N& x) {
  return x * x;
}

template <class N>
[[gnu::always_inline]] inline N twice(const N& x) {
  return x + x;
}

template <class N, int A, int B>
[[gnu::always_inline]] inline Polynomial<N, std::max(A, B)> operator+(const Polynomial<N, A>& a,
                                                                      const Polynomial<N, B>& b) {
  Polynomial<N, std::max(A, B)> sum;
  for (int i = 0; i <= std::max(A, B); ++i)
    sum.c[i] = i > A ? b.c[i] : i > B ? a.c[i] : N(a.c[i] + b.c[i]);
  return sum;
}

template <class N, int A, int B>
[[gnu::always_inline]] inline Polynomial<N, std::max(A, B)> operator-(const Polynomial<N, A>& a,
                                                                      const Polynomial<N, B>& b) {
  Polynomial<N, std::max(A, B)> difference;
  for (int i = 0; i <= std::max(A, B); ++i)
    difference.c[i] = i > A ? N(-b.c[i]) : i > B ? a.c[i] : N(a.c[i] - b.c[i]);
  return difference;
}

template <class N, int A, int B>
[[gnu::always_inline]] inline Polynomial<N, A + B> operator*(const Polynomial<N, A>& a,
                                                             const Polynomial<N, B>& b) {
  Polynomial<N, A + B> product;
  for (int k = 0; k <= A + B; ++k) {
    const int first = std::max(0, k - B);
    N sum = a.c[first] * b.c[k - first];
    for (int i = first + 1; i <= std::min(k, A); ++i) sum = sum + a.c[i] * b.c[k - i];
    product.c[k] = sum;
  }
  return product;
}

template <class N>
[[gnu::always_inline]] inline Polynomial<N, 0> squared(const Polynomial<N, 0>& a) {
  return {{squared(a.c[0])}};
}

template <class N>
[[gnu::always_inline]] inline Polynomial<N, 2> squared(const Polynomial<N, 1>& a) {
  return {{squared(a.c[0]), twice(N(a.c[0] * a.c[1])), squared(a.c[1])}};
}

}  // namespace rayaudit::oracle
