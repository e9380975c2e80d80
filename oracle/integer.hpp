#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "oracle/bounded.hpp"
#include "oracle/polynomial.hpp"

namespace rayaudit::oracle {

__extension__ using Wide128 = __int128;
__extension__ using Natural128 = unsigned __int128;

/// A whole number, |x| < 2^bits, in two's complement. What comes of an operation has as many bits
/// as follows from those of its operands, which the compiler counts: nothing overflows, and no size
/// is looked at when the program runs.
template <int bits>
struct Integer {
  static constexpr int limbs = bits / 64 + 1;

  std::array<std::uint64_t, limbs> limb;

  Integer() = default;
  Integer(std::int64_t x) { widen<1>({static_cast<std::uint64_t>(x)}); }
  template <int fewer>
  requires(fewer < bits) Integer(const Integer<fewer>& x) { widen<Integer<fewer>::limbs>(x.limb); }

  static Integer of(Wide128 x) requires(limbs == 2) {
    Integer result;
    result.limb = {static_cast<std::uint64_t>(x), static_cast<std::uint64_t>(x >> 64)};
    return result;
  }

  bool is_negative() const { return static_cast<std::int64_t>(limb[limbs - 1]) < 0; }
  /// The limb at a place, which goes on beyond the last.
  std::uint64_t at(int i) const { return i < limbs ? limb[i] : beyond(limb[limbs - 1]); }

  int sign() const {
    if (is_negative()) return -1;
    std::uint64_t any = 0;
    for (int i = 0; i < limbs; ++i) any |= limb[i];
    return any != 0 ? 1 : 0;
  }

  friend Integer operator-(const Integer& x) {
    Integer negative;
    std::uint64_t carry = 1;
    for (int i = 0; i < limbs; ++i) {
      const Natural128 sum = Natural128{~x.limb[i]} + carry;
      negative.limb[i] = static_cast<std::uint64_t>(sum);
      carry = static_cast<std::uint64_t>(sum >> 64);
    }
    return negative;
  }

 private:
  static std::uint64_t beyond(std::uint64_t last) {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(last) >> 63);
  }
  template <int given>
  void widen(const std::array<std::uint64_t, given>& from) {
    for (int i = 0; i < limbs; ++i) limb[i] = i < given ? from[i] : beyond(from[given - 1]);
  }
};

template <int a, int b>
Integer<std::max(a, b) + 1> operator+(const Integer<a>& x, const Integer<b>& y) {
  Integer<std::max(a, b) + 1> sum;
  std::uint64_t carry = 0;
  for (int i = 0; i < sum.limbs; ++i) {
    const Natural128 digit = Natural128{x.at(i)} + y.at(i) + carry;
    sum.limb[i] = static_cast<std::uint64_t>(digit);
    carry = static_cast<std::uint64_t>(digit >> 64);
  }
  return sum;
}

template <int a, int b>
Integer<std::max(a, b) + 1> operator-(const Integer<a>& x, const Integer<b>& y) {
  Integer<std::max(a, b) + 1> difference;
  std::uint64_t carry = 1;
  for (int i = 0; i < difference.limbs; ++i) {
    const Natural128 digit = Natural128{x.at(i)} + ~y.at(i) + carry;
    difference.limb[i] = static_cast<std::uint64_t>(digit);
    carry = static_cast<std::uint64_t>(digit >> 64);
  }
  return difference;
}

/// The last limbs of x y, each factor taken as the natural number that its limbs make.
template <int n, int a, int b>
std::array<std::uint64_t, n> natural_product(const Integer<a>& x, const Integer<b>& y) {
  std::array<std::uint64_t, n> product = {};
  for (int i = 0; i < x.limbs; ++i) {
    std::uint64_t carry = 0;
    for (int j = 0; j < y.limbs && i + j < n; ++j) {
      const Natural128 digit = Natural128{x.limb[i]} * y.limb[j] + product[i + j] + carry;
      product[i + j] = static_cast<std::uint64_t>(digit);
      carry = static_cast<std::uint64_t>(digit >> 64);
    }
    if (i + y.limbs < n) product[i + y.limbs] = carry;
  }
  return product;
}

/// Takes 2^(64 x.limbs) y from a product where x is negative: that it was taken for too much.
template <int n, int a, int b>
void mend(std::array<std::uint64_t, n>& product, const Integer<a>& x, const Integer<b>& y) {
  const std::uint64_t all = x.is_negative() ? ~std::uint64_t{0} : 0;
  std::uint64_t carry = all & 1;
  for (int i = x.limbs; i < n; ++i) {
    const std::uint64_t digit = i - x.limbs < y.limbs ? y.limb[i - x.limbs] : 0;
    const Natural128 sum = Natural128{product[i]} + (~digit & all) + carry;
    product[i] = static_cast<std::uint64_t>(sum);
    carry = static_cast<std::uint64_t>(sum >> 64);
  }
}

template <int a, int b>
Integer<a + b> operator*(const Integer<a>& x, const Integer<b>& y) {
  using Product = Integer<a + b>;
  if constexpr (Product::limbs == 1) {
    return static_cast<std::int64_t>(x.limb[0] * y.limb[0]);
  } else if constexpr (Integer<a>::limbs == 1 && Integer<b>::limbs == 1) {
    return Product::of(Wide128{static_cast<std::int64_t>(x.limb[0])} *
                       static_cast<std::int64_t>(y.limb[0]));
  } else {
    Product product;
    product.limb = natural_product<Product::limbs>(x, y);
    mend<Product::limbs>(product.limb, x, y);
    mend<Product::limbs>(product.limb, y, x);
    return product;
  }
}

template <int bits>
Integer<2 * bits> squared(const Integer<bits>& x) {
  return x * x;
}
template <int bits>
Integer<bits + 1> twice(const Integer<bits>& x) {
  return x + x;
}

template <int a, int b>
struct Sum<Integer<a>, Integer<b>> {
  using type = Integer<std::max(a, b) + 1>;
};
template <int a, int b>
struct Product<Integer<a>, Integer<b>> {
  using type = Integer<a + b>;
};

/// high + low, |low| <= u |high|, within so many u^2 of a number, as its place says; u = 2^-53.
struct Near {
  double high = 0, low = 0;
};

[[gnu::always_inline]] inline Near fast_sum(double a, double b) {
  const Bounded sum = double_word::fast_two_sum(a, b);
  return {sum.high, sum.low};
}

/// The first 106 bits of x 2^exponent.
template <int bits>
[[gnu::always_inline]] inline Near leading_bits(const Integer<bits>& x, int exponent) {
  const bool negative = x.is_negative();
  const Integer<bits> size = negative ? -x : x;
  int last = size.limbs - 1;
  while (last > 0 && size.limb[last] == 0) --last;
  const std::uint64_t first = size.limb[last];
  if (first == 0) return {};
  const int room = std::countl_zero(first);
  const auto next = [&](int i) { return i >= 0 ? size.limb[i] : 0; };
  const auto shifted = [&](std::uint64_t high, std::uint64_t low) {
    return room == 0 ? high : high << room | low >> (64 - room);
  };
  const std::uint64_t high = shifted(first, next(last - 1));
  const std::uint64_t low = shifted(next(last - 1), next(last - 2));
  constexpr int kept = 11;  // bits of the first 64 that a double has no room for
  const double unit = (negative ? -1.0 : 1.0) * power_of_two(64 * last - room + exponent);
  const double top = static_cast<double>(high >> kept << kept) * unit;
  const std::uint64_t rest = high << (64 - kept) | low >> kept;
  const double bottom = static_cast<double>(rest >> kept << kept) * (unit * 0x1p-53);
  return fast_sum(top, bottom);
}

/// x 2^exponent to 8 u^2; the power must leave it well within the exponents of double. Short ones
/// are had exactly, by sums of parts that are doubles.
template <int bits>
[[gnu::always_inline]] inline Near leading(const Integer<bits>& x, int exponent) {
  if constexpr (bits > 96) {
    return leading_bits(x, exponent);
  } else if constexpr (bits <= 53) {
    return {static_cast<double>(static_cast<std::int64_t>(x.limb[0])) * power_of_two(exponent), 0};
  } else {
    const double unit = power_of_two(exponent);
    const double high = static_cast<double>(static_cast<std::int64_t>(x.at(1))) * 0x1p64;
    const double middle = static_cast<double>(x.limb[0] >> 32) * 0x1p32;
    const auto low = static_cast<double>(x.limb[0] & 0xffff'ffff);
    const Bounded s = double_word::two_sum(high, middle);
    const Near t = fast_sum(s.high, s.low + low);
    return {t.high * unit, t.low * unit};
  }
}

}  // namespace rayaudit::oracle
