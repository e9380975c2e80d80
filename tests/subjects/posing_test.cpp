#include "subjects/posing.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <cstring>

#include "families/family.hpp"
#include "geometry/case_line.hpp"
#include "oracle/truth.hpp"
#include "tests/watched.hpp"

/// Every way to pose a case, on drawn cases of every family and shape: what is asked has the form
/// that is declared, stays as it is when it is posed again, and is near the case drawn.
using namespace rayaudit;

namespace {

using Stand = Convention::Stand;
using Opening = Convention::Opening;

constexpr std::size_t many = 10'000, some = 1'000;

Case read(std::string_view line) { return read_case_line(line).question; }

/// Closed shapes as the families of the open ones draw them, where they have none of their own.
std::size_t drawn_as(const Family& family, std::size_t shape) {
  const std::size_t open = shape_names[shape].starts_with("capped_") ? shape - 2 : shape;
  return family.draw[shape] != nullptr ? shape : open;
}
Case of_shape(Case question, std::size_t shape) {
  if (question.shape.index() == shape) return question;
  std::visit(
      [&](const auto& open) {
        if constexpr (requires { open.top; })
          question.shape = CappedCylinder<double>{open.base, open.top, open.radius};
        else if constexpr (requires { open.apex; })
          question.shape = CappedCone<double>{open.base, open.apex, open.radius};
      },
      Shape(question.shape));
  return question;
}

/// Calls visit(case, format) for so many cases of every family, shape and format.
template <class Visit>
void each_drawn(std::size_t count, const Visit& visit) {
  for (const Family& family : families())
    for (std::size_t shape = 0; shape < shape_count; ++shape) {
      const std::size_t drawn = drawn_as(family, shape);
      if (family.draw[drawn] == nullptr) continue;
      for (const Format& format : {float_format, double_format})
        for (std::size_t first = 0; first < count; first += chunk_cases) {
          std::vector<Case> cases(std::min(chunk_cases, count - first));
          draw(family, drawn, format, {}, 7, first / chunk_cases, cases);
          for (std::size_t i = 0; i < cases.size(); i += one_in)
            visit(of_shape(cases[i], shape), format);
        }
    }
}

std::vector<double> numbers_of(const Case& question) {
  std::vector<double> numbers;
  each_number(question, [&](double x) { numbers.push_back(x); });
  numbers.insert(numbers.end(), {question.ray.t_min, question.ray.t_max});
  return numbers;
}

/// To the bit, NaNs and signs of zeros included.
bool are_same(const Case& a, const Case& b) {
  const std::vector<double> one = numbers_of(a), other = numbers_of(b);
  return a.shape.index() == b.shape.index() && a.extent == b.extent &&
         std::memcmp(one.data(), other.data(), one.size() * sizeof(double)) == 0;
}

Convention upright(Stand stand) { return {.stand = stand}; }
Convention opened(Opening opening) { return {.stand = Stand::upright_z, .opening = opening}; }

const std::vector<Convention>& conventions() {
  static const std::vector<Convention> all = {
      {.unit_direction = true},
      {.line = true, .extent = Extent::both_nappes},
      {.line = true, .segment = true},
      upright(Stand::upright_y),
      {.unit_direction = true, .stand = Stand::upright_z, .t_min = 0, .t_max = 100},
      opened(Opening::angle),
      opened(Opening::cosine),
      {.segment = true, .t_min = 0},
      {.extent = Extent::unbounded,
       .stand = Stand::upright_y,
       .opening = Opening::angle,
       .segment = true}};
  return all;
}

bool is_finite(const Case& question) {
  bool all = true;
  each_number(question, [&](double x) { all = all && std::isfinite(x); });
  return all;
}

bool is_valid(const Case& question) {
  return is_finite(question) && question.ray.t_min < question.ray.t_max &&
         !(question.ray.direction == Vec3<double>{0, 0, 0});
}

struct Axis {
  Vec3<long double> middle, way;
  long double radius;
};
std::optional<Axis> axis_of(const Case& question) {
  return std::visit(
      [](const auto& shape) -> std::optional<Axis> {
        const auto of = [&](const Vec3<double>& a, const Vec3<double>& b) {
          const auto from = in<long double>(a), to = in<long double>(b);
          return Axis{(from + to) / 2.0L, to - from, shape.radius};
        };
        if constexpr (requires { shape.top; })
          return of(shape.base, shape.top);
        else if constexpr (requires { shape.apex; })
          return of(shape.base, shape.apex);
        else
          return {};
      },
      question.shape);
}

long double length(const Vec3<long double>& v) { return std::sqrt(dot(v, v)); }

/// Are the truths of two cases the same to the last bit of t?
bool have_same_truth(const Case& a, const Case& b) {
  const oracle::Truth one = oracle::truth(a, 90), other = oracle::truth(b, 90);
  return one.invalid == other.invalid &&
         std::equal(one.crossings().begin(), one.crossings().end(), other.crossings().begin(),
                    other.crossings().end(), [&](const auto& x, const auto& y) {
                      return x.kind == y.kind && oracle::rounded<long double>(a, x) ==
                                                     oracle::rounded<long double>(b, y);
                    });
}

}  // namespace

BOOST_AUTO_TEST_CASE(what_is_posed_is_posed_again_as_it_is) {
  std::size_t i = 0;
  each_drawn(many, [&](const Case& question, const Format& format) {
    const Convention& convention = conventions()[++i % conventions().size()];
    const Case once = posed(question, convention, format);
    if (are_same(posed(once, convention, format), once) &&
        are_same(asked(once, convention, format), once))
      return;
    BOOST_REQUIRE_MESSAGE(false, i % conventions().size() << ": " << case_line(question) << "\n"
                                                          << case_line(once));
  });
}

BOOST_AUTO_TEST_CASE(what_is_posed_is_asked_again_from_its_line) {
  for (const Convention& convention : conventions())
    each_drawn(some / 4, [&](const Case& question, const Format& format) {
      const Case once = posed(question, convention, format);
      if (is_finite(once))
        BOOST_TEST_REQUIRE(are_same(asked(read(case_line(once)), convention, format), once),
                           case_line(question));
    });
}

BOOST_AUTO_TEST_CASE(what_is_posed_is_invalid_for_the_same_reason_or_valid) {
  std::size_t i = 0;
  each_drawn(some, [&](const Case& question, const Format& format) {
    Convention convention = conventions()[3 + ++i % (conventions().size() - 3)];
    convention.t_min = -std::numeric_limits<double>::infinity();
    convention.t_max = std::numeric_limits<double>::infinity();
    const Case made = posed(question, convention, format);
    const auto why = oracle::truth(made).invalid, was = oracle::truth(question).invalid;
    BOOST_TEST_REQUIRE((why == was), i << name(was) << ": " << case_line(question) << "\n"
                                       << name(why) << ": " << case_line(made));
  });
}

BOOST_AUTO_TEST_CASE(who_stands_upright_has_base_and_top_on_one_axis_and_all_else_as_it_was) {
  for (const Stand stand : {Stand::upright_y, Stand::upright_z})
    each_drawn(some, [&](const Case& question, const Format& format) {
      const auto was = axis_of(question);
      const Case made = posed(question, upright(stand), format);
      if (!was) BOOST_TEST_REQUIRE(are_same(made, question), case_line(question));
      if (!was || !is_finite(question) || length(was->way) == 0) return;
      const Axis is = *axis_of(made);
      BOOST_TEST_REQUIRE(length(is.middle) == 0, case_line(question));
      const long double along = stand == Stand::upright_y ? is.way.y : is.way.z;
      BOOST_TEST_REQUIRE(along == length(is.way), case_line(question));
      const auto x = in<long double>(question.ray.origin) - was->middle,
                 y = in<long double>(question.ray.direction), z = was->way;
      const auto p = in<long double>(made.ray.origin), q = in<long double>(made.ray.direction),
                 r = is.way;
      // Each number is rounded once, of so many in a product; a tiny one by more than a share.
      const long double u = std::ldexp(8.0L, format.unit_exponent());
      const long double tiny = std::ldexp(1.0L, format.min_exponent);
      const auto near = [&](long double a, long double b, long double size) {
        return std::fabs(a - b) <= u * size;
      };
      const long double a = length(x), b = length(y), c = length(z);
      if ((a > 0 && a < tiny) || b < tiny || c < tiny || a / tiny < 1 / tiny * 0) return;
      const long double world = length(r) / c, way = length(q) / b;
      BOOST_TEST_REQUIRE(near(length(p), world * a, world * a), case_line(question));
      BOOST_TEST_REQUIRE(near(dot(p, r), world * world * dot(x, z), world * world * a * c),
                         case_line(question));
      BOOST_TEST_REQUIRE(near(dot(q, r), way * world * dot(y, z), way * world * b * c),
                         case_line(question));
      BOOST_TEST_REQUIRE(near(dot(p, q), way * world * dot(x, y), way * world * a * b),
                         case_line(question));
      BOOST_TEST_REQUIRE(near(dot(p, cross(q, r)), way * world * world * dot(x, cross(y, z)),
                              way * world * world * a * b * c),
                         case_line(question) << "\n"
                                             << case_line(made));
    });
}

BOOST_AUTO_TEST_CASE(an_axis_along_a_coordinate_axis_only_has_coordinates_change_places) {
  const auto stands = [](std::string_view line, Stand stand) {
    const Case question = read(line), made = posed(question, upright(stand), float_format);
    BOOST_TEST(have_same_truth(question, made), line);
    return case_line(made);
  };
  const auto is = [](std::string_view line) { return case_line(read(line)); };
  const std::string_view along_x = "cylinder 1 2 3 5 2 3 0.5 ray 1 -6 4 0.5 2 -0.25 range 1 20";
  BOOST_TEST(stands(along_x, Stand::upright_z) ==
             is("cylinder 0 0 -2 0 0 2 0.5 ray -8 1 -2 2 -0.25 0.5 range 1 20"));
  BOOST_TEST(stands(along_x, Stand::upright_y) ==
             is("cylinder 0 -2 0 0 2 0 0.5 ray 1 -2 -8 -0.25 0.5 2 range 1 20"));
  const std::string_view down = "capped_cone 1 2 9 1 2 3 0.5 ray 1 -6 4 0.5 2 -0.25";
  const std::string upright_z = stands(down, Stand::upright_z);
  BOOST_TEST(upright_z.starts_with("capped_cone 0x0p+0 0x0p+0 -0x1.8p+1 0x0p+0 0x0p+0 0x1.8p+1 "),
             upright_z);
  // It stands already: nothing turns about its axis either.
  const std::string_view up = "cone -0.0 0 -3 0 0 3 0.5 ray 1 -6 4 0.5 2 -0.25 range nan 1";
  BOOST_TEST(stands(up, Stand::upright_z) == is(up));
  BOOST_TEST(stands("cone 1 0 -3 1 0 3 0.5 ray 1 -6 4 0.5 2 -0.25", Stand::upright_z) ==
             is("cone 0 0 -3 0 0 3 0.5 ray 0 -6 4 0.5 2 -0.25"));
}

BOOST_AUTO_TEST_CASE(where_nothing_is_rounded_the_truth_of_an_upright_case_is_the_same) {
  std::size_t count = 0;
  for (const Stand stand : {Stand::upright_y, Stand::upright_z})
    each_drawn(some, [&](const Case& question, const Format& format) {
      const auto axis = axis_of(question);
      if (!axis || !is_finite(question)) return;
      const auto [x, y, z] = axis->way;
      if ((x != 0) + (y != 0) + (z != 0) != 1) return;
      const auto from = in<long double>(question.ray.origin) - axis->middle;
      const auto base = axis->middle - axis->way / 2.0L, to = axis->middle + axis->way / 2.0L;
      const bool is_exact = std::visit(
          [&](const auto& shape) {
            if constexpr (requires { shape.base; })
              return base == in<long double>(shape.base) && to + base == 2.0L * axis->middle &&
                     from + axis->middle == in<long double>(question.ray.origin);
            return false;
          },
          question.shape);
      if (!is_exact) return;
      for (const long double each : {from.x, from.y, from.z, x / 2, y / 2, z / 2})
        if (posing::in_format(each, format) != each) return;
      const Case made = posed(question, upright(stand), format);
      BOOST_TEST_REQUIRE(have_same_truth(question, made), case_line(question) << "\n"
                                                                              << case_line(made));
      ++count;
    });
  BOOST_TEST(count > 3'000);
}

BOOST_AUTO_TEST_CASE(a_cone_has_the_opening_that_it_is_told_by) {
  for (const Opening opening : {Opening::angle, Opening::cosine})
    each_drawn(some, [&](const Case& question, const Format& format) {
      const Case made = posed(question, opened(opening), format);
      const auto was = axis_of(question), is = axis_of(made);
      const bool is_cone = shape_names[question.shape.index()].ends_with("cone");
      if (!is_cone || !is_finite(question) || length(was->way) == 0 || !(was->radius > 0)) return;
      BOOST_TEST_REQUIRE(is->way.z == 1, case_line(question));
      const long double k = was->radius / length(was->way);
      const auto told = [&](long double r) {
        return opening == Opening::angle ? std::atan(r) : 1 / std::sqrt(1 + r * r);
      };
      const long double said = posing::in_format(told(is->radius), format);
      const long double again =
          opening == Opening::angle ? std::tan(said) : std::sqrt((1 - said) * (1 + said)) / said;
      BOOST_TEST_REQUIRE(is->radius == static_cast<double>(again), case_line(question));
      // A cone must have one; and of tiny numbers standing it up rounds much away.
      const long double tiny = std::ldexp(1.0L, format.min_exponent);
      if (told(k) < tiny || length(was->way) < tiny) return;
      const long double spacing = std::ldexp(1.0L, format.unit_exponent());
      BOOST_TEST_REQUIRE(std::fabs(said - told(k)) <= 4 * spacing * told(k), case_line(question));
      BOOST_TEST_REQUIRE(is->radius > 0, case_line(question));
    });
}

BOOST_AUTO_TEST_CASE(a_segment_is_the_exact_way_between_two_points_of_the_format) {
  each_drawn(some, [&](const Case& question, const Format& format) {
    const Case made = posed(question, {.segment = true, .t_min = 0}, format);
    if (!is_valid(question)) return;
    BOOST_TEST_REQUIRE(posing::is_segment(made.ray, format), case_line(question)
                                                                 << "\n"
                                                                 << case_line(made));
    BOOST_TEST_REQUIRE((made.shape == question.shape), case_line(question));
  });
}

BOOST_AUTO_TEST_CASE(
    a_segment_of_small_whole_numbers_is_of_the_same_ray_and_ends_beyond_the_shape) {
  const auto is = [](std::string_view line) { return case_line(read(line)); };
  const auto cut = [](std::string_view line, const Format& format) {
    return case_line(posed(read(line), {.segment = true}, format));
  };
  BOOST_TEST(cut("sphere 0 0 0 1 ray 0 0 -3 0 0 1", float_format) ==
             is("sphere 0 0 0 1 ray 0 0 -3 0 0 16 range 0 1"));
  BOOST_TEST(cut("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 2.5", float_format) ==
             is("sphere 0 0 0 1 ray 0 0 -3 0 0 2.5 range 0 1"));
  BOOST_TEST(cut("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 2.5 3", float_format) ==
             is("sphere 0 0 0 1 ray 0 0 -0.5 0 0 0.5 range 0 1"));
  BOOST_TEST(cut("sphere 0 0 0 1 ray 0 0 -3 0 0 1 range 0 1e30", float_format) ==
             is("sphere 0 0 0 1 ray 0 0 -3 0 0 16 range 0 1"));
  // Of floats 1 and 2^-40 + 2 the difference is no float: it stays a double.
  const std::string_view fine = "sphere 0 0 0 1 ray 1 0 0 -0x1.ffffffffep-1 0 1 range 0 1";
  BOOST_TEST(cut(fine, float_format) == is(fine));
  BOOST_TEST(case_line(asked(read(fine), {.segment = true}, float_format)) == is(fine));
  BOOST_TEST(case_line(asked(read(fine), {}, float_format)) != is(fine));
}

BOOST_AUTO_TEST_CASE(where_two_doubles_have_no_difference_that_is_one_they_are_rounded) {
  const Case made = posed(read("sphere 0 0 0 1 ray 1e-30 0.1 -3 0.1 0x1p-70 1"), {.segment = true},
                          double_format);
  BOOST_TEST(posing::is_segment(made.ray, double_format), case_line(made));
  BOOST_TEST(made.ray.origin.x != 1e-30);
  BOOST_TEST(std::fabs(made.ray.origin.x) < 1e-14);
  BOOST_TEST(made.ray.origin.y == 0.1);
}

BOOST_AUTO_TEST_CASE(an_extent_is_that_of_the_subject_and_of_open_shapes) {
  const auto extents = [](std::string_view line, Extent extent) {
    return case_line(asked(read(line), {.extent = extent}, double_format));
  };
  const auto is = [](std::string_view line) { return case_line(read(line)); };
  const std::string ray = " ray 0 0 -3 0 0 1";
  BOOST_TEST(extents("disk 0 0 0 0 0 1 1" + ray, Extent::unbounded) ==
             is("disk 0 0 0 0 0 1 1 unbounded" + ray));
  BOOST_TEST(extents("cone 0 0 0 0 0 1 1" + ray, Extent::both_nappes) ==
             is("cone 0 0 0 0 0 1 1 both_nappes" + ray));
  BOOST_TEST(extents("cylinder 0 0 0 0 0 1 1" + ray, Extent::both_nappes) ==
             is("cylinder 0 0 0 0 0 1 1 unbounded" + ray));
  for (const std::string shape : {"sphere 0 0 0 1", "capped_cone 0 0 0 0 0 1 1"})
    BOOST_TEST(extents(shape + ray, Extent::unbounded) == is(shape + ray));
  BOOST_TEST(extents("cone 0 0 0 0 0 1 1 both_nappes" + ray, Extent::bounded) ==
             is("cone 0 0 0 0 0 1 1" + ray));
  // What does not declare how much it knows leaves a case as it is, when it is only posed.
  const Case endless = read("cone 0 0 0 0 0 1 1 unbounded" + ray);
  BOOST_TEST((posed(endless, {.unit_direction = true}, double_format) == endless));
}
