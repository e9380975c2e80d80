#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "oracle/fields.hpp"
#include "oracle/truth.hpp"

/// From the polynomials of a ray and a patch to the list of its crossings, by signs alone. The same
/// text runs in intervals and in exact numbers; it is told nothing of either.
namespace rayaudit::oracle {

/// Which root of F a t is: of a linear F, the double root, or the smaller or larger of two.
enum class Which : std::uint8_t { linear, twofold, smaller, larger };

/// What the signs say of one real root of F, or of a cap's field.
struct Outlined {
  Which which = Which::linear;
  Standing standing = Standing::acceptable;
  Kind kind = Kind::proper;
  std::uint8_t patch = 0;  ///< as Crossing has it

  bool is_proper_hit() const { return standing == Standing::acceptable && kind == Kind::proper; }
  /// The place of its t among those of all roots: F's, then each cap's.
  int place() const { return patch == 0 ? static_cast<int>(which == Which::larger) : patch + 1; }
};

constexpr std::uint8_t patch_of_cap(int side) { return static_cast<std::uint8_t>(side + 1); }
/// The side condition that a cap closes, -1 of a root of F.
constexpr int cap_of(const Outlined& root) { return root.patch - 1; }

/// What the signs say of a case.
struct Outline {
  bool unsure = false;     ///< a sign was not to be had; nothing else here counts
  bool within = false;     ///< the line lies in a patch; no roots are listed
  bool complete = false;   ///< every root is listed, those after the first proper crossing too
  std::uint8_t patch = 0;  ///< of within: which patch
  Which lateral = Which::linear;  ///< of a closed shape: what the first root of F is
  std::uint8_t count = 0;
  std::array<Outlined, Truth::most_roots> listed = {};

  void add(const Outlined& root) { listed[count++] = root; }
  /// The first proper crossing, or null; within the surface there is none.
  const Outlined* proper_hit() const& {
    for (int i = 0; i < count; ++i)
      if (listed[i].is_proper_hit()) return &listed[i];
    return nullptr;
  }
};

/// The signs of numbers of N: -1, 0, 1. A sign that N cannot tell is 0 and sets unsure for good.
/// Specialised beside each number.
template <class N>
struct Signs;

/// The range of a ray in N. Most start at 0 and never end, and are spared the arithmetic.
template <class N>
struct Range {
  explicit Range(const Ray<double>& ray)
      : starts_at_zero(ray.t_min == 0),
        has_start(ray.t_min > -std::numeric_limits<double>::infinity()),
        has_end(ray.t_max < std::numeric_limits<double>::infinity()),
        start(has_start ? ray.t_min : 0),
        end(has_end ? ray.t_max : 0) {}

  /// What vanishes at an end and is positive within the range.
  Polynomial<N, 1> above_start() const { return {{N(-start), N(1)}}; }
  Polynomial<N, 1> below_end() const { return {{end, N(-1)}}; }

  bool starts_at_zero, has_start, has_end;
  N start, end;
};

/// The roots of a linear F = c0 + c1 t, c1 != 0.
template <class N, class Sign = Signs<N>>
struct LinearRoot {
  const N &c0, &c1;
  int sign_c1;
  Sign& sign;

  Which which() const { return Which::linear; }

  /// The sign of g at the root, from g0 c1 - g1 c0.
  template <class M>
  int at(const Polynomial<M, 1>& g) const {
    return sign(g.c[0] * c1 - g.c[1] * c0) * sign_c1;
  }
  /// The sign of g at the root, from g0 c1^2 - g1 c0 c1 + g2 c0^2.
  template <class M>
  int at(const Polynomial<M, 2>& g) const {
    return sign(g.c[0] * squared(c1) - g.c[1] * (c0 * c1) + g.c[2] * squared(c0));
  }
  /// The sign of t itself.
  int of_t() const { return -sign(c0) * sign_c1; }
};

/// One root of a quadratic F = C + B t + A t^2, A != 0, D = B^2 - 4 A C >= 0:
/// t = (-B + e sqrt(D)) / 2A, with e = -sign(A) for the smaller root and sign(A) for the larger.
template <class N, class Sign = Signs<N>>
struct QuadraticRoot {
  const Polynomial<N, 2>& f;
  int sign_a;
  Which root;
  Sign& sign;

  Which which() const { return root; }

  /// The sign of g = g0 + g1 t at the root: that of A (P + e g1 sqrt(D)), P = 2 A g0 - g1 B. Where
  /// the two terms disagree it is decided by P^2 - g1^2 D = 4 A R, R = A g0^2 - B g0 g1 + C g1^2.
  template <class M>
  int at(const Polynomial<M, 1>& g) const {
    const M &g0 = g.c[0], &g1 = g.c[1];
    const auto ag0 = f.c[2] * g0;
    const int sign_p = sign(twice(ag0) - g1 * f.c[1]);
    if (root == Which::twofold) return sign_a * sign_p;
    return combined(sign_p, sign(g1),
                    [&] { return sign(ag0 * g0 - f.c[1] * (g0 * g1) + f.c[0] * squared(g1)); });
  }
  /// The sign of t itself: P = -B, R = C.
  int of_t() const {
    const int sign_p = -sign(f.c[1]);
    if (root == Which::twofold) return sign_a * sign_p;
    return combined(sign_p, 1, [&] { return sign(f.c[0]); });
  }

 private:
  template <class R>
  int combined(int sign_p, int sign_g1, R&& sign_r) const {
    const int sign_q = (root == Which::smaller ? -sign_a : sign_a) * sign_g1;
    if (sign_q == 0) return sign_a * sign_p;
    if (sign_p == 0 || sign_p == sign_q) return sign_a * sign_q;
    return sign_p * sign_r();  // sign_a * sign_p * sign_a * sign_r
  }
};

template <class N>
[[gnu::always_inline]] inline auto discriminant(const Polynomial<N, 2>& f) {
  return squared(f.c[1]) - twice(twice(ProductOf<N, N>(f.c[2] * f.c[0])));
}

/// Is a field the same all along the line?
template <class N, int degree, class Sign>
bool is_constant(const Polynomial<N, degree>& field, Sign& sign) {
  bool constant = true;
  for (int i = 1; i <= degree; ++i) constant = constant && sign(field.c[i]) == 0;
  return constant;
}

/// Where a root stands against the range: how t lies to either end.
struct InRange {
  int from_start = 1, to_end = 1;

  template <class Root, class R>
  InRange(const Root& root, const R& range) {
    if (range.has_start)
      from_start = range.starts_at_zero ? root.of_t() : root.at(range.above_start());
    if (from_start < 0) return;
    if (range.has_end) to_end = root.at(range.below_end());
  }
};

/// Where a root stands against the range and the side conditions that count.
template <class S, class Root, class G, std::size_t sides, class R>
Outlined outlined(const Root& root, bool opens_outward, const std::array<G, sides>& side,
                  const R& range, Extent extent) {
  constexpr int apex = apex_side<S>;
  Outlined found{.which = root.which(),
                 .kind = root.which() == Which::twofold ? Kind::tangent : Kind::proper};
  const auto rejected = [&](Standing why) {
    found.standing = why;
    return found;
  };
  const InRange in_range(root, range);
  if (in_range.from_start < 0) return rejected(Standing::behind);
  if (in_range.to_end < 0) return rejected(Standing::past);
  for (int i = 0; i < static_cast<int>(sides); ++i) {
    const bool counted = counts<S>(i, extent);
    // From one nappe into the other: no side of the surface is left.
    const bool joins = !counted && i == apex && root.which() == Which::twofold;
    if (!counted && !joins) continue;
    const int g = root.at(side[i]);
    if (g < 0 && counted) return rejected(i == apex ? Standing::mirrored : Standing::clipped);
    if (g != 0) continue;
    // From inside, a small change of the line leaves through the same nappe near the apex.
    if (i == apex)
      found.kind = opens_outward || joins ? Kind::apex : Kind::proper;
    else
      found.kind = Kind::rim;
  }
  if (in_range.from_start == 0) found.kind = Kind::start;
  if (in_range.to_end == 0) found.kind = Kind::end;
  return found;
}

/// Adds a root to the outline; true once the outline ends with a proper crossing.
inline bool add(Outline& outline, Outlined root) {
  outline.add(root);
  return root.is_proper_hit();
}

template <class S, class N, class G, std::size_t sides, class R, class Sign>
void settle_linear(Outline& outline, const N& c0, const N& c1, const std::array<G, sides>& side,
                   const R& range, Sign& sign, Extent extent) {
  const int sign_c1 = sign(c1);
  if (sign_c1 != 0)
    add(outline,
        outlined<S>(LinearRoot<N, Sign>{c0, c1, sign_c1, sign}, false, side, range, extent));
  else
    outline.within = sign(c0) == 0;
}

/// The outline of a case: its roots up to the first proper crossing or, where all is asked, every
/// one. Roots that are no crossings are listed too, each with its standing.
template <class S, class N, class G, std::size_t sides, class R, class Sign>
Outline settle_open(const Patch<Polynomial<N, 1>, G, sides>& patch, const R& range, Sign& sign,
                    Extent extent, bool /*all*/) {
  Outline outline;
  settle_linear<S>(outline, patch.field.c[0], patch.field.c[1], patch.side, range, sign, extent);
  outline.unsure = sign.unsure;
  return outline;
}

template <class S, class N, class G, std::size_t sides, class R, class Sign>
Outline settle_open(const Patch<Polynomial<N, 2>, G, sides>& patch, const R& range, Sign& sign,
                    Extent extent, bool all) {
  const auto& [c, b, a] = patch.field.c;
  Outline outline;
  const int sign_a = sign(a);
  if (sign.unsure) return {.unsure = true};
  if (sign_a == 0) {
    settle_linear<S>(outline, c, b, patch.side, range, sign, extent);
    outline.unsure = sign.unsure;
    return outline;
  }
  const int sign_d = sign(discriminant(patch.field));
  if (sign.unsure) return {.unsure = true};
  if (sign_d < 0) return outline;
  const auto root = [&](Which which) {
    return outlined<S>(QuadraticRoot<N, Sign>{patch.field, sign_a, which, sign}, sign_a > 0,
                       patch.side, range, extent);
  };
  if (sign_d == 0) {
    add(outline, root(Which::twofold));
  } else {
    const bool ended = add(outline, root(Which::smaller));
    if (!ended || all) {
      Outlined last = root(Which::larger);
      if (ended && last.standing == Standing::acceptable) last.standing = Standing::later;
      outline.add(last);
    }
  }
  outline.unsure = sign.unsure;
  return outline;
}

/// A closed shape: where the line meets its patches. The solid is convex, so the line has one
/// stretch in common with it: of the points on the surface the first enters and the second leaves,
/// whatever patches they are on, and a single one only touches. A root is held against a cap's by
/// the sign of the cap's side condition at it, so that no two roots are ever compared.
template <class S, class N, class M, std::size_t sides, class R, class Sign>
class Closed {
 public:
  Closed(const Patch<Polynomial<N, 2>, Polynomial<M, 1>, sides>& patch, const R& range, Sign& sign)
      : field_(patch.field), side_(patch.side), range_(range), sign_(sign) {}

  Outline outline() {
    for (int i = 0; i < int{sides}; ++i)
      if (is_cap<S>(i) && (rise_[i] = sign_(side_[i].c[1])) == 0 && sign_(side_[i].c[0]) == 0)
        return {.unsure = sign_.unsure, .within = true, .patch = patch_of_cap(i)};
    if (!meet_lateral()) return {.unsure = sign_.unsure, .within = true};
    if (sign_.unsure) return {.unsure = true};
    for (int i = 0; i < int{sides}; ++i)
      if (is_cap<S>(i) && rise_[i] != 0) meet_cap(i);
    return told();
  }

 private:
  /// A root of one patch; what it is told as, unless the range has it otherwise.
  struct Met {
    Outlined root;
    bool on_surface = true;
    int from_start = 1, to_end = 1;
    std::array<int, sides> side = {};  ///< of a lateral root: the signs of the side conditions
  };

  /// False where the line lies in the lateral surface.
  bool meet_lateral() {
    const auto& [c, b, a] = field_.c;
    const int sign_a = sign_(a);
    if (sign_a == 0) {
      const int sign_b = sign_(b);
      if (sign_b == 0) return sign_(c) != 0;
      meet_lateral(LinearRoot<N, Sign>{c, b, sign_b, sign_});
      return true;
    }
    const int sign_d = sign_(discriminant(field_));
    if (sign_.unsure || sign_d < 0) return true;
    const auto meet = [&](Which which) {
      meet_lateral(QuadraticRoot<N, Sign>{field_, sign_a, which, sign_});
    };
    if (sign_d == 0) {
      meet(Which::twofold);
    } else {
      meet(Which::smaller);
      meet(Which::larger);
    }
    return true;
  }

  template <class Root>
  void meet_lateral(const Root& root) {
    lateral_ = count_ == 0 ? root.which() : lateral_;
    Met met;
    met.root.which = root.which();
    if (root.which() == Which::twofold) met.root.kind = Kind::tangent;
    for (int i = 0; i < int{sides}; ++i) {
      met.side[i] = root.at(side_[i]);
      if (met.side[i] == 0 && is_cap<S>(i)) return;  // at an edge: the cap tells it
      if (met.side[i] == 0) met.root.kind = Kind::apex;
      if (met.side[i] < 0 && met.on_surface) {
        met.on_surface = false;
        met.root.standing = i == apex_side<S> ? Standing::mirrored : Standing::clipped;
      }
    }
    hold_against_range(met, root);
    met_[count_++] = met;
  }

  void meet_cap(int i) {
    const auto& [g0, g1] = side_[i].c;
    const LinearRoot<M, Sign> root{g0, g1, rise_[i], sign_};
    const int f = root.at(field_);
    Met met;
    met.root.kind = f == 0 ? Kind::rim : Kind::proper;
    met.root.patch = patch_of_cap(i);
    if (f > 0) met.on_surface = false, met.root.standing = Standing::clipped;
    hold_against_range(met, root);
    int place = count_++;
    for (; place > 0 && !is_before(met_[place - 1], i); --place) met_[place] = met_[place - 1];
    met_[place] = met;
  }

  /// Does a root lie before that of a cap? Of two caps the line meets the one first whose side
  /// condition rises.
  bool is_before(const Met& met, int cap) const {
    const int other = cap_of(met.root);
    return other < 0 ? met.side[cap] * rise_[cap] < 0 : rise_[other] > 0;
  }

  template <class Root>
  void hold_against_range(Met& met, const Root& root) const {
    const InRange in_range(root, range_);
    met.from_start = in_range.from_start, met.to_end = in_range.to_end;
  }

  Outline told() const {
    int on_surface = 0;
    for (int i = 0; i < count_; ++i) on_surface += met_[i].on_surface ? 1 : 0;
    Outline outline{.unsure = sign_.unsure, .complete = true, .lateral = lateral_};
    bool ended = false;
    for (int i = 0; i < count_; ++i) {
      Met met = met_[i];
      Outlined& root = met.root;
      if (on_surface > 1) root.kind = Kind::proper;
      if (met.from_start == 0) root.kind = Kind::start;
      if (met.to_end == 0) root.kind = Kind::end;
      if (met.from_start < 0)
        root.standing = Standing::behind;
      else if (met.to_end < 0)
        root.standing = Standing::past;
      else if (ended && met.on_surface)
        root.standing = Standing::later;
      outline.add(root);
      ended = ended || root.is_proper_hit();
    }
    return outline;
  }

  const Polynomial<N, 2>& field_;
  const std::array<Polynomial<M, 1>, sides>& side_;
  const R& range_;
  Sign& sign_;
  std::array<int, sides> rise_ = {};  ///< of a cap: the sign of the slope of its side condition
  std::array<Met, Truth::most_roots> met_;
  int count_ = 0;
  Which lateral_ = Which::linear;
};

template <class S, class N, class M, std::size_t sides, class R, class Sign>
Outline outline_of_closed(const Patch<Polynomial<N, 2>, Polynomial<M, 1>, sides>& patch,
                          const R& range, Sign& sign) {
  return Closed<S, N, M, sides, R, Sign>(patch, range, sign).outline();
}

/// The outline of a case of the shape S. Of an open shape up to the first proper crossing, unless
/// all is asked; of a closed one always all.
template <class S, class P, class R, class Sign>
Outline settle(const P& patch, const R& range, Sign& sign, Extent extent, bool all) {
  if constexpr (caps<S> != 0)
    return outline_of_closed<S>(patch, range, sign);
  else
    return settle_open<S>(patch, range, sign, extent, all);
}

/// The field of a cap, which is linear.
template <class N, class F, std::size_t sides>
Polynomial<N, 1> cap_field(const Patch<F, Polynomial<N, 1>, sides>& patch, int cap) {
  return {{N(-patch.side[cap].c[0]), N(-patch.side[cap].c[1])}};
}

}  // namespace rayaudit::oracle
