#include "oracle/margin.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "oracle/fields.hpp"
#include "oracle/fused.hpp"
#include "oracle/prepared.hpp"
#include "oracle/weighed.hpp"

namespace rayaudit::oracle {
namespace {

using weighed::Fine;
using weighed::Surd;
using weighed::Word;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How many numbers a case has, and as many more as make loops over them even.
template <class S>
constexpr std::size_t variable_count() {
  std::size_t count = 3 + 3 + 2;
  for (const Part kind : S::kinds) count += kind == Part::length ? 1 : 3;
  return (count + 3) / 4 * 4;
}

/// The numbers of a case as variables, in the order in which they are asked for, and how far each
/// may move.
template <class V, std::size_t n>
struct Variables {
  using Number = Dual<V, n>;

  std::array<double, n> weight = {};
  std::size_t next = 0;

  Number operator()(double x) { return variable(x, std::fabs(x)); }
  Vec3<Number> operator()(const Vec3<double>& v) {
    const double most = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    return {variable(v.x, most), variable(v.y, most), variable(v.z, most)};
  }

 private:
  Number variable(double x, double most) {
    weight[next] = most;
    Number number(V(x), next++);
    set_weight(number.value, most);
    return number;
  }
};

template <class N>
Polynomial<N, 0> constant(const N& x) {
  return {{x}};
}
template <class N>
Vec3<Polynomial<N, 0>> constant(const Vec3<N>& v) {
  return {{{v.x}}, {{v.y}}, {{v.z}}};
}

/// The t at which the ray is nearest to the shape's first point, about; from there on little
/// cancels.
template <class S>
double middle(const Ray<double>& ray, const S& shape) {
  static_assert(S::kinds[0] == Part::point);
  const Vec3<double>& d = ray.direction;
  const double t = dot(std::get<0>(shape.parts()) - ray.origin, d) / dot(d, d);
  return std::isfinite(t) ? t : 0;
}

double largest(const Vec3<double>& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}
double largest(double x) { return std::fabs(x); }

/// About how long t takes through the shape.
template <class S>
double extent(const Ray<double>& ray, const S& shape) {
  double most = 0;
  std::size_t i = 0;
  const auto see = [&](const auto& part) {
    const Part kind = S::kinds[i++];
    if constexpr (requires { part.x; }) {
      if (kind == Part::point) most = std::max(most, largest(part - std::get<0>(shape.parts())));
    } else {
      most = std::max(most, largest(part));
    }
  };
  std::apply([&](const auto&... part) { (see(part), ...); }, shape.parts());
  return most / largest(ray.direction);
}

/// A t as num / den, either of which may be 0.
template <class N>
struct Ratio {
  N num, den;
};

/// What it takes for a root to be no crossing any more, or to become one.
struct Change {
  bool is_crossing = true;
  Margin lose = {.reach = infinity};          ///< the cheapest of its signs flips
  Margin gain = {.reach = 0, .together = 0};  ///< all of its rejections flip

  void see(const Margin& flip, bool negative) {
    if (negative) {
      is_crossing = false;
      const auto together = static_cast<std::int8_t>(gain.together + 1);
      if (flip.reach >= gain.reach) gain = flip;
      gain.together = together;
    } else if (flip.reach < lose.reach) {
      lose = flip;
    }
  }
};

/// What must flip for two things to hold; nothing of what holds already.
Margin both(const Margin& a, const Margin& b) {
  Margin all = a.reach < b.reach ? b : a;
  all.together = static_cast<std::int8_t>(a.together + b.together);
  return all;
}
/// For the cheaper of two.
const Margin& either(const Margin& a, const Margin& b) { return b.reach < a.reach ? b : a; }

constexpr Margin holds = {.reach = 0, .together = 0};
constexpr Margin never = {.reach = infinity};

/// What of a shape there is, beside its patch.
struct Cut {
  Extent extent = Extent::bounded;
  unsigned caps = 0;
};

/// The ways to change the truth of a case along its ray, t counted from its middle; P is the patch
/// restricted to the ray.
template <class V, std::size_t n, int apex, class P>
struct Ways {
  using Number = Dual<V, n>;
  using Slope = typename Number::Slope;
  using Linear = Polynomial<Number, 1>;
  using Quadratic = Polynomial<Number, 2>;
  using Place = Ratio<Number>;

  struct Scale {
    std::array<Slope, n> by = {};
  };

  const std::array<double, n>& weight;
  const P& patch;
  bool has_start, has_end;
  Number start, end;
  double extent;
  Cut cut;
  bool sure = true;  ///< false where V did not tell; nothing else counts then
  Margin least = {.reach = infinity};

  /// What it costs to flip the sign of s / |scale|^degree: at most 1, for a vector or a length that
  /// moves by all of itself may vanish.
  Margin flip(const Number& s, const Scale& scale, int degree, Sign sign, int side) {
    using std::fabs;
    const Slope size = fabs(leading(s.value));
    const Slope factor = static_cast<Slope>(degree) * leading(s.value);
    Slope move = 0;
    for (std::size_t i = 0; i < n; ++i) move += fabs(s.by[i] - factor * scale.by[i]) * weight[i];
    move = std::max(size, move);
    sure = sure && is_known(s.value) && is_known_sum(move, s.value);
    return {.reach = size == 0 ? 0 : static_cast<double>(size / move),
            .sign = sign,
            .side = static_cast<std::int8_t>(side)};
  }

  /// D and D / A are alike near 0. Where A is 0 the one says more, where A vanishes together with
  /// B, so that D comes to 0 with no change in the truth, the other.
  Margin flip_discriminant(const Number& d, const Number& a) {
    const Margin plain = flip(d, {}, 1, Sign::discriminant, 0);
    const Margin by_a = flip(d, scale_of(Number(), a, 1), 1, Sign::discriminant, 0);
    return plain.reach < by_a.reach ? by_a : plain;
  }

  /// The slopes of log |(num, den length)|: of the size of a root's two numbers, in the measure of
  /// the shape. A sign divided by it is that of an angle, which has no poles and is the same
  /// however the root is written.
  static Scale scale_of(const Number& num, const Number& den, double length) {
    const Slope a = leading(num.value), b = leading(den.value) * length;
    const Slope all = a * a + b * b, by_num = all > 0 ? a / all : 0,
                by_den = all > 0 ? b / all * length : 0;
    Scale scale;
    for (std::size_t i = 0; i < n; ++i) scale.by[i] = by_num * num.by[i] + by_den * den.by[i];
    return scale;
  }

  int sign_of(const Number& x) {
    sure = sure && is_known(x.value);
    return (leading(x.value) > 0) - (leading(x.value) < 0);
  }

  static Number at(const Place& t, const Linear& g) { return t.den * g.c[0] + t.num * g.c[1]; }
  static Number at(const Place& t, const Quadratic& g) {
    return g.c[0] * squared(t.den) + g.c[1] * (t.num * t.den) + g.c[2] * squared(t.num);
  }

  static constexpr std::size_t side_count = std::tuple_size_v<decltype(P::side)>;

  bool counts(int i) const {
    return cut.extent == Extent::bounded || (cut.extent == Extent::unbounded && i == apex);
  }
  bool is_endless() const { return side_count > 0 && cut.extent != Extent::bounded; }

  /// What a root asks for.
  template <class G>
  Change change(const Place& t, const G& side, bool opens_outward) {
    Change found = change_in_reach(t, side, opens_outward);
    if (!is_endless()) return found;
    Margin parallel = flip(t.den, scale_of(t.num, t.den, extent), 1, Sign::discriminant, 0);
    // A ray along a plane misses it but where it begins, so there no root need be far.
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(patch.field)>, Linear>)
      parallel = either(parallel, flip(t.den, {}, 1, Sign::discriminant, 0));
    if (found.is_crossing)
      found.lose = either(found.lose, parallel);
    else if (is_met_beyond_infinity(t, side))
      found.gain = either(found.gain, parallel);
    return found;
  }

  /// An endless surface is met far out, too: is a root still one once it has gone through infinity?
  template <class G>
  bool is_met_beyond_infinity(const Place& t, const G& side) {
    const Slope num = leading(t.num.value), den = leading(t.den.value);
    const bool comes_last = (num < 0) == (den > 0);
    if (comes_last ? has_end : has_start) return false;
    if constexpr (apex >= 0)
      if (counts(apex)) return (leading(side[apex].c[1].value) > 0) == comes_last;
    return true;
  }

  /// What a root asks for while it does not go through infinity; of one there, the less of what it
  /// asks for at either end.
  template <class G>
  Change change_in_reach(const Place& t, const G& side, bool opens_outward) {
    const bool at_infinity = leading(t.den.value) == 0 || !is_known(t.den.value);
    const Change found = change(t, side, opens_outward, leading(t.den.value) < 0);
    if (!at_infinity) return found;
    const Change before = change(t, side, opens_outward, leading(t.den.value) >= 0);
    return before.gain.reach < found.gain.reach ? before : found;
  }

  /// Its signs are taken without a division, so that none flips while the root goes through
  /// infinity: that alone changes no truth of a bounded shape.
  template <class G, std::size_t sides>
  Change change(const Place& t, const std::array<G, sides>& side, bool opens_outward, bool turned) {
    Change found;
    const Scale scale = scale_of(t.num, t.den, extent);
    const auto see = [&](const Number& s, int degree, Sign sign, int i) {
      const bool odd = degree == 1;
      found.see(flip(s, scale, degree, sign, i),
                (odd && turned ? -leading(s.value) : leading(s.value)) < 0);
    };
    if (has_start) see(t.num - t.den * start, 1, Sign::start, 0);
    if (has_end) see(t.den * end - t.num, 1, Sign::end, 0);
    for (int i = 0; i < static_cast<int>(sides); ++i) {
      if (!counts(i)) continue;
      const Number s = at(t, side[i]);
      if (i != apex || opens_outward)
        see(s, std::is_same_v<G, Linear> ? 1 : 2, Sign::side, i);
      else if (turned ? leading(s.value) > 0 : leading(s.value) < 0)
        // On the other nappe, where it stays.
        found.see({.reach = infinity, .sign = Sign::side, .side = apex}, true);
    }
    return found;
  }

  void take(Margin way, int root) {
    way.root = static_cast<std::int8_t>(root);
    if (way.reach < least.reach) least = way;
  }

  /// Counts a root in; true where it is the hit.
  template <class G>
  bool ends_with(const Place& t, int root, const G& side, bool opens_outward) {
    const Change found = change(t, side, opens_outward);
    take(found.is_crossing ? found.lose : found.gain, root);
    return found.is_crossing;
  }

  template <class G>
  void settle(const Linear& f, const G& side) {
    if (vanishes(f)) return settle_within(side);
    ends_with(Place{-f.c[0], f.c[1]}, 0, side, true);
  }

  template <class G>
  void settle(const Quadratic& f, const G& side) {
    const auto& [c, b, a] = f.c;
    const Number d = squared(b) - twice(twice(a * c));
    const int sign_d = sign_of(d);
    if (!sure) return;
    if constexpr (std::is_same_v<G, std::array<Linear, 2>>)
      if (cut.caps != 0 && !vanishes(f)) return settle_closed(f, d, sign_d);
    if (sign_d > 0)
      settle_two(f, d, side);
    else if (vanishes(f))
      settle_within(side);
    else
      settle_none(f, d, side);
  }

  /// D <= 0: a crossing may appear where a double root would. Of a line that is steeper than the
  /// cone D = 0 is the least: it is a hit at the apex, or rejected.
  template <class G>
  void settle_none(const Quadratic& f, const Number& d, const G& side) {
    const auto& [c, b, a] = f.c;
    const bool opens_outward = apex < 0 || leading(a.value) >= 0;
    Change found = change(leading(a.value) == 0 ? Place{twice(c), -b} : Place{-b, twice(a)}, side,
                          opens_outward);
    if (opens_outward) found.see(flip_discriminant(d, a), true);
    take(found.is_crossing ? found.lose : found.gain, 0);
  }

  /// The roots are m / 2A and 2C / m with m = -(B + sign(B) sqrt(D)), which does not cancel.
  template <class G>
  void settle_two(const Quadratic& f, const Number& d, const G& side) {
    const auto& [c, b, a] = f.c;
    const int sign_a = sign_of(a);
    const bool opens_outward = apex < 0 || sign_a > 0, positive = leading(b.value) >= 0;
    const Number root = root_of(d), m = positive ? -(b + root) : root - b;
    const Place by_a = {m, twice(a)}, by_c = {twice(c), m};
    const bool smaller_by_a = positive == (sign_a > 0);
    const bool hit = ends_with(smaller_by_a ? by_a : by_c, 0, side, opens_outward) ||
                     ends_with(smaller_by_a ? by_c : by_a, 1, side, opens_outward);
    if (hit && opens_outward) take(flip_discriminant(d, a), 0);
  }

  /// A bound of the stretch that the line has in common with a closed shape: a root of F, or a
  /// cap's where cap >= 0.
  struct Bound {
    Place t;
    int cap = -1, root = 0;
  };
  struct Bounds {
    std::array<Bound, 3> listed = {};
    std::size_t count = 0;

    void add(const Bound& bound) { listed[count++] = bound; }
    auto begin() const { return listed.begin(); }
    auto end() const { return listed.begin() + count; }
  };

  /// What it takes for s to be above 0, or for it not to be.
  static Margin taken(Margin flip, const Bound& at, bool holds_already) {
    if (holds_already) return holds;
    flip.root = static_cast<std::int8_t>(at.root);
    flip.patch = static_cast<std::int8_t>(at.cap + 1);
    return flip;
  }

  /// What it takes for a bound to lie before the start or end of the range, or behind it. That of a
  /// cap is told by the cap's side condition there, whatever the bound does far away.
  Margin beside(const Bound& bound, Sign sign, bool behind) {
    const Number& end_of_range = sign == Sign::start ? start : end;
    const Number s = bound.t.num - bound.t.den * end_of_range;
    const bool is_behind = (leading(s.value) > 0) == (leading(bound.t.den.value) > 0);
    const Margin cost = flip(s, scale_of(bound.t.num, bound.t.den, extent), 1, sign, 0);
    return taken(cost, bound, is_behind == behind);
  }

  /// What it takes for a sign at a bound to be that.
  Margin sign_at(const Bound& bound, const Number& s, int degree, int side, bool positive) {
    const bool turned = degree == 1 && leading(bound.t.den.value) < 0;
    const bool is_positive = turned ? leading(s.value) < 0 : leading(s.value) > 0;
    const Margin cost =
        flip(s, scale_of(bound.t.num, bound.t.den, extent), degree, Sign::side, side);
    return taken(cost, bound, is_positive == positive);
  }

  /// Where F is below 0 along the line, on the cone's own nappe: from lower to upper, where it has
  /// these; and what else it takes for there to be such a stretch.
  struct Lateral {
    std::optional<Bound> lower, upper;
    Margin exists = holds, ceases = never;

    void needs(const Margin& gain, const Margin& loss) {
      exists = both(exists, gain);
      ceases = either(ceases, loss);
    }
  };

  Lateral lateral(const Quadratic& f, const Number& d, int sign_d) {
    const auto& [c, b, a] = f.c;
    const int sign_a = sign_of(a);
    Lateral found;
    if (sign_d > 0) {
      const bool positive = leading(b.value) >= 0;
      const Number root = root_of(d), m = positive ? -(b + root) : root - b;
      const Bound by_a = {{m, twice(a)}}, by_c = {{twice(c), m}};
      const bool smaller_by_a = positive == (sign_a > 0);
      Bound smaller = smaller_by_a ? by_a : by_c, larger = smaller_by_a ? by_c : by_a;
      larger.root = 1;
      if (sign_a > 0) {
        found.lower = smaller, found.upper = larger;
      } else if (sign_a == 0) {
        // The only root, which is by_c.
        (positive ? found.upper : found.lower) = by_c;
      } else if (sign_of(patch.side[1].c[1]) > 0) {
        found.lower = larger;
      } else {
        found.upper = smaller;
      }
    } else if (sign_a > 0) {
      found.lower = found.upper = Bound{{-b, twice(a)}};
    } else if (leading(c.value) > 0) {
      found.exists = flip(c, {}, 1, Sign::discriminant, 0);
    }
    if (sign_a > 0) {
      const Margin cost = flip_discriminant(d, a);
      found.needs(sign_d > 0 ? holds : cost, sign_d > 0 ? cost : holds);
    }
    if constexpr (apex >= 0)
      // A steep line keeps its nappe.
      for (const auto& bound : {found.lower, found.upper})
        if (bound && sign_a >= 0) {
          const Number h = at(bound->t, patch.side[apex]);
          found.needs(sign_at(*bound, h, 1, apex, true), sign_at(*bound, h, 1, apex, false));
        }
    return found;
  }

  /// Is a root further off than another?
  static bool is_farther(const Place& t, const Place& other) {
    using std::fabs;
    return fabs(leading(t.num.value) * leading(other.den.value)) >
           fabs(leading(other.num.value) * leading(t.den.value));
  }

  /// What it takes for a root of F to come to lie on a cap's inner side, or outer side. Where it
  /// gets there F vanishes at the cap's own root, and what is nearer tells it better; but on the
  /// way out F may vanish there by its other root.
  Margin at_edge(const Bound& bound, int cap, bool inside) {
    const Margin by_side = sign_at(bound, at(bound.t, patch.side[cap]), 1, cap, inside);
    const Bound own = {cap_root(cap), cap};
    if (by_side.together == 0 || is_farther(own.t, bound.t)) return by_side;
    const Number f = at(own.t, patch.field);
    const Margin by_field =
        taken(flip(f, scale_of(own.t.num, own.t.den, extent), 2, Sign::side, cap), own, false);
    return inside || by_side.reach < by_field.reach ? by_field : by_side;
  }

  Place cap_root(int cap) const { return {-patch.side[cap].c[0], patch.side[cap].c[1]}; }

  /// What it takes for the line to pass a cap inside its edge, or outside.
  Margin through_cap(int cap, bool inside) {
    const Bound own = {cap_root(cap), cap};
    return sign_at(own, at(own.t, patch.field), 2, cap, !inside);
  }

  /// A closed shape: the line has one stretch in common with it, from the last of its lower bounds
  /// to the first of its upper ones. The truth is where that begins, where it ends, or that there
  /// is none of it in the range; the margin is the least that it takes for another of these.
  void settle_closed(const Quadratic& f, const Number& d, int sign_d) {
    const Lateral side_wall = lateral(f, d, sign_d);
    Bounds lower, upper;
    Margin exists = side_wall.exists, ceases = side_wall.ceases;
    Margin leaves_caps = holds, enters_cap = never;
    int passed = 0;
    if (side_wall.lower) lower.add(*side_wall.lower);
    if (side_wall.upper) upper.add(*side_wall.upper);
    for (int i = 0; i < 2; ++i) {
      if ((cut.caps >> i & 1U) == 0) continue;
      const int rise = sign_of(patch.side[i].c[1]);
      if (rise != 0) (rise > 0 ? lower : upper).add({cap_root(i), i});
      // Something is left inside the cap where one end is; far out the rise of the line tells.
      Margin left = never, gone = holds;
      const auto meet = [&](const Bound& bound) {
        left = either(left, at_edge(bound, i, true));
        gone = both(gone, at_edge(bound, i, false));
      };
      const bool by_lower = side_wall.lower && (rise <= 0 || side_wall.upper);
      const bool by_upper = side_wall.upper && (rise >= 0 || side_wall.lower);
      if (by_lower) meet(*side_wall.lower);
      if (by_upper) meet(*side_wall.upper);
      if (by_lower || by_upper) {
        exists = both(exists, left);
        ceases = either(ceases, gone);
      }
      if (rise != 0) {
        passed += through_cap(i, true).together == 0 ? 1 : 0;
        leaves_caps = both(leaves_caps, through_cap(i, false));
        enters_cap = either(enters_cap, through_cap(i, true));
      }
    }
    // Outside the endless surface a line comes in by a cap, too; and one that comes in by one and
    // goes out by the other has left neither before it has left both.
    if (sign_d <= 0) exists = either(exists, enters_cap);
    if (passed == 2) ceases = leaves_caps;
    take_other_than_truth(lower, upper, exists, ceases);
  }

  void take_other_than_truth(const Bounds& lower, const Bounds& upper, const Margin& exists,
                             const Margin& ceases) {
    const auto all = [&](const Bounds& bounds, Sign sign, bool behind) {
      Margin cost = holds;
      for (const Bound& bound : bounds) cost = both(cost, beside(bound, sign, behind));
      return cost;
    };
    const auto any = [&](const Bounds& bounds, Sign sign, bool behind) {
      Margin cost = never;
      for (const Bound& bound : bounds) cost = either(cost, beside(bound, sign, behind));
      return cost;
    };
    Margin begins = exists, ends = has_start ? exists : never, misses = ceases;
    if (has_start) {
      begins = both(begins, any(lower, Sign::start, true));
      ends = both(both(ends, all(lower, Sign::start, false)), all(upper, Sign::start, true));
      misses = either(misses, any(upper, Sign::start, false));
    }
    if (has_end) {
      begins = both(begins, all(lower, Sign::end, false));
      ends = both(ends, any(upper, Sign::end, false));
      misses = either(misses, any(lower, Sign::end, true));
    }
    if (has_start && has_end)
      misses = either(misses, both(all(lower, Sign::start, false), all(upper, Sign::end, true)));
    for (const Margin& other : {begins, ends, misses})
      if (other.reach > 0 && other.reach < least.reach) least = other;
  }

  static Number root_of(const Number& d) {
    Number root(sqrt(d.value));
    const Slope by_d = 1 / (2 * leading(root.value));
    for (std::size_t i = 0; i < n; ++i) root.by[i] = by_d * d.by[i];
    return root;
  }

  template <int degree>
  bool vanishes(const Polynomial<Number, degree>& f) {
    bool all = true;
    for (const Number& c : f.c) all = all && leading(c.value) == 0;
    sure = sure && !(all && !is_known(f.c[0].value));
    return all;
  }

  /// The line lies in the surface, and no part of it within the range and the side conditions: the
  /// ends of the stretch are then the crossings.
  void settle_within(const std::array<Quadratic, 1>& side) {
    settle(side[0], std::array<Linear, 0>{});
  }
  template <std::size_t sides>
  void settle_within(const std::array<Linear, sides>& side) {
    std::array<Linear, sides + 2> g;
    std::array<Margin, sides + 2> named;
    std::size_t count = 0;
    const auto add = [&](const Linear& condition, Sign sign, std::size_t i) {
      g[count] = condition;
      named[count++] = {.sign = sign, .side = static_cast<std::int8_t>(i)};
    };
    for (std::size_t i = 0; i < sides; ++i)
      if (counts(static_cast<int>(i))) add(side[i], Sign::side, i);
    if (has_start) add({{-start, Number(V(1))}}, Sign::start, 0);
    if (has_end) add({{end, Number(V(-1))}}, Sign::end, 0);
    Change found;
    const auto see = [&](const Number& s, const Margin& name) {
      if (sign_of(s) < 0) found.see(flip(s, Scale(), 1, name.sign, name.side), true);
    };
    for (std::size_t i = 0; i < count; ++i) {
      if (sign_of(g[i].c[1]) == 0) see(g[i].c[0], named[i]);
      for (std::size_t j = 0; j < count; ++j)
        if (sign_of(g[i].c[1]) < 0 && sign_of(g[j].c[1]) > 0)
          see(g[i].c[0] * g[j].c[1] - g[i].c[1] * g[j].c[0], named[std::max(i, j)]);
    }
    take(found.gain, 0);
  }
};

/// The margin of a case; nothing where V does not tell.
template <class V, template <class> class S>
std::optional<Margin> margin_in(const Ray<double>& ray, const S<double>& shape, const Cut& cut) {
  constexpr std::size_t n = variable_count<S<double>>();
  using Number = Dual<V, n>;
  using Linear = Polynomial<Number, 1>;
  Variables<V, n> variable;
  const Number centre(V(middle(ray, shape)));
  const Vec3<Number> o = variable(ray.origin), d = variable(ray.direction);
  const Vec3<Linear> p = {
      {{o.x + centre * d.x, d.x}}, {{o.y + centre * d.y, d.y}}, {{o.z + centre * d.z, d.z}}};
  const auto constants = std::apply(
      [&](const auto&... part) { return S<Polynomial<Number, 0>>{constant(variable(part))...}; },
      shape.parts());
  const auto restricted = patch(constants, p);
  const bool has_start = std::isfinite(ray.t_min), has_end = std::isfinite(ray.t_max);
  const Number start = has_start ? variable(ray.t_min) - centre : Number();
  const Number end = has_end ? variable(ray.t_max) - centre : Number();
  Ways<V, n, apex_side<S<double>>, std::remove_const_t<decltype(restricted)>> ways{
      variable.weight, restricted, has_start, has_end, start, end, extent(ray, shape), cut};
  ways.settle(restricted.field, restricted.side);
  if (!ways.sure) return {};
  return ways.least;
}

template <class V>
std::optional<Margin> margin_in(const Case& question) {
  const Cut cut = {question.extent};
  const auto in_shape = [&]<class S>(const S& shape) {
    // With the numbers and the text of the open shape, which are the same.
    if constexpr (caps<S> == 0)
      return margin_in<V>(question.ray, shape, cut);
    else if constexpr (apex_side<S> < 0)
      return margin_in<V>(question.ray, Cylinder<double>{shape.base, shape.top, shape.radius},
                          {.caps = caps<S>});
    else
      return margin_in<V>(question.ray, Cone<double>{shape.base, shape.apex, shape.radius},
                          {.caps = caps<S>});
  };
  return std::visit(in_shape, question.shape);
}

/// A reach is above 0, for there is no touch; and a number that moves by all of itself may vanish.
std::optional<Margin> within_reach(std::optional<Margin> margin) {
  if (margin) margin->reach = std::clamp(margin->reach, std::numeric_limits<double>::min(), 1.0);
  return margin;
}

}  // namespace

std::string_view name(Sign sign) {
  constexpr std::array<std::string_view, 5> names = {"touch", "discriminant", "start", "end",
                                                     "side"};
  return names[static_cast<std::size_t>(sign)];
}

std::optional<Margin> margin_by_bounds(const Case& question) {
  const Scaled scale = is_moderate(question) ? Scaled{question} : scaled(question);
  if (!scale.exact) return {};
#ifdef __x86_64__
  if (has_fused()) return within_reach(margin_in<Word<true>>(scale.question));
#endif
  return within_reach(margin_in<Word<false>>(scale.question));
}

Margin margin_exactly(const Case& question) {
  const Case near = is_moderate(question) ? question : scaled(question).question;
  const std::optional<Margin> told = within_reach(margin_in<Surd<long double>>(near));
  return told ? *told : *within_reach(margin_in<Surd<Fine>>(near));
}

Margin margin(const Case& question, const Truth& truth) {
  if (truth.has_touch()) return {.reach = 0, .sign = Sign::touch};
  const std::optional<Margin> told = margin_by_bounds(question);
  return told ? *told : margin_exactly(question);
}

}  // namespace rayaudit::oracle
