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

/// What the signs say of one real root of F.
struct Outlined {
  Which which = Which::linear;
  Standing standing = Standing::acceptable;
  Kind kind = Kind::proper;
};

/// What the signs say of a case.
struct Outline {
  bool unsure = false;  ///< a sign was not to be had; nothing else here counts
  bool within = false;  ///< F vanishes all along; no roots are listed
  std::uint8_t count = 0;
  std::array<Outlined, Truth::most> listed = {};

  void add(const Outlined& root) { listed[count++] = root; }
  /// The first proper crossing, or null; within the surface there is none.
  const Outlined* proper_hit() const& {
    if (count == 0) return nullptr;
    const Outlined& last = listed[count - 1];
    return last.standing == Standing::acceptable && last.kind == Kind::proper ? &last : nullptr;
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

  bool starts_at_zero, has_start, has_end;
  N start, end;
};

/// The roots of a linear F = c0 + c1 t, c1 != 0.
template <class N>
struct LinearRoot {
  const N &c0, &c1;
  int sign_c1;
  Signs<N>& sign;

  Which which() const { return Which::linear; }

  /// The sign of g at the root, from g0 c1 - g1 c0.
  int at(const Polynomial<N, 1>& g) const { return sign(g.c[0] * c1 - g.c[1] * c0) * sign_c1; }
  /// The sign of g at the root, from g0 c1^2 - g1 c0 c1 + g2 c0^2.
  int at(const Polynomial<N, 2>& g) const {
    return sign(g.c[0] * squared(c1) - g.c[1] * (c0 * c1) + g.c[2] * squared(c0));
  }
  /// The sign of t itself.
  int of_t() const { return -sign(c0) * sign_c1; }
};

/// One root of a quadratic F = C + B t + A t^2, A != 0, D = B^2 - 4 A C >= 0:
/// t = (-B + e sqrt(D)) / 2A, with e = -sign(A) for the smaller root and sign(A) for the larger.
template <class N>
struct QuadraticRoot {
  const Polynomial<N, 2>& f;
  int sign_a;
  Which root;
  Signs<N>& sign;

  Which which() const { return root; }

  /// The sign of g = g0 + g1 t at the root: that of A (P + e g1 sqrt(D)), P = 2 A g0 - g1 B. Where
  /// the two terms disagree it is decided by P^2 - g1^2 D = 4 A R, R = A g0^2 - B g0 g1 + C g1^2.
  int at(const Polynomial<N, 1>& g) const {
    const N &g0 = g.c[0], &g1 = g.c[1];
    const N ag0 = f.c[2] * g0;
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

/// Where a root stands against the range and the side conditions.
template <int apex, class N, class Root, class G, std::size_t sides>
Outlined outlined(const Root& root, bool opens_outward, const std::array<G, sides>& side,
                  const Range<N>& range) {
  Outlined found{.which = root.which(),
                 .kind = root.which() == Which::twofold ? Kind::tangent : Kind::proper};
  const auto rejected = [&](Standing why) {
    found.standing = why;
    return found;
  };
  int from_start = 1, to_end = 1;
  if (range.has_start)
    from_start =
        range.starts_at_zero ? root.of_t() : root.at(Polynomial<N, 1>{{N(-range.start), N(1)}});
  if (from_start < 0) return rejected(Standing::behind);
  if (range.has_end) to_end = root.at(Polynomial<N, 1>{{range.end, N(-1)}});
  if (to_end < 0) return rejected(Standing::past);
  for (int i = 0; i < static_cast<int>(sides); ++i) {
    const int g = root.at(side[i]);
    if (g < 0) return rejected(i == apex ? Standing::mirrored : Standing::clipped);
    if (g > 0) continue;
    // From inside, a small change of the line leaves through the same nappe near the apex.
    if (i == apex)
      found.kind = opens_outward ? Kind::apex : Kind::proper;
    else
      found.kind = Kind::rim;
  }
  if (from_start == 0) found.kind = Kind::start;
  if (to_end == 0) found.kind = Kind::end;
  return found;
}

/// Adds a root to the outline; true once the outline ends with a proper crossing.
inline bool add(Outline& outline, Outlined root) {
  outline.add(root);
  return root.standing == Standing::acceptable && root.kind == Kind::proper;
}

template <int apex, class N, class G, std::size_t sides>
void settle_linear(Outline& outline, const N& c0, const N& c1, const std::array<G, sides>& side,
                   const Range<N>& range, Signs<N>& sign) {
  const int sign_c1 = sign(c1);
  if (sign_c1 != 0)
    add(outline, outlined<apex, N>(LinearRoot<N>{c0, c1, sign_c1, sign}, false, side, range));
  else
    outline.within = sign(c0) == 0;
}

/// The outline of a case: its roots up to the first proper crossing or, where all is asked, every
/// one. Roots that are no crossings are listed too, each with its standing.
template <int apex, class N, class G, std::size_t sides>
Outline settle(const Patch<Polynomial<N, 1>, G, sides>& patch, const Range<N>& range,
               Signs<N>& sign, bool /*all*/) {
  Outline outline;
  settle_linear<apex>(outline, patch.field.c[0], patch.field.c[1], patch.side, range, sign);
  outline.unsure = sign.unsure;
  return outline;
}

template <int apex, class N, class G, std::size_t sides>
Outline settle(const Patch<Polynomial<N, 2>, G, sides>& patch, const Range<N>& range,
               Signs<N>& sign, bool all) {
  const auto& [c, b, a] = patch.field.c;
  Outline outline;
  const int sign_a = sign(a);
  if (sign.unsure) return {.unsure = true};
  if (sign_a == 0) {
    settle_linear<apex>(outline, c, b, patch.side, range, sign);
    outline.unsure = sign.unsure;
    return outline;
  }
  const int sign_d = sign(squared(b) - twice(twice(N(a * c))));
  if (sign.unsure) return {.unsure = true};
  if (sign_d < 0) return outline;
  const auto root = [&](Which which) {
    return outlined<apex, N>(QuadraticRoot<N>{patch.field, sign_a, which, sign}, sign_a > 0,
                             patch.side, range);
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

}  // namespace rayaudit::oracle
