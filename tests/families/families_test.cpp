#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

#include "families/near.hpp"
#include "tests/families/drawn.hpp"

using namespace rayaudit;

namespace {

template <class V>
void each_number_and_range(const Case& question, V&& visit) {
  each_number(question, visit);
  visit(question.ray.t_min);
  visit(question.ray.t_max);
}

/// FNV-1a over the bits of every number, so that NaN and the sign of zero count.
std::uint64_t hash(std::uint64_t seed, const std::vector<Case>& cases) {
  for (const Case& question : cases)
    each_number_and_range(question, [&](double x) {
      const auto bits = std::bit_cast<std::uint64_t>(std::isnan(x) ? std::abs(x) : x);
      for (int byte = 0; byte < 8; ++byte)
        seed = (seed ^ (bits >> (8 * byte) & 0xff)) * 0x100000001b3;
    });
  return seed;
}
std::uint64_t hash(const std::vector<Case>& cases) { return hash(0xcbf29ce484222325, cases); }

double length(const Vec3<double>& v) { return std::sqrt(dot(v, v)); }

/// The ids and the shapes they go with (d, s, c, k: cone; C, K: the closed ones), as the design has
/// them.
constexpr std::pair<std::string_view, std::string_view> design[] = {
    {"anywhere", "dsckCK"},
    {"grazing", "dsckCK"},
    {"tangent", "sckCK"},
    {"tangent-near", "sckCK"},
    {"rim", "dckCK"},
    {"rim-near", "dckCK"},
    {"apex", "kK"},
    {"apex-near", "kK"},
    {"parallel", "dckCK"},
    {"parallel-near", "dckCK"},
    {"perpendicular", "dckCK"},
    {"within", "dckCK"},
    {"within-near", "dckCK"},
    {"inside", "sckCK"},
    {"surface", "dsckCK"},
    {"surface-near", "dsckCK"},
    {"spawned", "dsckCK"},
    {"far", "dsckCK"},
    {"placement", "dsckCK"},
    {"slender", "ckCK"},
    {"flat", "ckCK"},
    {"length", "dsckCK"},
    {"unit", "dsckCK"},
    {"axis", "dsckCK"},
    {"scale", "dsckCK"},
    {"behind", "dsckCK"},
    {"lattice", "dsckCK"},
    {"invalid", "dsckCK"},
};

constexpr std::size_t capped_cylinder = 4;

}  // namespace

BOOST_AUTO_TEST_CASE(the_table_has_the_families_and_shapes_of_the_design) {
  BOOST_REQUIRE(families().size() == std::size(design));
  for (std::size_t i = 0; i < std::size(design); ++i) {
    const Family& family = families()[i];
    std::string shapes;
    for (std::size_t shape = 0; shape < shape_count; ++shape)
      if (family.draw[shape]) shapes += "dsckCK"[shape];
    BOOST_TEST(family.id == design[i].first);
    BOOST_TEST(shapes == design[i].second, family.id);
  }
}

BOOST_AUTO_TEST_CASE(every_case_is_of_the_shape_asked_for) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    require_each(family, shape, format, drawn(family, shape, format),
                 [&](const Case& question) { return question.shape.index() == shape; });
  });
}

BOOST_AUTO_TEST_CASE(every_number_of_a_float_case_is_a_float) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (format != float_format) return;
    require_each(family, shape, format, drawn(family, shape, format), [&](const Case& question) {
      bool all = true;
      each_number_and_range(question, [&](double x) {
        all = all && (std::isnan(x) || static_cast<double>(static_cast<float>(x)) == x);
      });
      return all;
    });
  });
}

BOOST_AUTO_TEST_CASE(double_cases_use_the_whole_significand_but_on_the_lattice) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (format != double_format || family.id == "lattice") return;
    const auto cases = drawn(family, shape, format);
    BOOST_TEST(share(cases,
                     [](const Case& question) {
                       const double x = question.ray.origin.x;
                       return static_cast<double>(static_cast<float>(x)) != x;
                     }) > 0.3,
               family.id << ' ' << shape_names[shape]);
  });
}

BOOST_AUTO_TEST_CASE(a_chunk_depends_on_its_arguments_alone) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    const auto once = drawn(family, shape, format, {}, 3);
    drawn(family, shape, format, {}, 7);
    BOOST_TEST(hash(once) == hash(drawn(family, shape, format, {}, 3)));
    BOOST_TEST(hash(once) != hash(drawn(family, shape, format, {}, 4)));
  });
}

BOOST_AUTO_TEST_CASE(fewer_cases_are_the_first_of_the_chunk) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    auto all = drawn(family, shape, format);
    all.resize(10);
    BOOST_TEST(hash(all) == hash(drawn(family, shape, format, {}, 0, 10)));
  });
}

BOOST_AUTO_TEST_CASE(cases_do_not_repeat_but_on_the_lattice) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (family.id == "lattice") return;
    std::set<std::uint64_t> seen;
    for (const Case& question : drawn(family, shape, format)) seen.insert(hash({question}));
    BOOST_TEST(seen.size() > chunk_cases - 10, family.id << ' ' << shape_names[shape]);
  });
}

BOOST_AUTO_TEST_CASE(a_difficulty_is_ignored_where_the_family_has_none) {
  const Family& family = family_of("tangent");
  BOOST_TEST(hash(drawn(family, 1, float_format, 5)) == hash(drawn(family, 1, float_format)));
}

BOOST_AUTO_TEST_CASE(every_difficulty_of_the_range_draws_numbers_that_are_finite) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (!family.difficulty) return;
    for (int k = family.difficulty->least; k <= family.difficulty->most(format); ++k)
      require_each(family, shape, format, drawn(family, shape, format, k, 0, 16),
                   [](const Case& question) {
                     bool finite = true;
                     each_number(question, [&](double x) { finite = finite && std::isfinite(x); });
                     return finite && question.ray.direction != Vec3<double>{0, 0, 0};
                   });
  });
}

/// Whoever means to change what a family draws changes the number.
BOOST_AUTO_TEST_CASE(the_cases_are_the_same_with_every_compiler) {
  std::uint64_t open = 0, closed = 0;
  each_drawing([&](const Family& family, std::size_t shape, const Format& format) {
    std::uint64_t& all = shape < capped_cylinder ? open : closed;
    all = hash(all, drawn(family, shape, format));
  });
  BOOST_TEST(open == 17635673214927589465u);
  BOOST_TEST(closed == 9269039314635321987u);
}

BOOST_AUTO_TEST_CASE(far_origins_are_two_to_the_k_radii_away) {
  for (const int k : {4, 12, 20})
    require_each(family_of("far"), 1, float_format, drawn(family_of("far"), 1, float_format, k),
                 [&](const Case& question) {
                   const auto& sphere = std::get<Sphere<double>>(question.shape);
                   const double away = length(question.ray.origin - sphere.centre) / sphere.radius;
                   return away > std::ldexp(0.5, k) - 4 && away < std::ldexp(2, k) + 4;
                 });
}

BOOST_AUTO_TEST_CASE(lengths_are_two_to_the_k_both_ways) {
  const auto cases = drawn(family_of("length"), 1, double_format, 100);
  const double large = share(
      cases, [](const Case& question) { return length(question.ray.direction) > 0x0.ffffp100; });
  const double small = share(
      cases, [](const Case& question) { return length(question.ray.direction) < 0x2.0001p-100; });
  BOOST_TEST(large > 0.4);
  BOOST_TEST(large + small == 1);
}

BOOST_AUTO_TEST_CASE(slender_and_flat_have_the_height_they_say) {
  const auto has_height = [](double height) {
    return [height](const Case& question) {
      const auto& cylinder = std::get<Cylinder<double>>(question.shape);
      const double ratio = length(cylinder.top - cylinder.base) / cylinder.radius;
      return std::abs(ratio / height - 1) < 0.02;
    };
  };
  const Family &slender = family_of("slender"), &flat = family_of("flat");
  for (const int k : {1, 8, 16}) {
    require_each(slender, 2, float_format, drawn(slender, 2, float_format, k),
                 has_height(std::ldexp(1, k)));
    require_each(flat, 2, float_format, drawn(flat, 2, float_format, k),
                 has_height(std::ldexp(1, -k)));
  }
}

BOOST_AUTO_TEST_CASE(placements_lie_from_1e6_to_1e8_away) {
  require_each(family_of("placement"), 1, float_format,
               drawn(family_of("placement"), 1, float_format), [](const Case& question) {
                 const double away = length(std::get<Sphere<double>>(question.shape).centre);
                 return away > 0.99e6 && away < 1.01e8;
               });
}

BOOST_AUTO_TEST_CASE(units_are_normalised_to_rounding) {
  for (const Format& format : {float_format, double_format})
    require_each(family_of("unit"), 0, format, drawn(family_of("unit"), 0, format),
                 [&](const Case& question) {
                   const double off = std::abs(length(question.ray.direction) - 1);
                   return off < std::ldexp(4, format.unit_exponent());
                 });
}

BOOST_AUTO_TEST_CASE(axis_directions_have_two_zeros_of_both_signs) {
  const auto cases = drawn(family_of("axis"), 3, double_format);
  int negative = 0;
  require_each(family_of("axis"), 3, double_format, cases, [&](const Case& question) {
    int zeros = 0;
    for (const double x :
         {question.ray.direction.x, question.ray.direction.y, question.ray.direction.z}) {
      zeros += x == 0;
      negative += x == 0 && std::signbit(x);
    }
    return zeros == 2;
  });
  BOOST_TEST(negative > 900);
  BOOST_TEST(negative < 1150);
}

BOOST_AUTO_TEST_CASE(scale_reaches_the_limits_of_the_format) {
  for (const Format& format : {float_format, double_format}) {
    double least = INFINITY, most = 0;
    for (const Case& question : drawn(family_of("scale"), 1, format))
      each_number(question, [&](double x) {
        least = std::min(least, std::abs(x)), most = std::max(most, std::abs(x));
      });
    BOOST_TEST(std::ilogb(least) < format.min_exponent);
    BOOST_TEST(std::ilogb(most) > format.max_exponent - 8);
  }
}

BOOST_AUTO_TEST_CASE(a_quarter_of_the_surface_cases_begin_at_t_min) {
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    const double later = share(drawn(family_of("surface"), shape, float_format),
                               [](const Case& question) { return question.ray.t_min != 0; });
    BOOST_TEST(later > 0.2);
    BOOST_TEST(later < 0.3);
  }
}

BOOST_AUTO_TEST_CASE(a_quarter_of_the_spheres_near_the_surface_are_planets_seen_from_2_above) {
  const double planets =
      share(drawn(family_of("surface-near"), 1, double_format), [](const Case& question) {
        const auto& sphere = std::get<Sphere<double>>(question.shape);
        const double above = length(question.ray.origin - sphere.centre) - 6.4e6;
        return sphere.radius == 6.4e6 && std::abs(above - 2) < 1e-6;
      });
  BOOST_TEST(planets > 0.2);
  BOOST_TEST(planets < 0.3);
}

BOOST_AUTO_TEST_CASE(a_third_of_the_lattice_are_the_shapes_of_the_handout) {
  const Shape cone = Cone<double>{{0, 0, 0}, {0, 1, 0}, 1};
  const double handout = share(drawn(family_of("lattice"), 3, float_format),
                               [&](const Case& question) { return question.shape == cone; });
  BOOST_TEST(handout > 0.28);
  BOOST_TEST(handout < 0.45);
}

BOOST_AUTO_TEST_CASE(a_step_is_one_number_of_the_format_further) {
  BOOST_TEST(drawing::stepped<float>(1, 1) == 1 + 0x1p-23);
  BOOST_TEST(drawing::stepped<float>(-1, -1) == -1 + 0x1p-24);
  BOOST_TEST(drawing::stepped<double>(3, 4) == 3 + 0x1p-49);
  BOOST_TEST(drawing::stepped<float>(0, -2) == -0x1p-22);
}

BOOST_AUTO_TEST_CASE(near_cases_have_one_number_off_by_two_to_the_k) {
  const auto question = drawing::near<drawing::rim<Disk>>;
  for (const int k : {0, 3, 10}) {
    for (std::uint64_t chunk = 0; chunk < 50; ++chunk) {
      Random a(1, "", "", float_format, {}, chunk), b(1, "", "", float_format, {}, chunk);
      const Case exact = drawing::rim<Disk>(a, float_format, 0), off = question(b, float_format, k);
      std::vector<double> numbers, moved;
      each_number(exact, [&](double x) { numbers.push_back(x); });
      each_number(off, [&](double x) { moved.push_back(x); });
      int changed = 0;
      for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] == moved[i]) continue;
        ++changed;
        const double up = drawing::stepped<float>(numbers[i], 1 << k);
        const double down = drawing::stepped<float>(numbers[i], -(1 << k));
        BOOST_TEST((moved[i] == up || moved[i] == down), case_line(off));
      }
      BOOST_TEST(changed == 1, case_line(off));
    }
  }
}
