#pragma once

#include <memory>

#include "tests/oracle/second_derivation/solid.hpp"

/// Cylinder and cone in rational numbers: the case is carried to a frame along the axis, whose
/// other two vectors are orthogonal but not normed, and the roots are told apart by a Sturm
/// sequence.
namespace rayaudit::second {

/// Coefficients from the constant up, the last not 0; the zero polynomial has none.
using Polynomial = std::vector<Rational>;

inline Polynomial trimmed(Polynomial p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
  return p;
}

inline int degree(const Polynomial& p) { return static_cast<int>(p.size()) - 1; }

inline Polynomial derivative(const Polynomial& p) {
  Polynomial slope;
  for (std::size_t i = 1; i < p.size(); ++i) slope.push_back(Rational(static_cast<int>(i)) * p[i]);
  return slope;
}

/// The sum of s_i g_i^2.
inline Polynomial sum_of_squares(const std::vector<std::pair<Rational, Linear>>& terms) {
  Polynomial sum(3, Rational(0));
  for (const auto& [s, g] : terms) {
    sum[0] += s * g.at_0 * g.at_0;
    sum[1] += s * 2 * g.at_0 * g.slope;
    sum[2] += s * g.slope * g.slope;
  }
  return trimmed(sum);
}

inline std::pair<Polynomial, Polynomial> divided(Polynomial p, const Polynomial& by) {
  Polynomial quotient(p.size() < by.size() ? 0 : p.size() - by.size() + 1, Rational(0));
  for (std::size_t i = quotient.size(); i-- > 0;) {
    quotient[i] = p[i + by.size() - 1] / by.back();
    for (std::size_t j = 0; j < by.size(); ++j) p[i + j] -= quotient[i] * by[j];
  }
  return {quotient, trimmed(p)};
}

inline Polynomial common_divisor(Polynomial a, Polynomial b) {
  while (!b.empty()) a = std::exchange(b, divided(a, b).second);
  return a;
}

inline Rational value(const Polynomial& p, const Rational& t) {
  Rational sum = 0;
  for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
  return sum;
}

/// The distinct real roots of a polynomial that is not zero, counted from below by sign variations
/// (Sturm 1829).
class RealRoots {
 public:
  explicit RealRoots(const Polynomial& p) : repeated_(common_divisor(p, derivative(p))) {
    chain_ = {divided(p, repeated_).first};
    chain_.push_back(derivative(chain_[0]));
    while (!chain_.back().empty()) {
      Polynomial rest = divided(chain_[chain_.size() - 2], chain_.back()).second;
      for (Rational& c : rest) c = -c;
      chain_.push_back(std::move(rest));
    }
    chain_.pop_back();
  }

  int count() const { return variations_at_end(-1) - variations_at_end(1); }

  /// The sign of the k-th root, from 0, minus q.
  int compare(int k, const Rational& q) const {
    const int up_to_q = variations_at_end(-1) - variations_at(q);
    if (up_to_q <= k) return 1;
    return up_to_q == k + 1 && value(chain_[0], q) == 0 ? 0 : -1;
  }

  /// Has the k-th root a multiplicity over 1? The repeated part is linear at most.
  bool is_double(int k) const {
    return degree(repeated_) == 1 && compare(k, -repeated_[0] / repeated_[1]) == 0;
  }

 private:
  template <class S>
  int variations(S&& sign_of) const {
    int changes = 0, last = 0;
    for (const Polynomial& p : chain_) {
      const int sign = sign_of(p);
      changes += sign * last < 0;
      if (sign != 0) last = sign;
    }
    return changes;
  }
  int variations_at(const Rational& q) const {
    return variations([&](const Polynomial& p) { return CGAL::sign(value(p, q)); });
  }
  int variations_at_end(int end) const {
    return variations(
        [&](const Polynomial& p) { return CGAL::sign(p.back()) * (degree(p) % 2 == 0 ? 1 : end); });
  }

  Polynomial repeated_;
  std::vector<Polynomial> chain_;
};

/// A cylinder or cone as the curve of a point in the frame: x^2 / ff + y^2 / gg against the squared
/// radius at height z / ww, for 0 <= z <= ww.
struct InFrame {
  Linear x, y, z;
  Rational ff, gg, ww;
};

inline InFrame in_frame(const Ray<double>& ray, const Vec3<double>& from, const Vec3<double>& to) {
  const Vec3<Rational> a = rational(from);
  const Vec3<Rational> w = rational(to) - a;
  // The coordinate axis that is farthest from w gives the first vector across.
  const Rational xx = w.x * w.x, yy = w.y * w.y, zz = w.z * w.z;
  const bool x_least = xx <= yy && xx <= zz;
  const Vec3<Rational> across = {Rational(x_least ? 1 : 0), Rational(!x_least && yy <= zz ? 1 : 0),
                                 Rational(!x_least && yy > zz ? 1 : 0)};
  const Vec3<Rational> f = cross(w, across);
  const Vec3<Rational> g = cross(w, f);
  const Vec3<Rational> v = rational(ray.origin) - a;
  const Vec3<Rational> d = rational(ray.direction);
  const auto along = [&](const Vec3<Rational>& e) { return Linear{dot(v, e), dot(d, e)}; };
  return {along(f), along(g), along(w), dot(f, f), dot(g, g), dot(w, w)};
}

/// The crossings of a line with a lateral surface whose radius falls linearly from r at the base to
/// (1 - taper) r at the top; taper 0 is a cylinder, 1 a cone.
inline Crossings along_lateral_surface(const InFrame& frame, const Rational& r, int taper) {
  using oracle::Kind;
  const Rational& ww = frame.ww;
  const Linear from_base = frame.z;
  const Linear to_top = Linear{ww, 0} - frame.z;
  const Linear radius_ww = r * (Linear{ww, 0} - Rational(taper) * frame.z);
  const Polynomial off_surface = sum_of_squares({{Rational(1) / frame.ff, frame.x},
                                                 {Rational(1) / frame.gg, frame.y},
                                                 {Rational(-1) / (ww * ww), radius_ww}});
  if (off_surface.empty()) {
    Rational first = from_base.root(), last = to_top.root();
    if (last < first) std::swap(first, last);
    return {{Kind::within, number(first), number(last)}};
  }
  Crossings found;
  const auto roots = std::make_shared<const RealRoots>(off_surface);
  for (int k = 0; k < roots->count(); ++k) {
    const Number t = [roots, k](const Rational& q) { return roots->compare(k, q); };
    if (from_base.sign(t) < 0 || to_top.sign(t) < 0) continue;
    Kind kind = roots->is_double(k) ? Kind::tangent : Kind::proper;
    if (from_base.sign(t) == 0 || to_top.sign(t) == 0) kind = Kind::rim;
    const bool at_apex =
        taper == 1 && frame.x.sign(t) == 0 && frame.y.sign(t) == 0 && to_top.sign(t) == 0;
    // Far away, the line is outside the double cone where the leading coefficient is positive.
    if (at_apex) kind = degree(off_surface) == 2 && off_surface[2] > 0 ? Kind::apex : Kind::proper;
    found.push_back({kind, t});
  }
  return found;
}

/// A rational number between a < b.
inline Rational between(const Number& a, const Number& b) {
  // No t of ours is further off than this.
  const Rational far = power_of_two(4000);
  const double least = about(a), most = std::nextafter(about(b), INFINITY);
  Rational below = std::isinf(least) ? -far : Rational(least);
  Rational above = std::isinf(most) ? far : Rational(most);
  while (true) {
    const Rational middle = (below + above) / 2;
    if (a(middle) >= 0)
      below = middle;
    else if (b(middle) <= 0)
      above = middle;
    else
      return middle;
  }
}

/// The same surface with what closes it: the plane at the base, and at the top but of a cone.
struct Solid {
  InFrame frame;
  int taper;
  Linear to_top;
  Polynomial off_surface;  ///< negative inside

  Solid(const InFrame& in, const Rational& r, int t)
      : frame(in),
        taper(t),
        to_top(Linear{in.ww, 0} - in.z),
        off_surface(lateral(in, r * (Linear{in.ww, 0} - Rational(t) * in.z))) {}

  static Polynomial lateral(const InFrame& in, const Linear& radius_ww) {
    return sum_of_squares({{Rational(1) / in.ff, in.x},
                           {Rational(1) / in.gg, in.y},
                           {Rational(-1) / (in.ww * in.ww), radius_ww}});
  }

  /// From the signs of what is negative, positive and positive inside.
  static Place place(int off, int above_base, int below_top) {
    if (off > 0 || above_base < 0 || below_top < 0) return Place::outside;
    return off < 0 && above_base > 0 && below_top > 0 ? Place::inside : Place::on;
  }
  Place place(const Rational& t) const {
    const Number at = number(t);
    return place(CGAL::sign(value(off_surface, t)), frame.z.sign(at), to_top.sign(at));
  }
  bool is_apex(const Number& t) const { return taper == 1 && to_top.sign(t) == 0; }
  /// Does all of the line lie in the plane of a cap?
  bool lies_in_plane() const {
    const auto vanishes = [](const Linear& g) { return g.slope == 0 && g.at_0 == 0; };
    return vanishes(frame.z) || (taper == 0 && vanishes(to_top));
  }
  oracle::Kind touch(const Number& t) const {
    using oracle::Kind;
    if (lies_in_plane()) return Kind::within;
    if (is_apex(t)) return Kind::apex;
    return frame.z.sign(t) == 0 || to_top.sign(t) == 0 ? Kind::rim : Kind::tangent;
  }

  std::vector<Candidate> candidates() const {
    std::vector<Candidate> all;
    if (!off_surface.empty()) {
      const auto roots = std::make_shared<const RealRoots>(off_surface);
      for (int k = 0; k < roots->count(); ++k) {
        const Number t = [roots, k](const Rational& q) { return roots->compare(k, q); };
        all.push_back({t, place(0, frame.z.sign(t), to_top.sign(t)), touch(t)});
      }
    }
    for (const Linear& plane : {frame.z, to_top}) {
      if (plane.slope == 0) continue;
      const Rational q = plane.root();
      const auto is_before = [&](const Candidate& other) { return other.t(q) < 0; };
      const auto at = std::partition_point(all.begin(), all.end(), is_before);
      if (at != all.end() && at->t(q) == 0) continue;
      all.insert(at, {number(q), place(q), touch(number(q))});
    }
    return all;
  }
};

inline Crossings along_solid(const Solid& solid) {
  const std::vector<Candidate> candidates = solid.candidates();
  std::vector<Place> between_them(candidates.size() + 1, Place::outside);
  for (std::size_t i = 1; i < candidates.size(); ++i)
    between_them[i] = solid.place(between(candidates[i - 1].t, candidates[i].t));
  return on_line(candidates, between_them);
}

inline Crossings by_sturm(const Case& question) {
  const auto derive = [&](const Vec3<double>& from, const Vec3<double>& to, double r, int taper) {
    const InFrame frame = in_frame(question.ray, from, to);
    const bool closed = question.shape.index() >= 4;
    return cut_to_range(closed ? along_solid({frame, Rational(r), taper})
                               : along_lateral_surface(frame, Rational(r), taper),
                        question.ray);
  };
  if (const auto* cylinder = std::get_if<Cylinder<double>>(&question.shape))
    return derive(cylinder->base, cylinder->top, cylinder->radius, 0);
  if (const auto* cylinder = std::get_if<CappedCylinder<double>>(&question.shape))
    return derive(cylinder->base, cylinder->top, cylinder->radius, 0);
  if (const auto* cone = std::get_if<CappedCone<double>>(&question.shape))
    return derive(cone->base, cone->apex, cone->radius, 1);
  const auto& cone = std::get<Cone<double>>(question.shape);
  return derive(cone.base, cone.apex, cone.radius, 1);
}

}  // namespace rayaudit::second
