#include "audit/transformation.hpp"

#include <array>
#include <cmath>

namespace rayaudit {
namespace {

/// A verdict may turn by rounding alone at margins below so many u.
constexpr double beyond_rounding = 0x1p10;

/// Applies one function to every point, one to every vector and one to every length of a case.
template <class Point, class Vector, class Length>
Case changed(Case question, const Point& point, const Vector& vector, const Length& length) {
  question.ray.origin = point(question.ray.origin);
  question.ray.direction = vector(question.ray.direction);
  std::visit(
      [&]<class S>(S& shape) {
        std::size_t i = 0;
        const auto change = [&](auto& part) {
          if constexpr (requires { part.x; })
            part = S::kinds[i] == Part::point ? point(part) : vector(part);
          else
            part = length(part);
          ++i;
        };
        std::apply([&](auto&... part) { (change(part), ...); }, shape.parts());
      },
      question.shape);
  return question;
}

/// The case, where the format holds each of its numbers without loss and none of them is extreme.
std::optional<Case> held(const Case& question, const Format& format) {
  bool fits = true;
  each_number(question, [&](double x) {
    const double size = std::fabs(x);
    fits = fits && (x == 0 || (size > 0x1p-30 && size < 0x1p30));
    if (format == float_format) fits = fits && static_cast<double>(static_cast<float>(x)) == x;
  });
  if (!fits) return {};
  return question;
}

constexpr auto same = [](const auto& x) { return x; };
constexpr auto eightfold = [](const Vec3<double>& v) { return 8.0 * v; };

std::optional<Case> longer_direction(const Case& question, const Format& format) {
  Case made = question;
  made.ray.direction = eightfold(made.ray.direction);
  made.ray.t_min /= 8, made.ray.t_max /= 8;
  return held(made, format);
}

std::optional<Case> longer_normal(const Case& question, const Format& format) {
  Case made = question;
  auto* disk = std::get_if<Disk<double>>(&made.shape);
  if (disk == nullptr) return {};
  disk->normal = eightfold(disk->normal);
  return held(made, format);
}

std::optional<Case> larger(const Case& question, const Format& format) {
  Case made = changed(question, eightfold, same, [](double length) { return 8 * length; });
  made.ray.direction = eightfold(question.ray.direction);
  return held(made, format);
}

std::optional<Case> with_axes_in_turn(const Case& question, const Format& format) {
  const auto turn = [](const Vec3<double>& v) { return Vec3<double>{v.y, v.z, v.x}; };
  return held(changed(question, turn, turn, same), format);
}

std::optional<Case> mirrored(const Case& question, const Format& format) {
  const auto mirror = [](const Vec3<double>& v) { return Vec3<double>{-v.x, v.y, -v.z}; };
  return held(changed(question, mirror, mirror, same), format);
}

bool is_sum_exact(double a, double b) {
  const double sum = a + b;
  return sum - b == a && sum - a == b;
}

/// Moved by its own size, where the sums are exact.
std::optional<Case> moved(const Case& question, const Format& format) {
  double size = 0;
  each_number(question, [&](double x) { size = std::max(size, std::fabs(x)); });
  const double by = std::ldexp(1, std::ilogb(size) + 1);
  bool exact = true;
  const auto shift = [&](const Vec3<double>& p) {
    exact = exact && is_sum_exact(p.x, by) && is_sum_exact(p.y, by) && is_sum_exact(p.z, by);
    return Vec3<double>{p.x + by, p.y + by, p.z + by};
  };
  const Case made = changed(question, shift, same, same);
  return exact ? held(made, format) : std::nullopt;
}

constexpr std::array list = {
    Transformation{"the length of the direction", longer_direction, -3, true},
    Transformation{"the length of the normal", longer_normal, 0, true},
    Transformation{"the unit of length", larger, 0, true},
    Transformation{"which axis is which", with_axes_in_turn, 0, false},
    Transformation{"the sense of an axis", mirrored, 0, false},
    Transformation{"the place in the world", moved, 0, false},
};

/// Do two answers differ by more than the power of two that their t must differ by?
bool differ(const Answer& answer, const Answer& other, int t_exponent) {
  if (answer.form != other.form) return true;
  if (answer.form != Answer::Form::hit) return false;
  if (!is_finite(answer.t) || !is_finite(other.t)) return is_finite(answer.t) != is_finite(other.t);
  Real scaled = answer.t;
  scaled.exponent += t_exponent;
  return compare(scaled, other.t) != 0;
}

}  // namespace

std::span<const Transformation> transformations() { return list; }

std::string_view assumption_from_outside(const Wrong& wrong, const Subject& subject,
                                         const Convention& convention) {
  const Case& question = wrong.settled.question();
  const double margin = std::ldexp(wrong.settled.reach(), subject.format.precision);
  for (const auto& [about, change, t_exponent, to_the_bit] : transformations()) {
    const std::optional<Case> other =
        held(question, subject.format) ? change(question, subject.format) : std::optional<Case>();
    if (!other || (!to_the_bit && !(margin > beyond_rounding))) continue;
    const Answer said = answer_one(subject, *other);
    if (to_the_bit && differ(wrong.answer, said, t_exponent)) return about;
    if (!is_wrong(judge(*other, said, subject.format, convention).verdict)) return about;
  }
  return {};
}

}  // namespace rayaudit
