#include "audit/transformation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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

bool is_in(double x, const Format& format) {
  return format != float_format || static_cast<double>(static_cast<float>(x)) == x;
}

bool is_moderate(double x) {
  const double size = std::fabs(x);
  return x == 0 || (size > 0x1p-30 && size < 0x1p30);
}

template <class Fits>
bool every_number(const Case& question, const Fits& fits) {
  bool all = true;
  each_number(question, [&](double x) { all = all && fits(x); });
  return all;
}

/// The case, where the format holds each of its numbers without loss and none of them is extreme.
std::optional<Changed> held(const Case& question, const Format& format, int t_exponent = 0) {
  if (!every_number(question, [&](double x) { return is_moderate(x) && is_in(x, format); }))
    return {};
  return Changed{question, t_exponent};
}

constexpr auto same = [](const auto& x) { return x; };
constexpr auto eightfold = [](const Vec3<double>& v) { return 8.0 * v; };

std::optional<Changed> longer_direction(const Case& question, const Format& format) {
  Case made = question;
  made.ray.direction = eightfold(made.ray.direction);
  made.ray.t_min /= 8, made.ray.t_max /= 8;
  return every_number(question, is_moderate) ? held(made, format, -3) : std::nullopt;
}

std::optional<Changed> longer_normal(const Case& question, const Format& format) {
  Case made = question;
  auto* disk = std::get_if<Disk<double>>(&made.shape);
  if (disk == nullptr) return {};
  disk->normal = eightfold(disk->normal);
  return every_number(question, is_moderate) ? held(made, format) : std::nullopt;
}

std::optional<Changed> larger(const Case& question, const Format& format) {
  Case made = changed(question, eightfold, same, [](double length) { return 8 * length; });
  made.ray.direction = eightfold(question.ray.direction);
  return every_number(question, is_moderate) ? held(made, format) : std::nullopt;
}

std::optional<Changed> with_axes_in_turn(const Case& question, const Format& format) {
  const auto turn = [](const Vec3<double>& v) { return Vec3<double>{v.y, v.z, v.x}; };
  return held(changed(question, turn, turn, same), format);
}

std::optional<Changed> mirrored(const Case& question, const Format& format) {
  const auto mirror = [](const Vec3<double>& v) { return Vec3<double>{-v.x, v.y, -v.z}; };
  return held(changed(question, mirror, mirror, same), format);
}

bool is_sum_exact(double a, double b) {
  const double sum = a + b;
  return sum - b == a && sum - a == b;
}

/// Moved by its own size, where the sums are exact.
std::optional<Changed> moved(const Case& question, const Format& format) {
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

/// The ray begun t units of its direction further on, where the sums are exact.
std::optional<Changed> begun_at(const Case& question, double t, const Format& format) {
  Case made = question;
  const auto step = [&](double o, double d) {
    const double by = t * d;
    return std::fma(t, d, -by) == 0 && is_sum_exact(o, by) ? o + by : Judgement::unmeasured;
  };
  const auto& [o, d] = std::tie(question.ray.origin, question.ray.direction);
  made.ray.origin = {step(o.x, d.x), step(o.y, d.y), step(o.z, d.z)};
  return held(made, format);
}

/// How far the shape reaches from its first point, more or less.
double extent(const Shape& any) {
  return std::visit(
      []<class S>(const S& shape) {
        double size = shape.radius;
        if constexpr (S::kinds[1] == Part::point) {
          const auto axis = std::get<1>(shape.parts()) - std::get<0>(shape.parts());
          size += std::sqrt(dot(axis, axis));
        }
        return size;
      },
      any);
}

/// Where along the ray it is nearest to the shape's first point, and the length of the shape in
/// units of the direction, more or less.
struct Approach {
  double t, extent;
};
Approach approach(const Case& question) {
  const auto& [o, d] = std::tie(question.ray.origin, question.ray.direction);
  const Vec3<double> first =
      std::visit([](const auto& shape) { return std::get<0>(shape.parts()); }, question.shape);
  const double dd = dot(d, d);
  return {dot(first - o, d) / dd, extent(question.shape) / std::sqrt(dd)};
}

/// x to so many bits, toward 0.
double shortened(double x, int bits) {
  if (x == 0 || !std::isfinite(x)) return x;
  const int unit = std::ilogb(x) - bits + 1;
  return std::ldexp(std::trunc(std::ldexp(x, -unit)), unit);
}

/// From far away the ray is begun as near to the shape as it can exactly be.
std::optional<Changed> begun_nearer(const Case& question, const Format& format) {
  const auto [t, size] = approach(question);
  if (!(t > 16 * size) || !std::isinf(question.ray.t_max) || question.ray.t_min != 0) return {};
  for (int bits = 10; bits > 0; --bits)
    if (auto made = begun_at(question, shortened(t - 4 * size, bits), format)) return made;
  return {};
}

/// From close by it is begun about two lengths of the shape further back.
std::optional<Changed> begun_further(const Case& question, const Format& format) {
  const auto [t, size] = approach(question);
  if (t > 4 * size || !std::isfinite(size) || question.ray.t_min != 0) return {};
  return begun_at(question, -shortened(2 * size, 1), format);
}

std::optional<Real> hit_of(const Case& question) {
  const oracle::Truth truth = oracle::truth(question);
  if (truth.has_touch() || truth.hit() == nullptr) return {};
  return truth.hit()->t;
}

/// The half of a cylinder or cone that has the hit, where the half is of the same kind.
std::optional<Case> half(const Case& question, const Real& t) {
  const auto is_hit_there = [&](const Case& made) {
    const std::optional<Real> there = hit_of(made);
    return there && compare(*there, t) == 0;
  };
  const auto middle = [](const Vec3<double>& a, const Vec3<double>& b) { return 0.5 * (a + b); };
  Case made = question;
  if (auto* cone = std::get_if<Cone<double>>(&made.shape)) {
    cone->base = middle(cone->base, cone->apex), cone->radius /= 2;
    return is_hit_there(made) ? std::optional(made) : std::nullopt;
  }
  auto* cylinder = std::get_if<Cylinder<double>>(&made.shape);
  if (cylinder == nullptr) return {};
  const Cylinder<double> whole = *cylinder;
  cylinder->top = middle(whole.base, whole.top);
  if (is_hit_there(made)) return made;
  *cylinder = {middle(whole.base, whole.top), whole.top, whole.radius};
  return is_hit_there(made) ? std::optional(made) : std::nullopt;
}

/// A long cylinder or cone halved again and again, as far as it can exactly be.
std::optional<Changed> cut_short(const Case& question, const Format& format) {
  constexpr int halvings = 16;
  const std::optional<Real> t = hit_of(question);
  std::optional<Changed> last;
  std::optional<Case> next = t ? half(question, *t) : std::nullopt;
  for (int i = 0; i < halvings && next && held(*next, format); ++i) {
    last = Changed{*next};
    next = half(last->question, *t);
  }
  return last;
}

/// The direction as near to length 1 as the format has it.
std::optional<Changed> unit_direction(const Case& question, const Format& format) {
  Convention unit;
  unit.unit_direction = true;
  return held(posed(question, unit, format), format);
}

/// The same of a normal.
std::optional<Changed> unit_normal(const Case& question, const Format& format) {
  Case turned = question;
  auto* disk = std::get_if<Disk<double>>(&turned.shape);
  if (disk == nullptr) return {};
  turned.ray.direction = disk->normal;
  const auto unit = unit_direction(turned, format);
  if (!unit) return {};
  disk->normal = unit->question.ray.direction;
  turned.ray = question.ray;
  return held(turned, format);
}

/// As inexactly changed, but of length 8.
template <std::optional<Changed> (*unit)(const Case&, const Format&),
          std::optional<Changed> (*longer)(const Case&, const Format&)>
std::optional<Changed> unit_and_longer(const Case& question, const Format& format) {
  const std::optional<Changed> made = unit(question, format);
  return made ? longer(made->question, format) : std::nullopt;
}

/// Three, five times as large: the same lines and shapes, other roundings.
template <int factor>
std::optional<Changed> other_direction(const Case& question, const Format& format) {
  if (question.ray.t_min != 0 || !std::isinf(question.ray.t_max)) return {};
  Case made = question;
  made.ray.direction = double{factor} * made.ray.direction;
  return held(made, format);
}
template <int factor>
std::optional<Changed> other_unit(const Case& question, const Format& format) {
  const auto times = [](const auto& x) { return double{factor} * x; };
  Case made = changed(question, times, same, times);
  made.ray.direction = double{factor} * question.ray.direction;
  return held(made, format);
}

/// The direction times 2^direction, the world 2^world, where the format holds all of it.
std::optional<Changed> scaled_by(const Case& question, int direction, int world,
                                 const Format& format) {
  const auto by = [](int e) {
    return [e](const auto& x) {
      if constexpr (requires { x.x; })
        return Vec3<double>{std::ldexp(x.x, e), std::ldexp(x.y, e), std::ldexp(x.z, e)};
      else
        return std::ldexp(x, e);
    };
  };
  const auto scaled_case = [&](const Case& from, int sign) {
    Case made = changed(from, by(sign * world), same, by(sign * world));
    made.ray.direction = by(sign * direction)(from.ray.direction);
    for (double* t : {&made.ray.t_min, &made.ray.t_max})
      *t = std::ldexp(*t, sign * (world - direction));
    return made;
  };
  const Case made = scaled_case(question, 1);
  const bool fits = every_number(made, [&](double x) { return is_in(x, format); });
  if (!fits || made == question || !(scaled_case(made, -1) == question)) return {};
  return Changed{made, world - direction};
}

int exponent_of(const Vec3<double>& v) {
  return std::ilogb(std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}));
}

/// The exponent of what is the radius of the shape, or of its whole size.
int exponent_of(const Shape& any) {
  return std::ilogb(std::visit([](const auto& shape) { return shape.radius; }, any));
}

/// An extreme case with its numbers elsewhere in the range of the format: world of size 1,
/// direction of 8, for one of 1 may mend what else is taken for granted.
template <bool direction, bool world>
std::optional<Changed> of_moderate_size(const Case& question, const Format& format) {
  if (every_number(question, is_moderate)) return {};
  const int e = world ? -exponent_of(question.shape) : 0;
  return scaled_by(question, direction ? 3 - exponent_of(question.ray.direction) : e, e, format);
}

/// The same with its direction longer by a fixed factor.
template <int by>
std::optional<Changed> elsewhere_in_range(const Case& question, const Format& format) {
  if (every_number(question, is_moderate)) return {};
  return scaled_by(question, by, 0, format);
}

/// The same world, with a shape of size 1: other powers of two, and nothing else.
std::optional<Changed> of_size_one(const Case& question, const Format& format) {
  if (!every_number(question, is_moderate)) return {};
  const int e = -exponent_of(question.shape);
  const std::optional<Changed> made = scaled_by(question, e, e, format);
  return made ? held(made->question, format) : std::nullopt;
}

/// Neither a product nor t then overflows, underflows or is lost beside an epsilon.
constexpr std::string_view moderate_numbers = "numbers of moderate size";
constexpr std::string_view other_roundings = "how it is rounded";

/// Tried in this order: what comes first is told.
using Shows = Transformation::Shows;
constexpr std::array list = {
    Transformation{length_of_direction, longer_direction, Shows::to_the_bit},
    Transformation{"the length of the normal", longer_normal, Shows::to_the_bit},
    Transformation{"the unit of length", larger, Shows::to_the_bit},
    Transformation{"the unit of length", of_size_one, Shows::to_the_bit},
    Transformation{moderate_numbers, of_moderate_size<true, false>, Shows::by_mending},
    Transformation{moderate_numbers, of_moderate_size<false, true>, Shows::by_mending},
    Transformation{moderate_numbers, of_moderate_size<true, true>, Shows::by_mending},
    Transformation{moderate_numbers, elsewhere_in_range<40>, Shows::by_mending},
    Transformation{moderate_numbers, elsewhere_in_range<-40>, Shows::by_mending},
    Transformation{length_of_direction, unit_direction, Shows::only_afar},
    Transformation{"", unit_and_longer<unit_direction, longer_direction>, Shows::control},
    Transformation{"the length of the normal", unit_normal, Shows::only_afar},
    Transformation{"", unit_and_longer<unit_normal, longer_normal>, Shows::control},
    Transformation{"the place in the world", moved, Shows::from_afar},
    Transformation{"where on its line the ray begins", begun_nearer, Shows::from_afar},
    Transformation{"where on its line the ray begins", begun_further, Shows::from_afar},
    Transformation{"the length of the shape", cut_short, Shows::from_afar},
    Transformation{other_roundings, other_direction<3>, Shows::rounding},
    Transformation{other_roundings, other_direction<5>, Shows::rounding},
    Transformation{other_roundings, other_unit<3>, Shows::rounding},
    Transformation{other_roundings, other_unit<5>, Shows::rounding},
    Transformation{"which axis is which", with_axes_in_turn, Shows::in_whole_numbers},
    Transformation{"the sense of an axis", mirrored, Shows::from_afar},
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

/// Is it a case that the subject is asked: within the range that it answers in, with a direction of
/// the length that it is given, a shape that stands as it takes it?
bool is_asked(const Case& other, const Case& question, const Convention& convention,
              const Format& drawn_in) {
  const auto longest = [](const Vec3<double>& v) {
    return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
  };
  if (convention.unit_direction && longest(other.ray.direction) != longest(question.ray.direction))
    return false;
  Convention rest = convention;
  rest.unit_direction = false;
  return posed(other, rest, drawn_in) == other;
}

/// Are the crossings of two truths of the same kinds?
bool are_alike(const oracle::Truth& a, const oracle::Truth& b) {
  return a.invalid == b.invalid &&
         std::equal(a.crossings().begin(), a.crossings().end(), b.crossings().begin(),
                    b.crossings().end(),
                    [](const auto& one, const auto& other) { return one.kind == other.kind; });
}

/// A transformation of a case, with what the subject says of what it makes of it.
struct Trial {
  const Transformation* transformation;
  int t_exponent;
  oracle::Truth truth;
  Answer said = {};
};

/// Whole numbers and halves so small that sums and products of them are exact.
bool is_plain(const Case& question) {
  return every_number(question,
                      [](double x) { return std::fabs(x) <= 8 && std::trunc(2 * x) == 2 * x; });
}

/// Asks a subject all changed cases of one, in one go.
class Trials {
 public:
  Trials(const Wrong& wrong, const Subject& subject, const Convention& convention)
      : wrong_(wrong), subject_(subject), convention_(convention) {
    const Case& question = wrong.settled.question();
    for (const Transformation& each : list) {
      const std::optional<Changed> other = each.change(question, subject.format);
      if (!other || !is_asked(other->question, question, convention, subject.drawn_in())) continue;
      const oracle::Truth truth = oracle::truth(other->question, oracle::bits_for(subject.format));
      if (!are_alike(truth, wrong.settled.truth())) continue;
      cases_.push_back(other->question);
      trials_.push_back({&each, other->t_exponent, truth});
    }
    std::vector<Answer> answers(cases_.size());
    if (!cases_.empty()) subject.answer[question.shape.index()](cases_, answers);
    for (std::size_t i = 0; i < answers.size(); ++i) trials_[i].said = answers[i];
  }

  /// What the first shows that changes the answer.
  Diagnosis diagnosis(bool is_far) const {
    for (std::size_t i = 0; i < trials_.size(); ++i) {
      const Transformation& tried = *trials_[i].transformation;
      if (tried.shows == Shows::control) continue;
      if (tried.shows == Shows::only_afar && (!is_far || !stays_wrong_in_control(i))) continue;
      if (trials_[i].said.form == Answer::Form::unasked || !is_changed(i)) continue;
      const bool is_rounding =
          tried.shows == Shows::rounding || (tried.shows == Shows::from_afar && !is_far) ||
          (tried.shows == Shows::in_whole_numbers && !is_plain(wrong_.settled.question()));
      return is_rounding ? Diagnosis{Cause::rounding} : Diagnosis{Cause::assumption, tried.about};
    }
    return {Cause::unknown};
  }

 private:
  bool stays_wrong_in_control(std::size_t i) const {
    const std::size_t next = i + 1;
    return next < trials_.size() && trials_[next].transformation->shows == Shows::control &&
           !is_changed(next);
  }

  /// Is the answer another one where it must be the same, or mended elsewhere?
  bool is_changed(std::size_t i) const {
    const auto& [tried, t_exponent, truth, said] = trials_[i];
    if (tried->shows == Shows::to_the_bit && differ(wrong_.answer, said, t_exponent)) return true;
    Settled settled(cases_[i], truth);
    const Judgement judgement = judge(settled, said, subject_.format, convention_);
    const bool is_off = wrong_.most_ulps && judgement.ulps > *wrong_.most_ulps;
    return !is_wrong(judgement.verdict) && !is_off;
  }

  const Wrong& wrong_;
  const Subject& subject_;
  const Convention& convention_;
  std::vector<Case> cases_;
  std::vector<Trial> trials_;
};

}  // namespace

std::span<const Transformation> transformations() { return list; }

Diagnosis diagnosis_from_outside(const Wrong& wrong, const Subject& subject,
                                 const Convention& convention) {
  const double margin = std::ldexp(wrong.settled.reach(), subject.format.precision);
  const bool is_far = margin > beyond_rounding;
  const Diagnosis found = Trials(wrong, subject, convention).diagnosis(is_far);
  if (found.cause == Cause::unknown && is_far && is_plain(wrong.settled.question()))
    return {Cause::formula, "in small whole numbers"};
  return found;
}

}  // namespace rayaudit
