#include "oracle/margin.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "oracle/position.hpp"
#include "tests/families/drawn.hpp"
#include "tests/oracle/restriction.hpp"

using namespace rayaudit;
using oracle::Margin;
using oracle::Sign;
using oracle::Truth;

namespace {

/// Two hundred digits: enough for differences over 2^-200 of a number.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<200>,
                                           boost::multiprecision::et_off>;

/// Calls visit(question, truth) for some cases of every family and shape.
template <class H>
void each_case(std::size_t count, const Format& only, H&& holds) {
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid" || format != only) return;
    std::vector<Case> cases = drawn(family, shape, format, {}, 9, count / one_in);
    require_each(family, shape, format, cases, holds);
    if (shape != 2 && shape != 3) return;
    for (Case& question : cases) question.shape = closed(question.shape);
    require_each(family, shape, format, cases, holds);
  });
}

/// The same of cases whose surface has no end.
template <class H>
void each_endless_case(std::size_t count, const Format& only, H&& holds) {
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid" || format != only || shape == 1 || shape > 3) return;
    std::vector<Case> cases = drawn(family, shape, format, {}, 9, count / one_in);
    for (const Extent extent : {Extent::unbounded, Extent::both_nappes}) {
      for (Case& question : cases) question.extent = extent;
      require_each(family, shape, format, cases, holds);
    }
  });
}

bool alike(double a, double b, double relative) {
  return a == b || std::fabs(a - b) <= relative * std::max(a, b);
}

Margin margin_of(const Case& question) { return oracle::margin(question, oracle::truth(question)); }
Margin margin_of(const char* line) { return margin_of(read_case_line(line).question); }

void require_margin(const std::string& line, double reach, Sign sign, int side = 0,
                    int together = 1, Extent extent = Extent::bounded) {
  Case question = read_case_line(line).question;
  question.extent = extent;
  const Margin margin = margin_of(question);
  BOOST_TEST_CONTEXT(line << ": " << margin.reach) {
    BOOST_TEST(alike(margin.reach, reach, 0.01));
    BOOST_TEST(name(margin.sign) == name(sign));
    BOOST_TEST(margin.side == side);
    BOOST_TEST(margin.together == together);
  }
}

}  // namespace

// Each is worked out by hand: how fast the sign moves when every number moves by its share.

BOOST_AUTO_TEST_CASE(a_grazing_ray_is_as_far_as_its_distance_from_tangency) {
  // r^2 - x^2, by r: 2; by the x of origin and direction, ten away: 20 each.
  require_margin("sphere 0 0 0 1 ray 0x1.ffffep-1 0 -10 0 0 1", 0x1p-19 / 42, Sign::discriminant);
  require_margin("sphere 0 0 0 1 ray 0x1.00001p+0 0 -10 0 0 1", 0x1p-19 / 42, Sign::discriminant);
}

BOOST_AUTO_TEST_CASE(a_ray_at_a_rim_is_as_far_as_its_side_condition_from_zero) {
  // 1 - x^2, by r: 2; by the x of origin and direction, four away: 8 each.
  require_margin("disk 0 0 0 0 0 1 1 ray 0x1.ffffep-1 0 -4 0 0 1", 0x1p-19 / 18, Sign::side);
  require_margin("disk 0 0 0 0 0 1 1 ray 0x1.00001p+0 0 -4 0 0 1", 0x1p-19 / 18, Sign::side);
  // Height below the top, by the z of the origin: 4; of the direction, three away: 3; of the top:
  // 2; by the tilt of the top, one from the axis: 1.
  require_margin("cylinder 0 0 0 0 0 2 1 ray -4 0 0x1.ffffep+0 1 0 0", 0x1p-19 / 10, Sign::side, 1);
}

BOOST_AUTO_TEST_CASE(a_crossing_at_an_end_of_the_range_is_as_far_as_it_is_from_there) {
  // t = 4, by the z of origin and direction: 4 each, and 4 for the end itself.
  const std::string ray = "disk 0 0 0 0 0 1 4 ray 0 0 -4 0 0 1 range ";
  require_margin(ray + "0x1.ffffep+1 inf", 0x1p-18 / 12, Sign::start);
  require_margin(ray + "0x1.00001p+2 inf", 0x1p-18 / 12, Sign::start);
  require_margin(ray + "0 0x1.ffffep+1", 0x1p-18 / 12, Sign::end);
  require_margin(ray + "0 0x1.00001p+2", 0x1p-18 / 12, Sign::end);
}

BOOST_AUTO_TEST_CASE(where_two_signs_must_flip_the_dearer_one_counts) {
  const std::string ray = "disk 0 0 0 0 0 1 1 ray 0x1.00001p+0 0 -4 0 0 1 range ";
  // The end as above, and 1 by the tilt of the disk, one from its centre.
  require_margin(ray + "0x1.001p+2 inf", 0x1p-10 / 13, Sign::start, 0, 2);
  require_margin(ray + "0x1.000001p+2 inf", 0x1p-19 / 18, Sign::side, 0, 2);
}

BOOST_AUTO_TEST_CASE(what_the_first_root_decides_is_not_asked_of_the_second) {
  // Enters at t = 3; leaves at 5, which is all but t_max, and nothing hangs on it.
  BOOST_TEST(margin_of("sphere 0 0 0 1 ray 0 0 -4 0 0 1 range 0 0x1.400001p+2").reach > 0.1);
  // Starts inside, all but at the far side: 4 by origin, 5 by direction, 5 by t_min, 1 by r.
  require_margin("sphere 0 0 0 1 ray 0 0 -4 0 0 1 range 0x1.3ffffp+2 inf", 0x1p-18 / 15,
                 Sign::start);
}

BOOST_AUTO_TEST_CASE(a_steep_line_keeps_its_nappe) {
  // Close by the apex, where its root could only leave through the axis.
  const Margin margin = margin_of("cone 0 0 0 0 0 1 1 ray 0x1p-20 0 4 0 0 -1");
  BOOST_TEST(margin.reach > 0.05);
  // Exactly through the apex, a proper crossing.
  BOOST_TEST(margin_of("cone 0 0 0 0 0 1 1 ray 0 0 4 0 0 -1").reach > 0.05);
}

BOOST_AUTO_TEST_CASE(a_parallel_ray_is_as_far_as_the_tilt_that_it_takes) {
  // Two from the axis of a cylinder of height one, with and without a tilt of 2^-40.
  const Margin exactly = margin_of("cylinder 0 0 0 0 0 1 1 ray 2 0 -1 0 0 1");
  const Margin nearly = margin_of("cylinder 0 0 0 0 0 1 1 ray 2 0 -1 0x1p-40 0 1");
  const Margin aside = margin_of("cylinder 0 0 0 0 0 1 1 ray 2 -0x1.8p-40 -1 0 0x1p-40 1");
  for (const Margin& margin : {exactly, nearly, aside}) {
    BOOST_TEST(margin.reach > 0.05);
    BOOST_TEST(margin.reach < 2);
  }
}

BOOST_AUTO_TEST_CASE(a_ray_in_the_surface_that_misses_is_as_far_as_its_range_from_the_stretch) {
  // The rim at t = -3, by the x of origin and direction: 4 and 3, by r: 1, by t_min: 3.
  require_margin("disk 0 0 0 0 0 1 1 ray 4 0 0 1 0 0 range -0x1.7ffff8p+1 inf", 0x1p-20 / 11,
                 Sign::start);
  // The top at t = 6, by the z of origin, direction and top: 4, 6 and 2, by the tilt of the top: 1,
  // by t_min: 6.
  require_margin("cylinder 0 0 0 0 0 2 1 ray 1 0 -4 0 0 1 range 0x1.800004p+2 inf", 0x1p-20 / 19,
                 Sign::start);
}

BOOST_AUTO_TEST_CASE(a_closed_shape_is_lost_where_no_stretch_of_it_is_left) {
  const std::string can = "capped_cylinder 0 0 0 0 0 2 1 ray ";
  // Through both caps, 2^-20 from the edge: 1 - x^2, by the x of origin and direction, 4 and 6
  // away: 8 and 12, by r: 2. The side of the other cap it is that goes last.
  BOOST_TEST(margin_of((can + "0x1.ffffep-1 0 -4 0 0 1").c_str()).reach > 0x1p-26);
  BOOST_TEST(margin_of((can + "0x1.ffffep-1 0 -4 0 0 1").c_str()).reach < 0x1p-21);
  BOOST_TEST(margin_of((can + "0x1.00001p+0 0 -4 0 0 1").c_str()).reach > 0x1p-26);
  BOOST_TEST(margin_of((can + "0x1.00001p+0 0 -4 0 0 1").c_str()).reach < 0x1p-21);
  // From the lateral surface to a cap, which changes no truth.
  BOOST_TEST(margin_of((can + "-2 0 0x1.800001p+1 1 0 -1").c_str()).reach > 0.05);
  BOOST_TEST(margin_of((can + "-2 0 0x1.7fffffp+1 1 0 -1").c_str()).reach > 0.05);
  // By an edge, from outside: the height below the top at x = -1, as for the open one.
  const Margin edge = margin_of((can + "-2 0 0x1.000001p+0 1 0 1").c_str());
  BOOST_TEST(edge.reach < 0x1p-22);
  BOOST_TEST(edge.reach > 0x1p-29);
  BOOST_TEST(name(edge.sign) == name(Sign::side));
  // Along a cap: below it until both ends of the stretch are above, above it until one is below. At
  // the near end the direction counts 3, at the far one 5.
  require_margin(can + "-4 0 0x1.ffffep+0 1 0 0", 0x1p-19 / 10, Sign::side, 1, 2);
  require_margin(can + "-4 0 0x1.00001p+1 1 0 0", 0x1p-19 / 12, Sign::side, 1);
  // t = 2 at the top, by the z of origin, direction and top: 4, 2, 2, and 2 for the end itself.
  require_margin(can + "0 0 4 0 0 -1 range 0x1.ffffep+0 inf", 0x1p-19 / 10, Sign::start);
  require_margin(can + "0 0 4 0 0 -1 range 0x1.00001p+1 inf", 0x1p-19 / 10, Sign::start);
  require_margin(can + "0 0 4 0 0 -1 range 0 0x1.00001p+1", 0x1p-19 / 10, Sign::end);
  require_margin(can + "0 0 4 0 0 -1 range 0 0x1.ffffep+0", 0x1p-19 / 10, Sign::end);
}

BOOST_AUTO_TEST_CASE(an_endless_surface_is_lost_where_the_line_is_parallel_to_it) {
  const auto endless = [](const std::string& line, double reach, Sign sign) {
    require_margin(line, reach, sign, 0, 1, Extent::unbounded);
  };
  // The tilt of the direction against the normal: 2^-20, by its own share 1 and that of the
  // normal 1.
  endless("disk 0 0 0 0 0 1 1 ray 0 0 4 1 0 -0x1p-20", 0x1p-20 / 2, Sign::discriminant);
  endless("disk 0 0 0 0 0 1 1 ray 0 0 4 1 0 0x1p-20", 0x1p-20 / 2, Sign::discriminant);
  // Beyond the rim there is nothing to lose.
  BOOST_TEST(margin_of("disk 0 0 0 0 0 1 1 ray 0x1.00001p+0 0 -4 0 0 1").reach < 0x1p-20);
  Case question = read_case_line("disk 0 0 0 0 0 1 1 ray 0x1.00001p+0 0 -4 0 0 1").question;
  question.extent = Extent::unbounded;
  BOOST_TEST(margin_of(question).reach > 0.05);
}

BOOST_AUTO_TEST_CASE(a_touch_has_no_margin_and_all_else_has_some) {
  const auto holds = [](const Case& question) {
    const Truth truth = oracle::truth(question);
    const Margin margin = oracle::margin(question, truth);
    return truth.has_touch() ? margin.reach == 0 && margin.sign == Sign::touch
                             : margin.reach > 0 && margin.sign != Sign::touch;
  };
  each_case(100, float_format, holds);
  each_endless_case(100, float_format, holds);
}

BOOST_AUTO_TEST_CASE(double_word_and_exact_numbers_tell_the_same_to_two_digits) {
  int told = 0, asked = 0;
  for (const Format& format : {float_format, double_format})
    each_case(150, format, [&](const Case& question) {
      const Truth truth = oracle::truth(question);
      if (truth.has_touch()) return true;
      const std::optional<Margin> bounded = oracle::margin_by_bounds(question);
      ++asked;
      if (!bounded) return true;
      ++told;
      return alike(bounded->reach, oracle::margin_exactly(question).reach, 0.01);
    });
  BOOST_TEST(told > 0.75 * asked);
}

namespace {

void times_power(Vec3<double>& v, int e) {
  v = {std::ldexp(v.x, e), std::ldexp(v.y, e), std::ldexp(v.z, e)};
}

/// Lengths times 2^length, the direction times 2^direction, t as it follows.
Case scaled(Case question, int length, int direction) {
  times_power(question.ray.origin, length);
  times_power(question.ray.direction, direction);
  question.ray.t_min = std::ldexp(question.ray.t_min, length - direction);
  question.ray.t_max = std::ldexp(question.ray.t_max, length - direction);
  std::visit(
      [&](auto& shape) {
        std::size_t i = 0;
        const auto each = [&](auto& part) {
          const Part kind = std::remove_cvref_t<decltype(shape)>::kinds[i++];
          if constexpr (requires { part.x; }) {
            if (kind == Part::point) times_power(part, length);
          } else {
            part = std::ldexp(part, length);
          }
        };
        std::apply([&](auto&... part) { (each(part), ...); }, shape.parts());
      },
      question.shape);
  return question;
}

Case turned(Case question) {
  const auto turn = [](Vec3<double>& v) { v = {v.y, -v.z, v.x}; };
  turn(question.ray.origin), turn(question.ray.direction);
  std::visit(
      [&](auto& shape) {
        const auto each = [&](auto& part) {
          if constexpr (requires { part.x; }) turn(part);
        };
        std::apply([&](auto&... part) { (each(part), ...); }, shape.parts());
      },
      question.shape);
  return question;
}

}  // namespace

BOOST_AUTO_TEST_CASE(powers_of_two_and_turned_axes_leave_the_margin_as_it_is) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid" || family.id == "scale" || format != float_format) return;
    require_each(
        family, shape, format, drawn(family, shape, format, {}, 4, 60), [](const Case& question) {
          const double reach = margin_of(question).reach;
          const auto is_kept = [&](const Case& image) {
            return alike(margin_of(image).reach, reach, 0.01);
          };
          return is_kept(turned(question)) && is_kept(scaled(question, 7, -5)) &&
                 is_kept(scaled(question, 300, -200)) && is_kept(scaled(question, -300, 150));
        });
  });
}

namespace {

Wide side(const Disk<Wide>& disk, const Vec3<Wide>& p, int) {
  const Vec3<Wide> v = p - disk.centre;
  return disk.radius * disk.radius - dot(v, v);
}
Wide side(const Sphere<Wide>&, const Vec3<Wide>&, int) { return 0; }
Wide height(const Vec3<Wide>& p, const Vec3<Wide>& base, const Vec3<Wide>& top, bool from_top) {
  return from_top ? dot(top - p, top - base) : dot(p - base, top - base);
}
Wide side(const Cylinder<Wide>& s, const Vec3<Wide>& p, int i) {
  return height(p, s.base, s.top, i == 1);
}
Wide side(const Cone<Wide>& s, const Vec3<Wide>& p, int i) {
  return height(p, s.base, s.apex, i == 1);
}

template <class S>
Wide side(const S& s, const Vec3<Wide>& p, int i) {
  return side(opened(s), p, i);
}

/// The roots of a restriction in order, the tangent point where there is none.
Wide root(const Restriction<Wide>& f, int i) {
  const Wide b = 2 * f.half_b;
  if (f.a == 0) return -f.c / b;
  const Wide d = b * b - 4 * f.a * f.c;
  if (d <= 0) return -b / (2 * f.a);
  const bool larger = (i == 1) == (f.a > 0);
  const Wide m = b > 0 ? Wide(-b - sqrt(d)) : Wide(-b + sqrt(d));
  return (b > 0) == larger ? 2 * f.c / m : m / (2 * f.a);
}

/// Calls visit(x, how far it may move) for every number of a case, its range too.
template <class N, class S, class V>
void each_move(Ray<N>& ray, S& shape, V&& visit) {
  using std::abs;
  const auto each = [&](auto& part) {
    if constexpr (requires { part.x; }) {
      const N most = std::max({N(abs(part.x)), N(abs(part.y)), N(abs(part.z))});
      visit(part.x, most), visit(part.y, most), visit(part.z, most);
    } else {
      visit(part, N(abs(part)));
    }
  };
  each(ray.origin), each(ray.direction);
  std::apply([&](auto&... part) { (each(part), ...); }, shape.parts());
  if (isfinite(ray.t_min)) each(ray.t_min);
  if (isfinite(ray.t_max)) each(ray.t_max);
}

/// A case whose numbers move, and the sign that gives its margin: no part of it is the oracle's.
template <class S>
struct Moving {
  Ray<Wide> ray;
  S shape;
  Margin margin;

  Wide sign() const {
    const Restriction<Wide> f = restriction(shape, ray.origin, ray.direction);
    if (margin.sign == Sign::discriminant) return 4 * (f.half_b * f.half_b - f.a * f.c);
    const Restriction<Wide> own = restriction_of_patch();
    const Wide t = root(own, margin.patch > 0 ? 0 : margin.root);
    if (margin.sign == Sign::start) return t - ray.t_min;
    if (margin.sign == Sign::end) return ray.t_max - t;
    if (margin.patch > 0) return -(f.c + t * (2 * f.half_b + t * f.a));
    return side(shape, ray.origin + t * ray.direction, margin.side);
  }

  Restriction<Wide> restriction_of_patch() const {
    if constexpr (S::labels.size() == 3 && S::kinds[1] == Part::point)
      if (margin.patch > 0)
        return restriction_to_cap(shape, margin.patch - 1, ray.origin, ray.direction);
    return restriction(shape, ray.origin, ray.direction);
  }

  /// How fast the sign moves with each number's share, by central differences.
  std::vector<Wide> slopes() {
    std::vector<Wide> slope;
    each_move(ray, shape, [&](Wide& x, const Wide& most) {
      const Wide kept = x, step = ldexp(most, -200);
      x = kept + step;
      const Wide above = sign();
      x = kept - step;
      slope.push_back(ldexp(Wide(above - sign()), 199));
      x = kept;
    });
    return slope;
  }
};

Wide sum_of_sizes(const std::vector<Wide>& slopes) {
  Wide sum = 0;
  for (const Wide& slope : slopes) sum += abs(slope);
  return sum;
}

/// The case with every number moved by a share of what it may, up or down as way says.
template <class S>
Case moved(const Case& question, const S& shape, double share, const std::vector<int>& way) {
  Case image = question;
  std::vector<double> most;
  Ray<double> ray = question.ray;
  S same = shape;
  each_move(ray, same, [&](double&, double weight) { most.push_back(weight); });
  std::size_t i = 0;
  each_move(image.ray, std::get<S>(image.shape), [&](double& x, double) {
    x += share * most[i] * way[i];
    ++i;
  });
  return image;
}

/// What there is to a truth: a miss, a hit into or out of the surface, a touch.
int gist(const Case& question) {
  const Truth truth = oracle::truth(question);
  if (truth.has_touch()) return 2;
  return truth.hit() ? oracle::sensitivity(question, *truth.hit()).sign_before : 0;
}

/// The smallest length of a shape, against which a move must be small.
double smallest_length(const Disk<double>& s) { return s.radius; }
double smallest_length(const Sphere<double>& s) { return s.radius; }
double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }
double smallest_length(const Cylinder<double>& s) {
  return std::min(s.radius, length(s.top - s.base));
}
double smallest_length(const Cone<double>& s) {
  return std::min(s.radius, length(s.apex - s.base));
}
template <class S>
double smallest_length(const S& s) {
  return smallest_length(opened(s));
}

/// A case and the way in which its numbers move at its margin.
template <class S>
struct Move {
  const Case& question;
  const S& shape;
  Moving<decltype(in<Wide>(std::declval<S>()))> moving;
  std::vector<Wide> slopes;
  std::vector<int> way;

  Move(const Case& c, const S& s, const Margin& margin)
      : question(c),
        shape(s),
        moving{in<Wide>(c.ray), in<Wide>(s), margin},
        slopes(moving.slopes()) {
    const bool falls = moving.sign() > 0;
    for (const Wide& slope : slopes) way.push_back((slope > 0) == falls ? -1 : 1);
  }

  /// |s| / sum W_j |ds/dx_j|.
  double reach() const {
    return static_cast<double>(Wide(abs(moving.sign()) / sum_of_sizes(slopes)));
  }

  /// Is the move small beside the shape, and the sign as fast at its end as at its beginning? Then
  /// first order says what happens on the way.
  bool is_straight() const {
    double most = 0;
    const auto see = [&](const Vec3<double>& p) {
      most = std::max({most, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    };
    see(question.ray.origin), see(std::get<0>(shape.parts()));
    if (moving.margin.reach * most > 0x1p-7 * smallest_length(shape)) return false;
    auto there = moving;
    std::size_t i = 0;
    each_move(there.ray, there.shape,
              [&](Wide& x, const Wide& weight) { x += there.margin.reach * weight * way[i++]; });
    const Wide ratio = sum_of_sizes(there.slopes()) / sum_of_sizes(slopes);
    return ratio > 0.95 && ratio < 1.05;
  }
};

/// What became of the cases that were moved.
struct Moves {
  int asked = 0, straight = 0, early = 0, single = 0, late = 0;

  template <class S>
  void count(const Case& question, const S& shape, const Margin& margin, std::mt19937_64& engine) {
    ++asked;
    const Move<S> move(question, shape, margin);
    if (!move.is_straight()) return;
    ++straight;
    const int truth = gist(question);
    const auto changes = [&](double times, const std::vector<int>& way) {
      return gist(moved(question, shape, times * margin.reach, way)) != truth;
    };
    bool is_early = changes(0.9, move.way);
    for (int k = 0; k < 8; ++k) {
      std::vector<int> any;
      for (std::size_t i = 0; i < move.way.size(); ++i) any.push_back((engine() & 1) != 0 ? 1 : -1);
      is_early = is_early || changes(0.9, any);
    }
    early += is_early ? 1 : 0;
    if (margin.together > 1) return;
    ++single;
    late += changes(1.1, move.way) ? 0 : 1;
  }
};

}  // namespace

BOOST_AUTO_TEST_CASE(the_margin_is_that_of_finite_differences) {
  int asked = 0, compared = 0, off = 0;
  for (const Format& format : {float_format, double_format})
    each_case(60, format, [&](const Case& question) {
      const Truth truth = oracle::truth(question);
      const Margin margin = oracle::margin(question, truth);
      if (truth.has_touch() || margin.reach > 0x1p-10 || margin.reach < 0x1p-120) return true;
      ++asked;
      return std::visit(
          [&](const auto& shape) {
            const Move<std::remove_cvref_t<decltype(shape)>> move(question, shape, margin);
            if (!move.is_straight()) return true;
            ++compared;
            off += alike(margin.reach, move.reach(), 0.03) ? 0 : 1;
            return alike(margin.reach, move.reach(), 0.5);
          },
          question.shape);
    });
  BOOST_TEST_MESSAGE(compared << " of " << asked << " compared, " << off << " off");
  // A sign is taken by the measure of its root, which moves a little too.
  BOOST_TEST(off < 0.01 * compared);
  BOOST_TEST(compared > 0.5 * asked);
}

BOOST_AUTO_TEST_CASE(a_move_beyond_the_margin_changes_the_truth_and_one_short_of_it_does_not) {
  std::mt19937_64 engine(29);
  Moves all;
  each_case(120, float_format, [&](const Case& question) {
    const Truth truth = oracle::truth(question);
    const Margin margin = oracle::margin(question, truth);
    // Doubles show moves down to 2^-40 of a number to a thousandth.
    if (truth.has_touch() || margin.reach > 0x1p-10 || margin.reach < 0x1p-40) return true;
    const Moves before = all;
    std::visit([&](const auto& shape) { all.count(question, shape, margin, engine); },
               question.shape);
    if (all.early > before.early || all.late > before.late)
      BOOST_TEST_MESSAGE((all.late > before.late ? "late: " : "early: ") << case_line(question));
    return true;
  });
  BOOST_TEST_MESSAGE(all.asked << " asked, " << all.straight << " straight, " << all.early
                               << " early; " << all.single << " single, " << all.late << " late");
  BOOST_TEST(all.straight > 0.5 * all.asked);
  BOOST_TEST(all.early < 0.01 * all.straight);
  BOOST_TEST(all.late < 0.01 * all.single);
}
