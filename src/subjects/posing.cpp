#include "subjects/posing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rayaudit::posing {

double in_format(long double x, const Format& format) {
  return format == float_format ? static_cast<double>(static_cast<float>(x))
                                : static_cast<double>(x);
}

namespace {

using Long = Vec3<long double>;
using posing::in_format;

bool is_finite(const Case& question) {
  bool all = true;
  each_number(question, [&](double x) { all = all && std::isfinite(x); });
  return all;
}

bool is_finite(const Vec3<double>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

long double longest(const Long& v) {
  return std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
}

/// Squares of doubles neither overflow nor underflow here.
long double length(const Long& v) { return std::sqrt(dot(v, v)); }

Vec3<double> in_format(const Long& v, const Format& format) {
  return {in_format(v.x, format), in_format(v.y, format), in_format(v.z, format)};
}

/// Calls visit(base, tip) for the ends of an axis, where a shape has one.
template <class S, class V>
void with_axis(S& any, const V& visit) {
  std::visit(
      [&](auto& shape) {
        if constexpr (requires { shape.top; })
          visit(shape.base, shape.top);
        else if constexpr (requires { shape.apex; })
          visit(shape.base, shape.apex);
      },
      any);
}

double& radius_of(Shape& any) {
  return *std::visit([](auto& shape) { return &shape.radius; }, any);
}

bool is_cone(const Shape& any) {
  return std::visit(
      [](const auto& shape) {
        return requires { shape.apex; };
      },
      any);
}

/// Three directions at right angles, of length 1, in the order that makes a rotation.
struct Frame {
  std::array<Long, 3> rows;

  /// No sum of zeros is a negative one.
  Long turned(const Long& v) const {
    return {dot(rows[0], v) + 0, dot(rows[1], v) + 0, dot(rows[2], v) + 0};
  }
};

/// The frame in which a direction is that of +z, or of +y. Along a coordinate axis all of it is
/// zeros and ones, and +z, or +y, stays where it is.
Frame frame_of(const Long& axis, Convention::Stand stand) {
  const Long part = axis / longest(axis), w = part / length(part);
  // The coordinate axis before the one that is nearest to it is far from it.
  const long double size = longest(w);
  const Long before = std::fabs(w.z) == size   ? Long{0, 1, 0}
                      : std::fabs(w.y) == size ? Long{1, 0, 0}
                                               : Long{0, 0, 1};
  const Long across = cross(before, w), u = across / length(across), v = cross(w, u);
  if (stand == Convention::Stand::upright_z) return {{u, v, w}};
  return {{v, w, u}};
}

/// So many powers of two that bring numbers back into the range of a format.
constexpr int back = 4;

/// What of the world was scaled by 2^world, of the direction by 2^direction.
void scale_range(Ray<double>& ray, int world, int direction, const Format& format) {
  if (world == direction) return;
  for (double* t : {&ray.t_min, &ray.t_max})
    *t = in_format(std::ldexp(static_cast<long double>(*t), world - direction), format);
}

/// A case as it stands, its world scaled by 2^world, its direction by 2^direction.
Case stood(const Case& question, Convention::Stand stand, const Format& format, int world,
           int direction) {
  Case made = question;
  with_axis(made.shape, [&](Vec3<double>& base, Vec3<double>& tip) {
    const long double scale = std::ldexp(1.0L, world);
    const Long from = in<long double>(base), to = in<long double>(tip);
    const Long middle = (from + to) / 2.0L, axis = to - from;
    const Frame frame = frame_of(axis, stand);
    const double h = in_format(length(axis) / 2 * scale, format);
    const bool is_y = stand == Convention::Stand::upright_y;
    tip = is_y ? Vec3<double>{0, h, 0} : Vec3<double>{0, 0, h};
    base = is_y ? Vec3<double>{0, -h, 0} : Vec3<double>{0, 0, -h};
    Ray<double>& ray = made.ray;
    ray.origin = in_format(scale * frame.turned(in<long double>(ray.origin) - middle), format);
    const long double longer = std::ldexp(1.0L, direction);
    ray.direction = in_format(longer * frame.turned(in<long double>(ray.direction)), format);
  });
  double& radius = radius_of(made.shape);
  radius = in_format(std::ldexp(static_cast<long double>(radius), world), format);
  scale_range(made.ray, world, direction, format);
  return made;
}

bool is_upright(const Vec3<double>& base, const Vec3<double>& tip, Convention::Stand stand) {
  const double h = stand == Convention::Stand::upright_y ? tip.y : tip.z;
  const Vec3<double> top =
      stand == Convention::Stand::upright_y ? Vec3<double>{0, h, 0} : Vec3<double>{0, 0, h};
  return h > 0 && tip == top && base == -top;
}

/// The next number of the format towards 0.
double below(double x, const Format& format) {
  return format == float_format ? std::nextafter(static_cast<float>(x), 0.0F)
                                : std::nextafter(x, 0.0);
}
double least(const Format& format) { return std::ldexp(1.0, format.min_exponent); }

/// The radius, beside a height of 1, of the cone that is told of one of about this radius.
double by_angle(long double radius, const Format& format) {
  double angle = std::max(in_format(std::atan(radius), format), least(format));
  // The number nearest to a right angle may be a larger one.
  while (!(std::tan(static_cast<long double>(angle)) > 0)) angle = below(angle, format);
  return static_cast<double>(std::tan(static_cast<long double>(angle)));
}
double by_cosine(long double radius, const Format& format) {
  double cosine = std::max(in_format(1 / std::sqrt(1 + radius * radius), format), least(format));
  // Of 1 it is no cone.
  cosine = std::min(cosine, below(1, format));
  const long double c = cosine;
  return static_cast<double>(std::sqrt((1 - c) * (1 + c)) / c);
}

/// The same worked out from what it makes, until that stays.
double told_radius(long double radius, Convention::Opening opening, const Format& format) {
  const auto told = opening == Convention::Opening::angle ? by_angle : by_cosine;
  double found = told(radius, format);
  for (int i = 0; i < 8; ++i) found = told(found, format);
  return found;
}

/// The ray with its world divided by a height, of which no number leaves the range of the format.
void scale(Ray<double>& ray, long double height, const Format& format) {
  const double most = format == float_format ? std::numeric_limits<float>::max()
                                             : std::numeric_limits<double>::max();
  for (double* x : {&ray.origin.x, &ray.origin.y, &ray.origin.z})
    *x = std::clamp(in_format(*x / height, format), -most, most);
  const Vec3<double> direction = in_format(in<long double>(ray.direction) / height, format);
  const bool was_none = ray.direction == Vec3<double>{0, 0, 0};
  if (is_finite(direction) && (was_none || !(direction == Vec3<double>{0, 0, 0})))
    ray.direction = direction;
  else
    for (double* t : {&ray.t_min, &ray.t_max}) *t = in_format(*t / height, format);
}

/// Is a number one of the format?
bool is_in(double x, const Format& format) { return in_format(x, format) == x; }
bool is_in(const Vec3<double>& v, const Format& format) {
  return is_in(v.x, format) && is_in(v.y, format) && is_in(v.z, format);
}

/// Is a + b = sum, exactly? (TwoSum: Knuth, TAOCP 2, 4.2.2, theorem B.)
bool is_sum(double a, double b, double sum) {
  if (a + b != sum || !std::isfinite(sum)) return false;
  const double part = sum - a;
  return (a - (sum - part)) + (b - part) == 0;
}

/// Two numbers of the format whose difference is a double.
struct Ends {
  double from, to;
};
Ends apart(long double from, long double to, const Format& format) {
  Ends ends = {in_format(from, format), in_format(to, format)};
  const double size = std::max(std::fabs(ends.from), std::fabs(ends.to));
  const auto rounded_to = [](long double x, int exponent) {
    return static_cast<double>(std::ldexp(std::nearbyint(std::ldexp(x, -exponent)), exponent));
  };
  for (int bit = format.precision - 1; bit > 0 && !is_sum(ends.from, ends.to - ends.from, ends.to);
       --bit) {
    const int exponent = std::ilogb(size) - bit;
    ends = {rounded_to(ends.from, exponent), rounded_to(ends.to, exponent)};
  }
  return ends;
}

/// The farthest from its middle that a shape reaches, and how far that is from a point.
long double beyond(const Shape& any, const Vec3<double>& from) {
  const Long origin = in<long double>(from);
  Long middle = {};
  long double reach = 0;
  Shape shape = any;
  with_axis(shape, [&](const Vec3<double>& base, const Vec3<double>& tip) {
    middle = (in<long double>(base) + in<long double>(tip)) / 2.0L;
    reach = length(in<long double>(tip) - in<long double>(base)) / 2;
  });
  std::visit(
      [&](const auto& round) {
        if constexpr (requires { round.centre; }) middle = in<long double>(round.centre);
      },
      any);
  reach += std::fabs(static_cast<long double>(radius_of(shape)));
  return std::max(length(origin - middle) + reach, length(origin));
}

/// The segment from t = begin to t = end.
Case segment(const Case& question, long double begin, long double end, const Format& format) {
  const Long origin = in<long double>(question.ray.origin);
  const Long direction = in<long double>(question.ray.direction);
  const Long from = origin + begin * direction, to = origin + end * direction;
  const Ends x = apart(from.x, to.x, format), y = apart(from.y, to.y, format),
             z = apart(from.z, to.z, format);
  Case made = question;
  made.ray = {{x.from, y.from, z.from}, {x.to - x.from, y.to - y.from, z.to - z.from}, 0, 1};
  return made;
}

}  // namespace

Case stood(const Case& question, Convention::Stand stand, const Format& format) {
  bool stays = true;
  with_axis(question.shape, [&](const Vec3<double>& base, const Vec3<double>& tip) {
    stays = base == tip || is_upright(base, tip, stand);
  });
  if (stays || !is_finite(question)) return question;
  const Case made = stood(question, stand, format, 0, 0);
  int world = is_finite(made.ray.origin) ? 0 : -back;
  with_axis(made.shape, [&](const Vec3<double>& base, const Vec3<double>& tip) {
    if (!is_finite(base)) world = -back;
    if (base == tip) world = back;
  });
  const int direction = is_finite(made.ray.direction) ? 0 : -back;
  return world == 0 && direction == 0 ? made : stood(question, stand, format, world, direction);
}

Case opened(const Case& question, Convention::Opening opening, const Format& format) {
  Case made = question;
  double& radius = radius_of(made.shape);
  if (!is_cone(question.shape) || !is_finite(question) || !(radius > 0)) return question;
  long double height = 0;
  with_axis(made.shape, [&](Vec3<double>& base, Vec3<double>& tip) {
    height = length(in<long double>(tip) - in<long double>(base));
    for (double* x : {&base.x, &base.y, &base.z, &tip.x, &tip.y, &tip.z})
      if (*x != 0) *x = std::copysign(0.5, *x);
  });
  if (height == 0) return question;
  radius = told_radius(radius / height, opening, format);
  // A direction that is the difference of two floats need not be one.
  if (height != 1) scale(made.ray, height, format);
  return made;
}

bool is_between_points(const Ray<double>& ray, const Format& format) {
  const Vec3<double>&from = ray.origin, &way = ray.direction;
  const Vec3<double> to = from + way;
  return is_in(from, format) && is_in(to, format) && is_sum(from.x, way.x, to.x) &&
         is_sum(from.y, way.y, to.y) && is_sum(from.z, way.z, to.z);
}

bool is_segment(const Ray<double>& ray, const Format& format) {
  return ray.t_min == 0 && ray.t_max == 1 && is_between_points(ray, format);
}

Case cut(const Case& question, const Format& format) {
  const Ray<double>& ray = question.ray;
  const long double size = length(in<long double>(ray.direction));
  if (!is_finite(question) || !(size > 0) || !(ray.t_min < ray.t_max) || is_segment(ray, format))
    return question;
  const int exponent = 1 + std::ilogb(beyond(question.shape, ray.origin) / size);
  long double afar = std::ldexp(1.0L, exponent);
  const auto is_made = [](const Case& made) {
    const Vec3<double>& way = made.ray.direction;
    return is_finite(made) && !(way == Vec3<double>{0, 0, 0});
  };
  for (int tries = 0; tries < 4; ++tries, afar /= 4) {
    const long double begin = std::clamp<long double>(ray.t_min, -afar, afar);
    const Case made = segment(question, begin, std::min<long double>(ray.t_max, 2 * afar), format);
    if (is_made(made)) return made;
    const Case longer = segment(question, begin, begin + afar, format);
    if (is_made(longer)) return longer;
  }
  return question;
}

}  // namespace rayaudit::posing
