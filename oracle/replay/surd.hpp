#pragma once

#include <gmpxx.h>

#include <memory>
#include <string_view>
#include <vector>

#include "geometry/real.hpp"

namespace rayaudit::replay {

/// An operation that has no value: a division by 0, the root of a negative number, a NaN.
struct Undefined {
  std::string_view words;  ///< as "the root of a negative number"; outlives the exception
};

/// More work than a replay is worth.
struct GivenUp {};

/// An exact number with square roots, to run a routine in: a rational, or a + b sqrt(r), where a, b
/// and the radicand r have fewer roots. Every operation, sign and comparison is exact: the sign of
/// a + b sqrt(r) is that of a, of b, or of a^2 - b^2 r. An infinity, as a range may have, is held
/// too; it times 0 is 0.
///
/// The roots taken in a run are numbered in the thread that runs it; numbers of one run do not mix
/// with those of another.
class Surd {
 public:
  /// A run begins: no roots are known, no work is spent.
  static void begin();

  Surd() = default;
  explicit Surd(int x) : rational_(x) {}
  /// x must not be NaN: throws Undefined.
  explicit Surd(double x);

  friend Surd operator+(const Surd& a, const Surd& b);
  friend Surd operator-(const Surd& a, const Surd& b);
  friend Surd operator*(const Surd& a, const Surd& b);
  friend Surd operator/(const Surd& a, const Surd& b);
  friend Surd operator-(const Surd& a);
  friend Surd sqrt(const Surd& a);

  int sign() const;
  /// To 2^-150 of itself.
  Real value() const;

  friend bool operator==(const Surd& a, const Surd& b) { return compare(a, b) == 0; }
  friend bool operator<(const Surd& a, const Surd& b) { return compare(a, b) < 0; }
  friend bool operator>(const Surd& a, const Surd& b) { return compare(a, b) > 0; }
  friend bool operator<=(const Surd& a, const Surd& b) { return compare(a, b) <= 0; }
  friend bool operator>=(const Surd& a, const Surd& b) { return compare(a, b) >= 0; }

 private:
  struct Sum;  ///< a + b sqrt(r)

  explicit Surd(mpq_class x);
  /// a + b times the root of that level, b dropped where it is 0.
  static Surd with_root(const Surd& a, const Surd& b, int level);
  static int compare(const Surd& a, const Surd& b);
  static Surd infinity(int sign);

  bool is_plain_zero() const { return level_ == 0 && infinite_ == 0 && rational_ == 0; }
  Surd whole() const;     ///< the a of a + b sqrt(r)
  Surd factor() const;    ///< the b
  Surd radicand() const;  ///< the r
  Surd norm() const;      ///< a^2 - b^2 r
  Surd conjugate() const;
  mpf_class number() const;

  int level_ = 0;     ///< which root of the run it contains last, from 1; 0 for a rational
  int infinite_ = 0;  ///< the sign of an infinity, 0 for a number
  mpq_class rational_ = 0;
  std::shared_ptr<const Sum> sum_;
};

}  // namespace rayaudit::replay
