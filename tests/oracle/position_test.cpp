#include "oracle/position.hpp"

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <random>

#include "tests/families/drawn.hpp"
#include "tests/oracle/closed.hpp"
#include "tests/oracle/dyadic.hpp"
#include "tests/oracle/restriction.hpp"

using namespace rayaudit;
using oracle::Crossing;
using oracle::Kind;

namespace {

constexpr std::size_t count = 60 / one_in;  ///< cases of every family, shape and format

/// Three hundred digits: enough for numbers of every size together in one sum.
using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<300>,
                                           boost::multiprecision::et_off>;

/// F at a point and its gradient, written out by hand with no cross product.
struct Field {
  Dyadic value;
  Vec3<Dyadic> gradient;
};

Field field(const Disk<Dyadic>& disk, const Vec3<Dyadic>& p) {
  return {dot(p - disk.centre, disk.normal), disk.normal};
}

Field field(const Sphere<Dyadic>& sphere, const Vec3<Dyadic>& p) {
  const Vec3<Dyadic> v = p - sphere.centre;
  return {dot(v, v) - sphere.radius * sphere.radius, v + v};
}

Field field(const Cylinder<Dyadic>& cylinder, const Vec3<Dyadic>& p) {
  const Vec3<Dyadic> v = p - cylinder.base, w = cylinder.top - cylinder.base;
  const Dyadic ww = dot(w, w), vw = dot(v, w), rr = cylinder.radius * cylinder.radius;
  const Vec3<Dyadic> half = ww * v - vw * w;
  return {dot(v, v) * ww - vw * vw - rr * ww, half + half};
}

Field field(const Cone<Dyadic>& cone, const Vec3<Dyadic>& p) {
  const Vec3<Dyadic> v = p - cone.base, w = cone.apex - cone.base;
  const Dyadic ww = dot(w, w), vw = dot(v, w), h = ww - vw, rr = cone.radius * cone.radius;
  const Vec3<Dyadic> half = ww * (ww * v - vw * w) + (rr * h) * w;
  return {ww * (dot(v, v) * ww - vw * vw) - rr * h * h, half + half};
}

template <class S>
Field field(const S& s, const Vec3<Dyadic>& p) {
  return field(opened(s), p);
}

/// A cap's, in the plane at the base or the other.
template <class S>
Field cap_field(const S& s, int cap, const Vec3<Dyadic>& p) {
  const auto& [base, end, radius] = s;
  const Vec3<Dyadic> w = end - base;
  if (cap == 0) return {dot(base - p, w), -w};
  return {dot(p - end, w), w};
}

Field field(const Shape& shape, const Vec3<Real>& point, int patch) {
  return std::visit(
      [&](const auto& s) {
        if constexpr (requires { opened(s).base; })
          if (patch > 0) return cap_field(in<Dyadic>(s), patch - 1, exactly(point));
        return field(in<Dyadic>(s), exactly(point));
      },
      shape);
}

template <class H>
void each_case(H&& holds) {
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "invalid") return;
    require_each(family, shape, format, closed_too(drawn(family, shape, format, {}, 3, count)),
                 holds);
  });
}

/// Points about the surface: where the ray goes at the given t and near there, in float, double,
/// long double and in more bits than any of these.
std::vector<Vec3<Real>> points(const Case& question, const Real& t, std::mt19937_64& engine) {
  const Vec3<Wide> o = in<Wide>(question.ray.origin), d = in<Wide>(question.ray.direction);
  const Wide at = ldexp(Wide(t.high) + Wide(t.middle) + Wide(t.low), t.exponent);
  const Vec3<Wide> p = o + at * d;
  const Vec3<Wide> beside = o + (at * static_cast<double>(engine() >> 10) * 0x1p-53) * d;
  const auto each = [](const Vec3<Wide>& q, auto&& number) {
    return Vec3<Real>{number(q.x), number(q.y), number(q.z)};
  };
  const auto rounded = [&]<class N>(const Vec3<Wide>& q, N) {
    return each(q, [](const Wide& x) { return real(static_cast<N>(x)); });
  };
  const auto in_parts = [](const Wide& x) -> Real {
    if (x == 0) return {};
    const int e = ilogb(x);
    const Wide fraction = ldexp(x, -e);
    const auto high = static_cast<double>(fraction);
    const auto middle = static_cast<double>(Wide(fraction - high));
    const auto low = static_cast<double>(Wide(fraction - high - middle));
    return {high, middle, low, e};
  };
  const auto in_two = [&](const Wide& x) {
    Real two = in_parts(x);
    two.low = 0;
    return two;
  };
  return {rounded(p, 0.0f),     rounded(p, 0.0),       rounded(p, 0.0L), rounded(beside, 0.0f),
          rounded(beside, 0.0), rounded(beside, 0.0L), each(p, in_two),  each(beside, in_parts)};
}

bool is_finite(const Vec3<Real>& p) {
  return rayaudit::is_finite(p.x) && rayaudit::is_finite(p.y) && rayaudit::is_finite(p.z);
}

int cap_count(const Shape& shape) {
  return std::holds_alternative<CappedCylinder<double>>(shape) ? 2
         : std::holds_alternative<CappedCone<double>>(shape)   ? 1
                                                               : 0;
}

/// Some points to ask of a case, and patches of its shape: at its crossings, or where there is none
/// anywhere near.
template <class H>
bool holds_at_points(const Case& question, H&& holds) {
  std::mt19937_64 engine(17);
  std::vector<Real> places = {real(1.0)};
  const oracle::Truth truth = oracle::truth(question);
  for (const Crossing& crossing : truth.crossings()) places.push_back(crossing.t);
  for (const Real& t : places)
    for (const Vec3<Real>& point : points(question, t, engine))
      for (int patch = 0; patch <= cap_count(question.shape); ++patch)
        if (is_finite(point) && !holds(point, patch)) return false;
  return true;
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_sign_of_the_field_is_exact) {
  std::size_t zeros = 0, signs = 0;
  each_case([&](const Case& question) {
    return holds_at_points(question, [&](const Vec3<Real>& point, int patch) {
      const int sign = field(question.shape, point, patch).value.sign();
      ++(sign == 0 ? zeros : signs);
      return oracle::position(question.shape, point, patch).sign_of_field == sign;
    });
  });
  BOOST_TEST(zeros > 500 / one_in);
  BOOST_TEST(signs > 50'000 / one_in);
}

BOOST_AUTO_TEST_CASE(the_distance_is_that_of_the_linearised_field) {
  each_case([](const Case& question) {
    return holds_at_points(question, [&](const Vec3<Real>& point, int patch) {
      const Real distance = oracle::position(question.shape, point, patch).distance;
      const auto [value, gradient] = field(question.shape, point, patch);
      const Dyadic g = dot(gradient, gradient);
      if (g.sign() == 0) return is_nan(distance);
      const Dyadic d = exactly(distance);
      // 2^-29 of the squares is less than 1e-9 of the distance.
      return distance.high >= 0 && agree(d * d * g, value * value, 29);
    });
  });
}

namespace {

/// The roots of a restriction, none of them lost to cancellation; e is that of (-B + e sqrt(D)).
Wide root(const Restriction<Wide>& f, int e) {
  if (f.a == 0) return -f.c / (2 * f.half_b);
  const Wide to_root = sqrt(Wide(f.half_b * f.half_b - f.a * f.c));
  const Wide m = -f.half_b + e * to_root;
  return (f.half_b > 0) == (e < 0) ? m / f.a : f.c / (-f.half_b - e * to_root);
}

/// All numbers of a case in Wide, to be changed one by one.
template <class S>
struct Loose {
  Ray<Wide> ray;
  S shape;

  int patch = 0;

  Restriction<Wide> along() const {
    if constexpr (S::kinds[1] == Part::point)
      if (patch > 0) return restriction_to_cap(shape, patch - 1, ray.origin, ray.direction);
    return restriction(shape, ray.origin, ray.direction);
  }

  template <class V>
  void each_number(V&& visit) {
    const auto each = [&](auto& part) {
      if constexpr (requires { part.x; })
        visit(part.x), visit(part.y), visit(part.z);
      else
        visit(part);
    };
    each(ray.origin), each(ray.direction);
    std::apply([&](auto&... part) { (each(part), ...); }, shape.parts());
  }
};

/// Sum |x_j dt/dx_j| by central differences.
template <class S>
Wide forced_by_differences(Loose<S> loose, int e) {
  const Wide step = ldexp(Wide(1), -330);
  Wide sum = 0;
  loose.each_number([&](Wide& x) {
    const Wide kept = x;
    x = kept * (1 + step);
    const Wide above = root(loose.along(), e);
    x = kept * (1 - step);
    const Wide below = root(loose.along(), e);
    x = kept;
    sum += abs(Wide(above - below)) / (2 * step);
  });
  return sum;
}

Wide in_wide(const Real& x) {
  return ldexp(Wide(x.high) + Wide(x.middle) + Wide(x.low), x.exponent);
}

/// Which root of F a crossing is, from the shape of F alone; nothing at a double root.
std::optional<int> branch(const Restriction<Wide>& f, const Wide& t) {
  if (f.a == 0) return f.half_b > 0 ? 1 : -1;
  if (f.half_b * f.half_b == f.a * f.c) return {};
  return abs(Wide(root(f, 1) - t)) < abs(Wide(root(f, -1) - t)) ? 1 : -1;
}

/// Do the exponents of a case lie near enough for three hundred digits of F?
bool is_narrow(const Case& question) {
  int least = 2000, most = -2000;
  each_number(question, [&](double x) {
    if (x != 0) least = std::min(least, std::ilogb(x)), most = std::max(most, std::ilogb(x));
  });
  return most - least < 100;
}

/// The sign of F before a double root; through the apex of a closed cone that of outside, if the
/// line comes from there.
template <class S>
int side_before_double_root(const Loose<S>& loose, const Restriction<Wide>& f) {
  if (f.a > 0) return 1;
  if constexpr (std::is_same_v<S, CappedCone<Wide>>)
    return dot(loose.ray.direction, loose.shape.apex - loose.shape.base) < 0 ? 1 : -1;
  return -1;
}

/// How far the forced error of a crossing is from that of differences, relative to it; infinite
/// where the side or a double root is told wrongly.
double off_from_differences(const Case& question, const Crossing& crossing) {
  constexpr double wrong = std::numeric_limits<double>::infinity();
  const auto [forced, sign_before] = oracle::sensitivity(question, crossing);
  return std::visit(
      [&, sensed = forced, before = sign_before](const auto& shape) -> double {
        Loose<decltype(in<Wide>(shape))> loose = {in<Wide>(question.ray), in<Wide>(shape),
                                                  crossing.patch};
        const Restriction<Wide> f = loose.along();
        const std::optional<int> e = branch(f, in_wide(crossing.t));
        if (!e)
          return is_infinite(sensed) && before == side_before_double_root(loose, f) ? 0 : wrong;
        // F' at the root is e sqrt(D), or B of a linear F.
        if (before == *e || !rayaudit::is_finite(sensed)) return wrong;
        const Wide exact = forced_by_differences(loose, *e);
        if (exact == 0) return sensed.high == 0 ? 0 : wrong;
        return static_cast<double>(Wide(abs(Wide(in_wide(sensed) - exact)) / exact));
      },
      question.shape);
}

}  // namespace

BOOST_AUTO_TEST_CASE(the_forced_error_is_that_of_finite_differences) {
  std::size_t measured = 0, close = 0;
  each_case([&](const Case& question) {
    if (!is_narrow(question)) return true;
    const oracle::Truth truth = oracle::truth(question);
    for (const Crossing& crossing : truth.crossings()) {
      if (crossing.kind == Kind::within) continue;
      const double off = off_from_differences(question, crossing);
      ++measured;
      close += off <= 1e-6 ? 1 : 0;
      if (off > 1e-2) {
        BOOST_TEST_MESSAGE(name(crossing.kind) << ' ' << int{crossing.patch} << " off " << off);
        return false;
      }
    }
    return true;
  });
  BOOST_TEST(measured > 5000 / one_in);
  // A unit that errors are told in need not be sharper where the numbers of a case all but cancel.
  BOOST_TEST(close > 0.998 * static_cast<double>(measured));
}

BOOST_AUTO_TEST_CASE(roots_that_t_does_not_tell_apart_are_as_sensitive_as_a_double_one) {
  // The roots are 1 - 2^-300 and 1 + 2^-300, to 100 bits both of them 1.
  const Case question = {{{1, 0, 0}, {-1, 0, 0}}, Sphere<double>{{0, 0, 0}, 0x1p-300}};
  const oracle::Sensitivity found =
      oracle::sensitivity(question, {Kind::proper, real(1.0), real(1.0)});
  BOOST_TEST(is_infinite(found.forced));
  BOOST_TEST(found.sign_before == 1);
}

BOOST_AUTO_TEST_CASE(the_projection_is_known_to_the_bits_asked_for) {
  each_case([](const Case& question) {
    const Vec3<Dyadic> o = in<Dyadic>(question.ray.origin), d = in<Dyadic>(question.ray.direction);
    return holds_at_points(question, [&](const Vec3<Real>& point, int) {
      const Dyadic reach = dot(exactly(point) - o, d), length = dot(d, d);
      for (const int bits : {34, 63, 123, 150})
        if (!agree(exactly(oracle::projection(question.ray, point, bits)) * length, reach, bits))
          return false;
      return true;
    });
  });
}

BOOST_AUTO_TEST_CASE(positions_are_those_of_hand_worked_points) {
  const Shape sphere = read_case_line("sphere 0 0 0 5 ray 0 0 0 0 0 1").question.shape;
  const auto at = [&](double x, double y, double z) {
    return oracle::position(sphere, {real(x), real(y), real(z)});
  };
  BOOST_TEST(at(3, 4, 0).sign_of_field == 0);
  BOOST_TEST(at(3, 4, 0).distance.high == 0);
  BOOST_TEST(at(3, 4, 1).sign_of_field == 1);
  BOOST_TEST(at(0, 3, 0).sign_of_field == -1);
  BOOST_TEST(at(0, 10, 0).distance.high == 3.75);  // 75 / 20
  BOOST_TEST(is_nan(at(0, 0, 0).distance));
}
