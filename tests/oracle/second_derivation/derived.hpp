#pragma once

#include <CGAL/Gmpq.h>

#include <bit>
#include <cstdint>
#include <functional>
#include <limits>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "geometry/case.hpp"
#include "geometry/case_line.hpp"
#include "oracle/truth.hpp"

/// Crossings derived a second time, by ways that share nothing with the oracle.
namespace rayaudit::second {

using Rational = CGAL::Gmpq;

/// An exact number t, known by how it compares: the sign of t - q for every rational q.
using Number = std::function<int(const Rational& q)>;

inline Number number(const Rational& t) {
  return [t](const Rational& q) { return static_cast<int>(CGAL::compare(t, q)); };
}

/// The sign of t - x for a double, infinities too.
inline int compare(const Number& t, double x) {
  if (std::isinf(x)) return x > 0 ? -1 : 1;
  return t(Rational(x));
}

inline Rational power_of_two(int exponent) {
  const Rational power(CGAL::Gmpz(1) << static_cast<unsigned long>(std::abs(exponent)));
  return exponent < 0 ? Rational(1) / power : power;
}

inline Rational rational(const Real& x) {
  return (Rational(x.high) + Rational(x.middle) + Rational(x.low)) * power_of_two(x.exponent);
}

inline Vec3<Rational> rational(const Vec3<double>& v) {
  return {Rational(v.x), Rational(v.y), Rational(v.z)};
}

/// A linear function of t.
struct Linear {
  Rational at_0, slope;

  friend Linear operator-(const Linear& a, const Linear& b) {
    return {a.at_0 - b.at_0, a.slope - b.slope};
  }
  friend Linear operator*(const Rational& s, const Linear& a) { return {s * a.at_0, s * a.slope}; }
  Rational root() const { return -at_0 / slope; }
  int sign(const Number& t) const {
    const int rise = CGAL::sign(slope);
    return rise == 0 ? static_cast<int>(CGAL::sign(at_0)) : rise * t(root());
  }
};

struct Crossing {
  oracle::Kind kind;
  Number t;
  Number t_last = t;  ///< of a within
};
using Crossings = std::vector<Crossing>;

/// From the crossings with the whole line, in order, those that make the truth on the range.
inline Crossings cut_to_range(Crossings on_line, const Ray<double>& ray) {
  Crossings kept;
  for (Crossing& crossing : on_line) {
    const bool within = crossing.kind == oracle::Kind::within;
    if (compare(within ? crossing.t_last : crossing.t, ray.t_min) < 0) continue;
    if (compare(crossing.t, ray.t_max) > 0) continue;
    if (within) {
      if (compare(crossing.t, ray.t_min) < 0) crossing.t = number(Rational(ray.t_min));
      if (compare(crossing.t_last, ray.t_max) > 0) crossing.t_last = number(Rational(ray.t_max));
    } else {
      if (compare(crossing.t, ray.t_min) == 0) crossing.kind = oracle::Kind::start;
      if (compare(crossing.t, ray.t_max) == 0) crossing.kind = oracle::Kind::end;
    }
    kept.push_back(std::move(crossing));
    if (kept.back().kind == oracle::Kind::proper) break;
  }
  return kept;
}

/// The largest double not above t, for messages.
inline double about(const Number& t) {
  const auto ordered = [](std::int64_t place) {
    const double x = std::bit_cast<double>(place < 0 ? -place : place);
    return place < 0 ? -x : x;
  };
  std::int64_t above = std::bit_cast<std::int64_t>(std::numeric_limits<double>::infinity());
  std::int64_t below = -above;
  while (below + 1 < above) {
    const std::int64_t middle = std::midpoint(below, above);
    (compare(t, ordered(middle)) < 0 ? above : below) = middle;
  }
  return ordered(below);
}

inline std::string words(const Crossings& crossings) {
  std::string text = std::to_string(crossings.size()) + ":";
  for (const Crossing& crossing : crossings) {
    text += " " + std::string(name(crossing.kind)) + " ";
    write(text, about(crossing.t));
    if (crossing.kind == oracle::Kind::within) write(text += " ", about(crossing.t_last));
  }
  return text;
}

inline std::string words(const oracle::Truth& truth) {
  std::string text = std::to_string(truth.count) + ":";
  for (const oracle::Crossing& crossing : truth.crossings()) {
    write(text += " " + std::string(name(crossing.kind)) + " ", crossing.t);
    if (crossing.kind == oracle::Kind::within) write(text += " ", crossing.t_last);
  }
  return text;
}

}  // namespace rayaudit::second
