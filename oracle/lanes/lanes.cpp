#include "oracle/lanes/lanes.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <type_traits>

#include "oracle/fields.hpp"

// One text for each of these; of the others Highway has none differs in anything but speed.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_SSE4 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "oracle/lanes/lanes.cpp"
#include <hwy/foreach_target.h>
// after it
#include <hwy/highway.h>

#include "oracle/lanes/number.hpp"

// Of lambdas, which do not take on the instruction set of what they are written in.
#undef INLINED
#define INLINED __attribute__((always_inline)) HWY_ATTR

HWY_BEFORE_NAMESPACE();
namespace rayaudit::oracle::HWY_NAMESPACE {
namespace {

/// Of two neighbouring numbers of each case, from byte `at` of it on: a vector of the first ones
/// and one of the second.
template <class D>
HWY_API void pairs(D, const Case* const* cases, std::size_t at, hn::Vec<D>& first,
                   hn::Vec<D>& second) {
  const auto number = [&](std::size_t i) INLINED {
    return reinterpret_cast<const double*>(reinterpret_cast<const char*>(cases[i]) + at);
  };
#if HWY_TARGET == HWY_SCALAR
  first = hn::LoadU(D(), number(0)), second = hn::LoadU(D(), number(0) + 1);
#else
  if constexpr (hn::MaxLanes(D()) == 2) {
    const auto a = hn::LoadU(D(), number(0)), b = hn::LoadU(D(), number(1));
    first = hn::InterleaveLower(D(), a, b), second = hn::InterleaveUpper(D(), a, b);
  } else {
    const hn::Half<D> half;
    hn::Vec<hn::Half<D>> a, b, c, d;
    pairs(half, cases, at, a, b);
    pairs(half, cases + hn::MaxLanes(half), at, c, d);
    first = hn::Combine(D(), c, a), second = hn::Combine(D(), d, b);
  }
#endif
}

/// count neighbouring numbers of each case.
template <std::size_t count>
HWY_API std::array<V, count> columns(const Case* const* cases, std::size_t at) {
  std::array<V, count> all;
  for (std::size_t i = 0; i + 1 < count; i += 2)
    pairs(Tag(), cases, at + i * sizeof(double), all[i], all[i + 1]);
  if constexpr (count % 2 == 1) {
    V known;
    pairs(Tag(), cases, at + (count - 2) * sizeof(double), known, all[count - 1]);
  }
  return all;
}

/// Powers of two taken out of several numbers, so that the largest lies in 1 .. 2; which lanes have
/// all of them 0 or within 2^-64 .. 2 then.
class Scale {
 public:
  HWY_INLINE explicit Scale(const V& most) {
    const hn::RebindToSigned<Tag> integers;
    const auto bits = hn::BitCast(integers, most);
    const auto exponent = hn::And(bits, hn::Set(integers, 0x7ff0'0000'0000'0000));
    factor_ = hn::BitCast(Tag(), hn::Sub(hn::Set(integers, 0x7fe0'0000'0000'0000), exponent));
    exponent_ = hn::Sub(hn::ShiftRight<52>(exponent), hn::Set(integers, 1023));
    fits_ = hn::Lt(most, all(0x1p1000));
  }

  HWY_INLINE V operator()(const V& x) {
    const V scaled = hn::Mul(x, factor_), size = hn::Abs(scaled);
    fits_ = hn::And(fits_, hn::Or(hn::Ge(size, all(0x1p-64)), hn::Eq(x, hn::Zero(Tag()))));
    return scaled;
  }
  HWY_INLINE Vec3<V> operator()(const Vec3<V>& v) {
    return {(*this)(v.x), (*this)(v.y), (*this)(v.z)};
  }

  const V& factor() const { return factor_; }
  const auto& exponent() const { return exponent_; }
  const Mask& fits() const { return fits_; }

 private:
  V factor_;
  hn::Vec<hn::RebindToSigned<Tag>> exponent_;
  Mask fits_;
};

HWY_API V largest(const V& x) { return hn::Abs(x); }
HWY_API V largest(const Vec3<V>& v) {
  return hn::Max(hn::Max(hn::Abs(v.x), hn::Abs(v.y)), hn::Abs(v.z));
}

/// Cases of the shape S in lanes, powers of two taken out.
template <template <class> class S>
struct Loaded {
  Vec3<V> origin, direction;
  V t_min, t_max;
  S<V> shape;
  hn::Vec<hn::RebindToSigned<Tag>> t_exponent;
  Mask fits;
  bool ranges = false;  ///< has any of them a range of its own?
};

HWY_API std::size_t place_of(const Case& question, const void* part) {
  return static_cast<std::size_t>(static_cast<const char*>(part) -
                                  reinterpret_cast<const char*>(&question));
}

/// Calls visit(kind, part...) for every parameter of one shape, or of several alike at once.
template <template <class> class S, class Visit, std::size_t... i, class... Parts>
HWY_API void each_part(const Visit& visit, std::index_sequence<i...>, const Parts&... parts) {
  const auto one = [&]<std::size_t k>(std::integral_constant<std::size_t, k>)
                       INLINED { visit(S<V>::kinds[k], std::get<k>(parts)...); };
  (one(std::integral_constant<std::size_t, i>{}), ...);
}
template <template <class> class S, class Visit, class... Shapes>
HWY_API void each_part(const Visit& visit, Shapes&... shapes) {
  each_part<S>(visit, std::make_index_sequence<S<V>::kinds.size()>{}, shapes.parts()...);
}

/// The range, where any case has one of its own, in the units that are left to t. No t that is
/// known reaches what stands for an infinity.
template <template <class> class S>
HWY_API void scale_range(Loaded<S>& in, const V& factor) {
  const V infinity = all(std::numeric_limits<double>::infinity());
  for (V* end : {&in.t_min, &in.t_max}) {
    const V scaled = hn::Mul(*end, factor), size = hn::Abs(scaled);
    const Mask plain = hn::And(hn::Gt(size, all(0x1p-200)), hn::Lt(size, all(0x1p200)));
    const Mask endless = hn::Eq(hn::Abs(*end), infinity);
    const Mask zero = hn::Eq(*end, hn::Zero(Tag()));
    in.fits = hn::And(in.fits, hn::Or(plain, hn::Or(zero, endless)));
    *end = hn::IfThenElse(endless, hn::CopySign(all(0x1p1000), *end), scaled);
  }
}

template <template <class> class S>
HWY_API Loaded<S> loaded(const Case* const* cases) {
  constexpr std::size_t size = sizeof(S<double>) / sizeof(double);
  const auto r = columns<8>(cases, 0);
  const auto s =
      columns<size>(cases, place_of(*cases[0], std::get_if<S<double>>(&cases[0]->shape)));
  Loaded<S> in;
  in.origin = {r[0], r[1], r[2]}, in.direction = {r[3], r[4], r[5]};
  in.t_min = r[6], in.t_max = r[7];
  std::size_t next = 0;
  V most = largest(in.origin);
  const auto take = [&](Part kind, auto& part) INLINED {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(part)>, V>)
      part = s[next++];
    else
      part = {s[next], s[next + 1], s[next + 2]}, next += 3;
    if (kind != Part::vector) most = hn::Max(most, largest(part));
  };
  each_part<S>(take, in.shape);

  Scale length(most), along(largest(in.direction));
  in.origin = length(in.origin);
  in.direction = along(in.direction);
  in.fits = along.fits();
  const auto scale = [&](Part kind, auto& part) INLINED {
    if (kind == Part::vector) {
      Scale own(largest(part));
      part = own(part);
      in.fits = hn::And(in.fits, own.fits());
    } else {
      part = length(part);
    }
  };
  each_part<S>(scale, in.shape);
  const V zero = hn::Zero(Tag()), infinity = all(std::numeric_limits<double>::infinity());
  const Mask sound = hn::And(hn::Gt(in.shape.radius, zero), hn::Lt(in.t_min, in.t_max));
  in.fits = hn::And(in.fits, hn::And(length.fits(), sound));
  in.t_exponent = hn::Sub(length.exponent(), along.exponent());
  in.ranges = !hn::AllTrue(Tag(), hn::And(hn::Eq(in.t_min, zero), hn::Eq(in.t_max, infinity)));
  if (in.ranges) scale_range(in, hn::Div(length.factor(), along.factor()));
  return in;
}

/// The field and side conditions along the rays, from numbers W of the case.
template <class W, template <class> class S>
HWY_API auto along_rays(const Loaded<S>& in) {
  using Linear = Terms<W, W>;
  const auto& [o, d] = std::tie(in.origin, in.direction);
  const Vec3<Linear> p = {{{o.x}, {d.x}}, {{o.y}, {d.y}}, {{o.z}, {d.z}}};
  S<Terms<W>> shape;
  const auto take = [](Part, auto& to, const auto& part) INLINED {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(part)>, V>)
      to = {{part}};
    else
      to = {{{part.x}}, {{part.y}}, {{part.z}}};
  };
  each_part<S>(take, shape, in.shape);
  return patch(shape, p);
}

/// One root in each lane, and whether it is a proper crossing: proved to be, proved not to be, or
/// neither.
struct Found {
  Known t;
  Mask accepted, rejected;
};

/// Is t proved to be after, or before, an end of the range?
HWY_API Proof beside(const Known& t, const V& end) {
  const Pair apart = two_sum(t.high, hn::Neg(end));
  const V value = hn::Add(apart.high, hn::Add(apart.low, t.low));
  const V error = fused(hn::Add(hn::Abs(value), hn::Abs(t.high)), all(4 * u * u),
                        hn::Mul(hn::Abs(value), all(2 * u)));
  return proof(value, hn::Mul(hn::Add(error, t.error), all(upward)));
}

HWY_API void require(Found& found, const Proof& held) {
  found.accepted = hn::And(found.accepted, held.positive);
  found.rejected = hn::Or(found.rejected, held.negative);
}

/// The sign of a linear or quadratic side condition at t.
template <class G0, class G1, class G2>
HWY_API Proof at(const Terms<G0, G1, G2>& g, const Known& t) {
  const Lane<1, 0> value = lane_of(t);
  const auto g0 = lane_of(g.c0);
  const auto g1 = lane_of(g.c1);
  const V size = hn::Add(value.magnitude, t.error);
  const V brought = fused(size, left_out(g.c1), left_out(g.c0));
  if constexpr (std::is_same_v<G2, Nothing>) {
    return proof(value * g1 + g0, fused(g1.magnitude, t.error, brought));
  } else {
    // |g(t) - g(s)| <= |t - s| (|g1| + |g2| |t + s|)
    const auto g2 = lane_of(g.c2);
    const V slope = fused(g2.magnitude, hn::Add(size, value.magnitude), g1.magnitude);
    const V more = fused(hn::Mul(size, size), left_out(g.c2), brought);
    return proof(value * (value * g2 + g1) + g0, fused(slope, t.error, more));
  }
}

HWY_API Mask never() { return hn::Lt(all(0), all(0)); }

/// What exists and lies so that no product with t underflows.
HWY_API Mask is_usable(const Known& t, const Mask& exists) {
  return hn::And(exists, hn::Gt(hn::Abs(t.high), all(0x1p-120)));
}

/// Holds t against the range. What is found of a case does not depend on those beside it.
template <template <class> class S>
HWY_API void require_range(Found& found, const Loaded<S>& in) {
  Proof start = proof(found.t);
  if (in.ranges) {
    const Mask at_zero = hn::Eq(in.t_min, hn::Zero(Tag()));
    const Proof from_start = beside(found.t, in.t_min), end = beside(found.t, in.t_max);
    start = {hn::Or(hn::And(at_zero, start.positive), hn::AndNot(at_zero, from_start.positive)),
             hn::Or(hn::And(at_zero, start.negative), hn::AndNot(at_zero, from_start.negative))};
    require(found, {end.negative, end.positive});
  }
  require(found, start);
}

template <class G, std::size_t sides>
HWY_API void require_sides(Found& found, const std::array<G, sides>& side) {
  if constexpr (sides > 0)
    for (const G& g : side) require(found, at(g, found.t));
}

/// A root held against the range and the side conditions.
template <template <class> class S, class G, std::size_t sides>
HWY_API Found held(const Known& t, const Mask& exists, const std::array<G, sides>& side,
                   const Loaded<S>& in) {
  const Mask sure = is_usable(t, exists);
  Found found{t, sure, never()};
  require_range(found, in);
  require_sides(found, side);
  found.rejected = hn::And(found.rejected, sure);
  return found;
}

/// Doubtful is what lies within the bound of some sign, so that it may be a tie.
struct Written {
  alignas(64) std::array<double, lanes> t = {}, t_low = {}, other = {}, other_low = {};
  alignas(64) std::array<std::int64_t, lanes> exponent = {};
  std::uint64_t decided = 0, doubtful = 0, hit = 0, has_other = 0, other_known = 0;
};

HWY_API std::uint64_t bits_of(const Mask& mask) {
  std::array<std::uint8_t, 8> bytes = {};
  hn::StoreMaskBits(Tag(), mask, bytes.data());
  return bytes[0];
}

/// Is t known to within relative times itself?
HWY_API Mask known_to(const Known& t, double relative) {
  return hn::Le(t.error, hn::Mul(hn::Abs(t.high), all(relative * (1 - 0x1p-40))));
}

/// Does a power of two as far as t may be scaled back by leave all of its bits?
HWY_API Mask is_roomy(const Known& t) {
  const V size = hn::Abs(t.high);
  return hn::And(hn::Gt(size, all(0x1p-300)), hn::Lt(size, all(0x1p300)));
}

/// The power of two that was taken out of t, where putting it back loses nothing; the exponent that
/// is left elsewhere.
struct Back {
  V factor;
  hn::Vec<hn::RebindToSigned<Tag>> exponent;
};
HWY_API Back back(const hn::Vec<hn::RebindToSigned<Tag>>& exponent, const Mask& roomy) {
  const hn::RebindToSigned<Tag> integers;
  const auto most = hn::Set(integers, 500), none = hn::Zero(integers);
  const auto near = hn::And(hn::Lt(exponent, most), hn::Gt(exponent, hn::Neg(most)));
  const auto fits =
      hn::And(hn::MaskFromVec(hn::BitCast(Tag(), hn::VecFromMask(integers, near))), roomy);
  const auto power = hn::ShiftLeft<52>(hn::Add(exponent, hn::Set(integers, 1023)));
  return {hn::IfThenElse(fits, hn::BitCast(Tag(), power), all(1)),
          hn::BitCast(integers, hn::IfThenElse(fits, hn::BitCast(Tag(), none),
                                               hn::BitCast(Tag(), exponent)))};
}
HWY_API void store(const Known& t, const V& factor, double* high, double* low) {
  hn::Store(hn::Mul(t.high, factor), Tag(), high);
  hn::Store(hn::Mul(t.low, factor), Tag(), low);
}

HWY_API void write(Written& out, const Known& hit, const Known& other,
                   const hn::Vec<hn::RebindToSigned<Tag>>& exponent) {
  const Back put = back(exponent, hn::And(is_roomy(hit), is_roomy(other)));
  hn::Store(put.exponent, hn::RebindToSigned<Tag>(), out.exponent.data());
  store(hit, put.factor, out.t.data(), out.t_low.data());
  store(other, put.factor, out.other.data(), out.other_low.data());
}

/// A linear field: one root.
template <template <class> class S, class F0, class F1, class G, std::size_t sides>
HWY_API void settle(const Patch<Terms<F0, F1>, G, sides>& patch, const Loaded<S>& in,
                    double relative, Written& out) {
  const Known slope = known(patch.field.c1);
  const Known t = -known(patch.field.c0) / slope;
  const Found root = held<S>(t, is_clear(slope), patch.side, in);
  const Mask hit = hn::And(root.accepted, known_to(t, relative));
  write(out, t, t, in.t_exponent);
  out.hit = bits_of(hit);
  out.decided = bits_of(hn::And(in.fits, hn::Or(hit, root.rejected)));
  out.doubtful = ~bits_of(hn::Or(root.accepted, root.rejected));
}

HWY_API Known chosen(const Mask& mask, const Known& yes, const Known& no) {
  return {hn::IfThenElse(mask, yes.high, no.high), hn::IfThenElse(mask, yes.low, no.low),
          hn::IfThenElse(mask, yes.error, no.error)};
}
HWY_API Known with_sign(const Known& x, const V& sign) {
  return {hn::Xor(x.high, sign), hn::Xor(x.low, sign), x.error};
}

/// The roots of a quadratic field, where it is proved to have two, and where to have none.
struct FieldRoots {
  Known first, last;
  Mask exist, none;
};

/// Of C + B t + A t^2: with m = -(B + sign(B) sqrt(D)) they are m / 2A and 2C / m, neither of which
/// cancels.
template <class F0, class F1, class F2>
HWY_API FieldRoots roots_of(const Terms<F0, F1, F2>& f, const Known& d, const Mask& none) {
  const Known a = known(f.c2), b = known(f.c1), c = known(f.c0);
  const V sign_b = hn::And(b.high, hn::SignBit(Tag()));
  const Known m = -plus_alike(b, with_sign(sqrt(d), sign_b));
  const Mask exist = hn::And(hn::And(hn::Gt(d.high, hn::Zero(Tag())), is_clear(d)),
                             hn::And(is_clear(a), is_clear(m)));
  const Known by_a = m / twice(a), by_c = twice(c) / m;
  const V sign_a = hn::And(a.high, hn::SignBit(Tag()));
  const Mask a_first = hn::Lt(hn::Xor(sign_a, m.high), hn::Zero(Tag()));
  return {chosen(a_first, by_a, by_c), chosen(a_first, by_c, by_a), exist, none};
}
template <class F0, class F1, class F2>
HWY_API Known discriminant(const Terms<F0, F1, F2>& f) {
  return known(squared(f.c1) - twice(twice(f.c2 * f.c0)));
}

/// An open shape with a quadratic field.
template <template <class> class S, class F0, class F1, class F2, class G, std::size_t sides>
requires(caps<S<double>> == 0) HWY_API
    void settle(const Patch<Terms<F0, F1, F2>, G, sides>& patch, const Loaded<S>& in,
                double relative, Written& out) {
  const Known d = discriminant(patch.field);
  const Mask none = proof(d).negative;
  if (hn::AllTrue(Tag(), none)) {
    out.hit = out.has_other = out.doubtful = 0;
    out.decided = bits_of(in.fits);
    return;
  }
  const FieldRoots roots = roots_of(patch.field, d, none);
  const Found first = held<S>(roots.first, roots.exist, patch.side, in);
  const Found last = held<S>(roots.last, roots.exist, patch.side, in);

  const Mask hit_last = hn::And(first.rejected, last.accepted);
  const Known hit = chosen(first.accepted, first.t, last.t);
  const Known other = chosen(first.accepted, last.t, first.t);
  const Mask met = hn::Or(first.accepted, hit_last);
  const Mask is_hit = hn::And(met, known_to(hit, relative));
  const Mask is_miss = hn::Or(none, hn::And(first.rejected, last.rejected));
  write(out, hit, other, in.t_exponent);
  out.hit = bits_of(is_hit);
  out.has_other = out.hit;
  out.other_known = bits_of(known_to(other, 0x1p-60));
  out.decided = bits_of(hn::And(in.fits, hn::Or(is_hit, is_miss)));
  out.doubtful = ~bits_of(hn::Or(met, is_miss));
}

/// Where a line meets a patch of a closed shape: is that proved to be on its surface, proved not to
/// be (or not to be at all), or neither?
struct Met {
  Known t;
  Mask exists, on, off;
};

template <class G, std::size_t sides>
HWY_API Met met_lateral(const Known& t, const FieldRoots& roots, const std::array<G, sides>& side) {
  const Mask sure = is_usable(t, roots.exist);
  Found found{t, sure, never()};
  require_sides(found, side);
  return {t, sure, found.accepted, hn::Or(roots.none, hn::And(found.rejected, sure))};
}

/// The cap of a side condition, within the edge where the field is negative.
template <class F, class G>
HWY_API Met met_cap(const F& field, const G& side) {
  const Known slope = known(side.c1);
  const Known t = -known(side.c0) / slope;
  const Mask sure = is_usable(t, is_clear(slope));
  const Proof outside = at(field, t);
  return {t, sure, hn::And(sure, outside.negative), hn::And(sure, outside.positive)};
}

/// The points of a line on the surface of a closed shape: a line that only crosses has none or two.
struct Crossed {
  Known enter, leave;
  V enters_by, leaves_by;  ///< which of those met
  Mask one, two, more;

  HWY_INLINE explicit Crossed(const Known& any)
      : enter(any),
        leave(any),
        enters_by(all(0)),
        leaves_by(all(0)),
        one(never()),
        two(never()),
        more(never()) {}

  HWY_INLINE void add(const Met& met, double which) {
    const Mask second = hn::And(one, met.on), first = hn::AndNot(one, met.on);
    more = hn::Or(more, hn::And(two, met.on));
    enter = chosen(first, met.t, enter), leave = chosen(second, met.t, leave);
    enters_by = hn::IfThenElse(first, all(which), enters_by);
    leaves_by = hn::IfThenElse(second, all(which), leaves_by);
    two = hn::Or(two, second), one = hn::Or(one, first);
  }

  /// Puts them in order, and keeps those where that is proved.
  HWY_INLINE void order() {
    const Pair apart = two_sum(leave.high, hn::Neg(enter.high));
    const V value = hn::Add(apart.high, hn::Add(apart.low, hn::Sub(leave.low, enter.low)));
    const V size = hn::Add(hn::Abs(value), hn::Add(hn::Abs(leave.high), hn::Abs(enter.high)));
    const V rounding = fused(size, all(4 * u * u), hn::Mul(hn::Abs(value), all(2 * u)));
    const V error = hn::Add(rounding, hn::Add(leave.error, enter.error));
    const Proof order = proof(value, hn::Mul(error, all(upward)));
    const Known former = enter;
    enter = chosen(order.negative, leave, enter), leave = chosen(order.negative, former, leave);
    const V by = enters_by;
    enters_by = hn::IfThenElse(order.negative, leaves_by, by);
    leaves_by = hn::IfThenElse(order.negative, by, leaves_by);
    two = hn::AndNot(more, hn::And(two, hn::Or(order.positive, order.negative)));
  }
};

/// What lanes know of closed shapes besides: every root, and which of them is the hit.
struct ClosedWritten : Written {
  std::size_t count = 0;
  std::array<std::uint8_t, Truth::most_roots> patch = {};
  alignas(64) std::array<std::array<double, lanes>, Truth::most_roots> high = {}, low = {};
  std::array<std::uint64_t, Truth::most_roots> exists = {}, known = {};
  alignas(64) std::array<double, lanes> hit_by = {};
};

template <std::size_t count>
HWY_API void write(ClosedWritten& out, const std::array<Met, count>& met,
                   const hn::Vec<hn::RebindToSigned<Tag>>& exponent) {
  Mask roomy = hn::Not(never());
  for (const Met& one : met) roomy = hn::And(roomy, hn::Or(is_roomy(one.t), hn::Not(one.exists)));
  const Back put = back(exponent, roomy);
  hn::Store(put.exponent, hn::RebindToSigned<Tag>(), out.exponent.data());
  for (std::size_t r = 0; r < count; ++r) {
    store(met[r].t, put.factor, out.high[r].data(), out.low[r].data());
    out.exists[r] = bits_of(met[r].exists);
    out.known[r] = bits_of(known_to(met[r].t, 0x1p-60));
  }
}

/// A closed shape: its surface is met on the lateral patch or on caps. The solid is convex.
template <template <class> class S, class F0, class F1, class F2, class G, std::size_t sides>
requires(caps<S<double>> != 0) HWY_API
    void settle(const Patch<Terms<F0, F1, F2>, G, sides>& patch, const Loaded<S>& in,
                double relative, ClosedWritten& out) {
  constexpr std::size_t all_met = 2 + std::popcount(caps<S<double>>);
  const Known d = discriminant(patch.field);
  const FieldRoots roots = roots_of(patch.field, d, proof(d).negative);
  std::array<Met, all_met> met;
  met[0] = met_lateral(roots.first, roots, patch.side);
  met[1] = met_lateral(roots.last, roots, patch.side);
  out.count = 2;
  for (std::size_t i = 0; i < sides; ++i)
    if (is_cap<S<double>>(static_cast<int>(i))) {
      out.patch[out.count] = static_cast<std::uint8_t>(i + 1);
      met[out.count++] = met_cap(patch.field, patch.side[i]);
    }
  Crossed crossed(met[0].t);
  Mask sure = in.fits;
  for (std::size_t r = 0; r < all_met; ++r) {
    crossed.add(met[r], static_cast<double>(r));
    sure = hn::And(sure, hn::Or(met[r].on, met[r].off));
  }
  crossed.order();
  Found enter{crossed.enter, crossed.two, never()}, leave{crossed.leave, crossed.two, never()};
  require_range(enter, in);
  require_range(leave, in);

  const Known hit = chosen(enter.accepted, enter.t, leave.t);
  const Mask met_any = hn::Or(enter.accepted, hn::And(enter.rejected, leave.accepted));
  const Mask both_out = hn::And(crossed.two, hn::And(enter.rejected, leave.rejected));
  const Mask is_miss = hn::Or(hn::Not(crossed.one), both_out);
  const Mask is_hit = hn::And(met_any, known_to(hit, relative));
  write(out, met, in.t_exponent);
  hn::Store(hn::IfThenElse(enter.accepted, crossed.enters_by, crossed.leaves_by), Tag(),
            out.hit_by.data());
  out.hit = bits_of(is_hit);
  out.decided = bits_of(hn::And(sure, hn::Or(is_hit, is_miss)));
  out.doubtful = ~bits_of(hn::And(sure, hn::Or(met_any, is_miss)));
}

HWY_API void tell(const Written& found, std::size_t i, Stage stage, Truth& truth) {
  const auto bit = [&](std::uint64_t mask) INLINED { return (mask >> i & 1U) != 0; };
  const int exponent = static_cast<int>(found.exponent[i]);
  const Real t{found.t[i], found.t_low[i], 0, exponent};
  truth.invalid = Invalid::no;
  truth.stage = stage;
  truth.count = bit(found.hit) ? 1 : 0;
  truth.listed[0] = {Kind::proper, t, t, 0};
  truth.others_known = bit(found.hit) && (!bit(found.has_other) || bit(found.other_known));
  truth.other_count = bit(found.has_other) ? 1 : 0;
  truth.other_roots[0] = {found.other[i], found.other_low[i], 0, exponent};
}

HWY_API bool is_before(const Real& a, const Real& b) {
  return a.high < b.high || (a.high == b.high && a.middle < b.middle);
}

HWY_API void tell(const ClosedWritten& found, std::size_t i, Stage stage, Truth& truth) {
  const auto bit = [&](std::uint64_t mask) INLINED { return (mask >> i & 1U) != 0; };
  const int exponent = static_cast<int>(found.exponent[i]);
  const auto t = [&](std::size_t r) INLINED {
    return Real{found.high[r][i], found.low[r][i], 0, exponent};
  };
  truth.clear();
  truth.stage = stage;
  if (!bit(found.hit)) return;
  const auto hit = static_cast<std::size_t>(found.hit_by[i]);
  truth.listed[truth.count++] = {Kind::proper, t(hit), t(hit), found.patch[hit]};
  truth.others_known = true;
  for (std::size_t r = 0; r < found.count; ++r) {
    if (r == hit || !bit(found.exists[r])) continue;
    truth.others_known = truth.others_known && bit(found.known[r]);
    std::size_t place = truth.other_count++;  // in order along the line
    for (; place > 0 && is_before(t(r), truth.other_roots[place - 1]); --place)
      truth.other_roots[place] = truth.other_roots[place - 1];
    truth.other_roots[place] = t(r);
  }
}

template <class W, template <class> class S>
HWY_ATTR InLanes settle_all(std::span<const Case* const> cases, std::span<Truth* const> truths,
                            double relative) {
  constexpr Stage stage = std::is_same_v<W, Word> ? Stage::lanes : Stage::wide_lanes;
  InLanes all = {0, 0};
  std::conditional_t<caps<S<double>> == 0, Written, ClosedWritten> found;
  for (std::size_t i = 0; i < cases.size(); i += lanes) {
    const std::size_t count = std::min(lanes, cases.size() - i);
    std::array<const Case*, lanes> last;  // the last lanes are filled up
    const Case* const* at = cases.data() + i;
    if (count < lanes) {
      for (std::size_t j = 0; j < lanes; ++j) last[j] = cases[i + std::min(j, count - 1)];
      at = last.data();
    }
    const Loaded<S> in = loaded<S>(at);
    settle<S>(along_rays<W, S>(in), in, relative, found);
    for (std::size_t j = 0; j < count; ++j)
      if ((found.decided >> j & 1U) != 0) tell(found, j, stage, *truths[i + j]);
    const std::uint64_t filled = (std::uint64_t{1} << count) - 1;
    all.settled |= (found.decided & filled) << i;
    all.doubtful |= (found.doubtful & filled & ~found.decided) << i;
  }
  return all;
}

}  // namespace

template <class W>
InLanes settle_words(std::span<const Case* const> cases, std::span<Truth* const> truths,
                     double relative) {
  const Shape& shape = cases[0]->shape;
  if (std::holds_alternative<Sphere<double>>(shape))
    return settle_all<W, Sphere>(cases, truths, relative);
  if (std::holds_alternative<Disk<double>>(shape))
    return settle_all<W, Disk>(cases, truths, relative);
  if (std::holds_alternative<Cylinder<double>>(shape))
    return settle_all<W, Cylinder>(cases, truths, relative);
  if (std::holds_alternative<Cone<double>>(shape))
    return settle_all<W, Cone>(cases, truths, relative);
  if (std::holds_alternative<CappedCylinder<double>>(shape))
    return settle_all<W, CappedCylinder>(cases, truths, relative);
  return settle_all<W, CappedCone>(cases, truths, relative);
}

InLanes settle_in(std::span<const Case* const> cases, std::span<Truth* const> truths,
                  double relative, Words words) {
  return words == Words::two ? settle_words<Word>(cases, truths, relative)
                             : settle_words<WideWord>(cases, truths, relative);
}

}  // namespace rayaudit::oracle::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace rayaudit::oracle {

std::string_view name(Lanes lanes) {
  constexpr std::array<std::string_view, 3> names = {"portable", "AVX2", "AVX-512"};
  return names[static_cast<std::size_t>(lanes)];
}

bool has([[maybe_unused]] Lanes lanes) {
#ifdef __x86_64__
  const bool avx2 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") &&
                    __builtin_cpu_supports("bmi2");
  const bool avx512 = avx2 && __builtin_cpu_supports("avx512f") &&
                      __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                      __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512cd");
  return lanes == Lanes::portable || (lanes == Lanes::avx2 ? avx2 : avx512);
#else
  return lanes == Lanes::portable;
#endif
}

Lanes widest_lanes() {
  static const Lanes widest = has(Lanes::avx512) ? Lanes::avx512
                              : has(Lanes::avx2) ? Lanes::avx2
                                                 : Lanes::portable;
  return widest;
}

InLanes settle_in_lanes(std::span<const Case* const> cases, std::span<Truth* const> truths,
                        int bits, Words words, Lanes lanes) {
  const double relative = std::ldexp(1.0, -bits);
  switch (lanes) {
#ifdef __x86_64__
    case Lanes::avx512:
      return N_AVX3::settle_in(cases, truths, relative, words);
    case Lanes::avx2:
      return N_AVX2::settle_in(cases, truths, relative, words);
#endif
    default:
      return HWY_STATIC_DISPATCH(settle_in)(cases, truths, relative, words);
  }
}

}  // namespace rayaudit::oracle
#endif
