#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "oracle/fused.hpp"
#include "oracle/integer.hpp"
#include "oracle/prepared.hpp"
#include "oracle/stages.hpp"

namespace rayaudit::oracle {
namespace {

/// The largest power of two that some numbers are whole multiples of, and how large they are.
class Unit {
 public:
  void see(double x) {
    // |x| = mantissa 2^exponent
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const int field = static_cast<int>(bits >> 52 & 0x7ff), exponent = std::max(field, 1) - 1075;
    const std::uint64_t mantissa = (bits & 0xf'ffff'ffff'ffff) | std::uint64_t{field != 0} << 52;
    const int last = exponent + std::countr_zero(mantissa | std::uint64_t{1} << 53);
    last_ = mantissa != 0 ? std::min(last_, last) : last_;
    end_ = mantissa != 0 ? std::max(end_, exponent + 53) : end_;
  }
  void see(const Vec3<double>& v) { see(v.x), see(v.y), see(v.z); }

  /// The unit is 2^exponent.
  int exponent() const { return last_; }
  /// |x| < 2^bits units for each of the numbers; 0 where there are none.
  int bits() const { return std::max(0, end_ - last_); }
  /// Are all far from the ends of double? Never where one is not finite.
  bool is_near_1() const { return bits() == 0 || (last_ > -200 && end_ < 200); }

 private:
  int last_ = 1 << 20, end_ = -(1 << 20);
};

/// A whole multiple of 2^exponent as the number that it is of them.
template <int bits>
Integer<bits> in_units(double x, int exponent) {
  const double whole = x * power_of_two(-exponent);
  if constexpr (bits < 64)
    return static_cast<std::int64_t>(whole);
  else
    return Integer<bits>::of(static_cast<Wide128>(whole));
}

/// What the numbers of a case are multiples of: its lengths, its direction, and a vector of its
/// shape.
struct Units {
  Unit length, direction, vector;

  Unit& of(Part kind) { return kind == Part::vector ? vector : length; }
  const Unit& of(Part kind) const { return kind == Part::vector ? vector : length; }
  int bits() const { return std::max({length.bits(), direction.bits(), vector.bits()}); }
  bool are_near_1() const {
    return length.is_near_1() && direction.is_near_1() && vector.is_near_1();
  }
  /// t counts in units of 2^t_exponent.
  int t_exponent() const { return length.exponent() - direction.exponent(); }
};

template <class S>
Units units_of(const Ray<double>& ray, const S& shape) {
  Units units;
  units.length.see(ray.origin);
  units.direction.see(ray.direction);
  each_part(shape, [&](Part kind, const auto& part) { units.of(kind).see(part); });
  return units;
}

/// Numbers of a case in their units.
template <int bits>
struct InUnits {
  using Number = Integer<bits>;

  static Number number(double x, const Unit& unit) { return in_units<bits>(x, unit.exponent()); }
  static Vec3<Number> number(const Vec3<double>& v, const Unit& unit) {
    return {number(v.x, unit), number(v.y, unit), number(v.z, unit)};
  }

  template <template <class> class S, std::size_t... i>
  static S<Number> shape(const S<double>& given, const Units& units, std::index_sequence<i...>) {
    const auto parts = given.parts();
    return S<Number>{number(std::get<i>(parts), units.of(S<double>::kinds[i]))...};
  }
};

/// An end of a range as a linear polynomial, slope t - end in units that make both whole.
template <int bits>
struct End {
  Integer<bits> end = 0, slope = 1;

  /// False where that takes more bits.
  bool set(double t, int t_exponent) {
    if (t == 0) return true;
    Unit own;
    own.see(t);
    const int common = std::min(own.exponent(), t_exponent);
    if (t_exponent - common >= bits || own.exponent() + own.bits() - common > bits) return false;
    end = in_units<bits>(t, common);
    slope = in_units<bits>(1, common - t_exponent);
    return true;
  }
};

/// The range of a ray, as settle asks for it.
template <int bits>
struct WholeRange {
  bool starts_at_zero, has_start, has_end;
  End<bits> start, end;
  bool fits = true;

  WholeRange(const Ray<double>& ray, int t_exponent)
      : starts_at_zero(ray.t_min == 0),
        has_start(ray.t_min > -std::numeric_limits<double>::infinity()),
        has_end(ray.t_max < std::numeric_limits<double>::infinity()) {
    if (has_start && !starts_at_zero) fits = start.set(ray.t_min, t_exponent);
    if (has_end) fits = fits && end.set(ray.t_max, t_exponent);
  }

  Polynomial<Integer<bits>, 1> above_start() const { return {{-start.end, start.slope}}; }
  Polynomial<Integer<bits>, 1> below_end() const { return {{end.end, -end.slope}}; }
};

struct SignsOfIntegers {
  static constexpr bool unsure = false;

  template <int bits>
  int operator()(const Integer<bits>& x) const {
    return x.sign();
  }
};

/// Large enough fields are made smaller, so that their discriminants stay doubles.
template <int bits>
constexpr int exponent_of_field = bits > 450 ? -bits / 2 : 0;

/// The operations of Known in lanes, with the errors proved there: 24 u^2 for a quotient, 6 u^2 for
/// a root, 4 u^2 for a sum of two of one sign.
[[gnu::always_inline]] inline Near operator-(const Near& a) { return {-a.high, -a.low}; }
[[gnu::always_inline]] inline Near twice(const Near& a) { return {2 * a.high, 2 * a.low}; }
[[gnu::always_inline]] inline Near operator/(const Near& a, const Near& b) {
  const double inverse = 1 / b.high, high = a.high * inverse;
  const double rest = __builtin_fma(-high, b.low, __builtin_fma(-high, b.high, a.high) + a.low);
  return fast_sum(high, rest * inverse);
}
[[gnu::always_inline]] inline Near sqrt(const Near& a) {
  const double high = std::sqrt(a.high);
  const double rest = __builtin_fma(-high, high, a.high) + a.low;
  return fast_sum(high, rest * (0.5 / high));
}
[[gnu::always_inline]] inline Near plus_alike(const Near& a, const Near& b) {
  const Bounded sum = double_word::two_sum(a.high, b.high);
  return fast_sum(sum.high, sum.low + (a.low + b.low));
}

/// More than the error of a root that these find: 8 u^2 for what they start from (4 for its root),
/// 6 and 4 for m, 24 for the quotient; 46 of 64.
constexpr double root_error = 0x1p-100;

/// Writes roots down, from the units of a case to what t counts in.
class RootWriter {
 public:
  [[gnu::always_inline]] RootWriter(int t_exponent, Values& values)
      : unit_(power_of_two(t_exponent)), values_(values) {}

  /// Those of an outline, each in its place.
  template <class S, class P>
  [[gnu::always_inline]] void write(const P& patch, const Outline& outline) {
    if constexpr (caps<S> == 0) {
      of_field(patch.field, outline.listed[0].which);
    } else {
      of_field(patch.field, outline.lateral);
      for (int i = 0; i < static_cast<int>(patch.side.size()); ++i)
        if (is_cap<S>(i)) of_linear(patch.side[i], 2 + i);
    }
  }
  /// Both ends of a stretch, where they are roots.
  template <class S, class P>
  [[gnu::always_inline]] void write(const P& patch, const Outline& outline,
                                    const Stretch& stretch) {
    Values ends;
    for (int i = 0; i < 2; ++i) {
      const StretchEnd& end = i == 0 ? stretch.first : stretch.last;
      if (end.side < 0) continue;
      if constexpr (caps<S> != 0) {
        if (outline.patch != 0)
          of_field(edge_of_cap(patch.field), end.which);
        else
          of_field(patch.side[end.side], end.which);
      } else if constexpr (std::tuple_size_v<decltype(patch.side)> != 0) {
        of_field(patch.side[end.side], end.which);
      }
      ends[i] = values_[end.which == Which::larger ? 1 : 0];
    }
    values_ = ends;
  }

 private:
  /// Of no known error where t is at the ends of double.
  [[gnu::always_inline]] void write(const Near& t, int place) {
    const double high = t.high * unit_, size = std::fabs(high);
    const bool roomy = (size > 0x1p-900 && size < 0x1p900) || t.high == 0;
    values_[place] = {high, t.low * unit_,
                      roomy ? size * root_error : std::numeric_limits<double>::infinity()};
  }
  template <int bits>
  [[gnu::always_inline]] void of_linear(const Polynomial<Integer<bits>, 1>& f, int place) {
    constexpr int exponent = exponent_of_field<bits>;
    write(-leading(f.c[0], exponent) / leading(f.c[1], exponent), place);
  }
  template <int bits>
  [[gnu::always_inline]] void of_field(const Polynomial<Integer<bits>, 1>& f, Which) {
    of_linear(f, 0);
  }
  template <int bits>
  [[gnu::always_inline]] void of_field(const Polynomial<Integer<bits>, 2>& f, Which first) {
    constexpr int exponent = exponent_of_field<bits>;
    if (first == Which::linear) return of_linear(Polynomial<Integer<bits>, 1>{f.c[0], f.c[1]}, 0);
    const Near b = leading(f.c[1], exponent), a = leading(f.c[2], exponent);
    if (first == Which::twofold) return write(-b / twice(a), 0);
    two(leading(f.c[0], exponent), b, a, leading(discriminant(f), 2 * exponent));
  }
  /// The roots of C + B t + A t^2, D > 0, as m / 2A and 2C / m with m = -(B + sign(B) sqrt(D)), of
  /// which none cancels.
  [[gnu::always_inline]] void two(const Near& c, const Near& b, const Near& a, const Near& d) {
    const Near root = sqrt(d);
    const bool positive = b.high >= 0;
    const Near m = -plus_alike(b, positive ? root : -root);
    const int place_by_a = positive == (a.high > 0) ? 0 : 1;
    write(m / twice(a), place_by_a);
    write(twice(c) / m, 1 - place_by_a);
  }

  double unit_;
  Values& values_;
};

template <int bits, template <class> class S>
bool settle_in(const Case& question, const S<double>& shape, const Units& units, bool all,
               InIntegers& found) {
  using In = InUnits<bits>;
  const Ray<double>& ray = question.ray;
  const WholeRange<bits> range(ray, units.t_exponent());
  if (!range.fits) return false;
  const auto patch =
      along_line(In::number(ray.origin, units.length), In::number(ray.direction, units.direction),
                 In::shape(shape, units, std::make_index_sequence<S<double>::kinds.size()>{}));
  const SignsOfIntegers sign;
  found.outline = settle<S<double>>(patch, range, sign, question.extent, all);
  const bool within = found.outline.within;
  found.constant = within || is_constant(patch.field, sign);
  if (within)
    found.stretch = stretch_of<S<double>>(patch, found.outline, range, sign, question.extent);
  if (within ? found.stretch.empty : found.outline.count == 0) return true;
  run_fused([&]() __attribute__((always_inline)) {
    RootWriter writer(units.t_exponent(), found.values);
    if (within)
      writer.write<S<double>>(patch, found.outline, found.stretch);
    else
      writer.write<S<double>>(patch, found.outline);
  });
  return true;
}

}  // namespace

bool settle_in_integers(const Case& question, int most_bits, bool all, InIntegers& found) {
  return std::visit(
      [&](const auto& shape) {
        const Units units = units_of(question.ray, shape);
        const int bits = units.bits();
        if (bits > most_bits || !units.are_near_1()) return false;
        return [&]<std::size_t... i>(std::index_sequence<i...>) {
          return ((bits <= widths_of_integers[i] &&
                   settle_in<widths_of_integers[i]>(question, shape, units, all, found)) ||
                  ...);
        }
        (std::make_index_sequence<widths_of_integers.size()>{});
      },
      question.shape);
}

}  // namespace rayaudit::oracle
