#include "oracle/prepared.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rayaudit::oracle {
namespace {

bool is_zero(const Vec3<double>& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

Invalid flaw(const Disk<double>& disk) {
  return is_zero(disk.normal) ? Invalid::zero_normal : Invalid::no;
}
Invalid flaw(const Sphere<double>&) { return Invalid::no; }
template <class S>
Invalid flaw(const S& shape) {
  const auto& [base, end, radius] = shape;
  return base == end ? Invalid::zero_axis : Invalid::no;
}

Invalid not_finite(const Case& question) {
  bool nan = std::isnan(question.ray.t_min) || std::isnan(question.ray.t_max), infinite = false;
  each_number(question, [&](double x) {
    nan |= std::isnan(x);
    infinite |= std::isinf(x);
  });
  return nan ? Invalid::nan : infinite ? Invalid::infinite : Invalid::no;
}

/// The exponent of the largest component seen, the smallest int where all are 0.
struct Largest {
  double most = 0;

  void see(double x) { most = std::max(most, std::fabs(x)); }
  void see(const Vec3<double>& v) { see(v.x), see(v.y), see(v.z); }
  int exponent() const { return most == 0 ? 0 : std::ilogb(most); }
};

/// Multiplies by powers of two and notes whether a bit was lost.
struct Scaler {
  bool exact = true;

  void operator()(double& x, int exponent) {
    const double before = x;
    x = std::ldexp(x, exponent);
    if (std::isfinite(before)) exact = exact && std::ldexp(x, -exponent) == before;
  }
  void operator()(Vec3<double>& v, int exponent) {
    (*this)(v.x, exponent), (*this)(v.y, exponent), (*this)(v.z, exponent);
  }
};

}  // namespace

bool is_moderate(const Case& question) {
  // The bits of |x|, doubled, count up as |x| does.
  constexpr auto size = [](double x) { return std::bit_cast<std::uint64_t>(x) << 1; };
  constexpr std::uint64_t least = size(0x1p-64), most = size(0x1p64);
  bool moderate = true;
  const auto look = [&](double x) {
    const std::uint64_t bits = size(x);
    moderate &= static_cast<bool>((bits - least <= most - least) | (bits == 0));
  };
  each_number(question, look);
  const double infinity = std::numeric_limits<double>::infinity();
  if (question.ray.t_min != -infinity) look(question.ray.t_min);
  if (question.ray.t_max != infinity) look(question.ray.t_max);
  return moderate;
}

Invalid invalid(const Case& question, bool moderate) {
  if (!moderate)
    if (const Invalid why = not_finite(question); why != Invalid::no) return why;
  if (is_zero(question.ray.direction)) return Invalid::zero_direction;
  return std::visit(
      [&](const auto& shape) {
        if (const Invalid why = flaw(shape); why != Invalid::no) return why;
        if (!(shape.radius > 0)) return Invalid::radius;
        return question.ray.t_min < question.ray.t_max ? Invalid::no : Invalid::empty_range;
      },
      question.shape);
}

Scaled scaled(const Case& question) {
  Scaled result{question};
  Ray<double>& ray = result.question.ray;
  Largest length, direction;
  length.see(ray.origin);
  direction.see(ray.direction);
  std::visit(
      [&](const auto& shape) {
        each_part(shape, [&](Part kind, const auto& part) {
          if (kind != Part::vector) length.see(part);
        });
      },
      question.shape);
  result.length = length.exponent();
  result.direction = direction.exponent();
  Scaler scale;
  scale(ray.origin, -result.length);
  scale(ray.direction, -result.direction);
  scale(ray.t_min, -result.t_exponent());
  scale(ray.t_max, -result.t_exponent());
  std::visit(
      [&](auto& shape) {
        each_part(shape, [&](Part kind, auto& part) {
          Largest own;
          own.see(part);
          scale(part, kind == Part::vector ? -own.exponent() : -result.length);
        });
      },
      result.question.shape);
  if (scale.exact) return result;
  return {.question = question, .exact = false};
}

}  // namespace rayaudit::oracle
