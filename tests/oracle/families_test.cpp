#include <map>

#include "oracle/truth.hpp"
#include "tests/families/drawn.hpp"

using namespace rayaudit;
using oracle::Kind;
using oracle::Truth;

namespace {

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2, cone = 3;
constexpr std::size_t capped_cylinder = 4, capped_cone = 5;

bool begins_with(const Truth& truth, Kind kind) {
  return truth.count > 0 && truth.listed[0].kind == kind;
}
bool is_touch(const Truth& truth, Kind kind) {
  return truth.count == 1 && begins_with(truth, kind);
}
bool is_miss(const Truth& truth) { return truth.count == 0; }

/// Requires holds(truth) of every case of a family for a shape, in float and in double.
template <class H>
void require_truths(std::string_view id, std::size_t shape, H&& holds) {
  const Family& family = family_of(id);
  for (const Format& format : {float_format, double_format})
    require_each(family, shape, format, drawn(family, shape, format),
                 [&](const Case& question) { return holds(oracle::truth(question)); });
}

template <class H>
double share_of_truths(const Family& family, std::size_t shape, const Format& format, H&& holds) {
  return share(drawn(family, shape, format),
               [&](const Case& question) { return holds(oracle::truth(question)); });
}

bool is_hit(const Truth& truth) { return truth.hit() != nullptr; }

}  // namespace

BOOST_AUTO_TEST_CASE(every_case_but_the_invalid_ones_is_valid) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    require_each(family, shape, format, drawn(family, shape, format), [&](const Case& question) {
      return (oracle::truth(question).invalid != oracle::Invalid::no) == (family.id == "invalid");
    });
  });
}

BOOST_AUTO_TEST_CASE(invalid_cases_come_in_every_way_that_the_shape_has) {
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    std::map<oracle::Invalid, int> ways;
    for (const Case& question : drawn(family_of("invalid"), shape, double_format))
      ++ways[oracle::truth(question).invalid];
    BOOST_TEST(ways.size() == (shape == sphere ? 5u : 6u), shape_names[shape]);
    for (const auto& [way, count] : ways) BOOST_TEST(count > 100, oracle::name(way));
  }
}

BOOST_AUTO_TEST_CASE(every_tangent_case_is_a_tangent) {
  for (const auto shape : {sphere, cylinder, cone, capped_cylinder, capped_cone})
    require_truths("tangent", shape,
                   [](const Truth& truth) { return is_touch(truth, Kind::tangent); });
}

BOOST_AUTO_TEST_CASE(every_rim_case_touches_the_rim_first) {
  for (const auto shape : {disk, cylinder, cone})
    require_truths("rim", shape, [](const Truth& truth) { return begins_with(truth, Kind::rim); });
}

BOOST_AUTO_TEST_CASE(half_of_the_rays_through_an_edge_cross_there_and_half_graze_it) {
  const auto crosses = [](const Truth& truth) { return is_touch(truth, Kind::proper); };
  const auto grazes = [](const Truth& truth) { return is_touch(truth, Kind::rim); };
  for (const auto shape : {capped_cylinder, capped_cone}) {
    require_truths("rim", shape,
                   [&](const Truth& truth) { return crosses(truth) || grazes(truth); });
    for (const Format& format : {float_format, double_format}) {
      const double grazing = share_of_truths(family_of("rim"), shape, format, grazes);
      BOOST_TEST(grazing > 0.4);
      BOOST_TEST(grazing < 0.6);
    }
  }
}

BOOST_AUTO_TEST_CASE(every_apex_case_touches_the_apex_or_passes_properly) {
  const auto touches = [](const Truth& truth) { return is_touch(truth, Kind::apex); };
  const auto passes = [](const Truth& truth) { return is_touch(truth, Kind::proper); };
  require_truths("apex", cone, [&](const Truth& truth) { return touches(truth) || passes(truth); });
  require_truths("apex", capped_cone, [&](const Truth& truth) {
    return touches(truth) || begins_with(truth, Kind::proper);
  });
  for (const auto shape : {cone, capped_cone}) {
    const double touching = share_of_truths(family_of("apex"), shape, float_format, touches);
    BOOST_TEST(touching > 0.6);
    BOOST_TEST(touching < 0.9);
  }
}

BOOST_AUTO_TEST_CASE(parallel_rays_miss_disk_and_cylinder_and_never_touch_the_cone_twice) {
  require_truths("parallel", disk, is_miss);
  require_truths("parallel", cylinder, is_miss);
  require_truths("parallel", cone, [](const Truth& truth) { return truth.count <= 1; });
}

BOOST_AUTO_TEST_CASE(a_ray_parallel_to_a_cap_or_the_axis_hardly_ever_touches_a_closed_cylinder) {
  const auto touches = [](const Truth& truth) {
    return !is_miss(truth) && !begins_with(truth, Kind::proper);
  };
  for (const Format& format : {float_format, double_format}) {
    BOOST_TEST(share_of_truths(family_of("parallel"), capped_cylinder, format, touches) < 0.1);
    BOOST_TEST(share_of_truths(family_of("parallel"), capped_cylinder, format, is_hit) > 0.25);
  }
}

BOOST_AUTO_TEST_CASE(every_case_within_is_within_or_a_miss) {
  for (const auto shape : {disk, cylinder, cone, capped_cylinder, capped_cone}) {
    const auto within = [](const Truth& truth) { return is_touch(truth, Kind::within); };
    require_truths("within", shape,
                   [&](const Truth& truth) { return within(truth) || is_miss(truth); });
    BOOST_TEST(share_of_truths(family_of("within"), shape, double_format, within) > 0.6);
  }
}

BOOST_AUTO_TEST_CASE(every_surface_case_starts_on_the_surface) {
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    require_truths("surface", shape,
                   [](const Truth& truth) { return begins_with(truth, Kind::start); });
}

BOOST_AUTO_TEST_CASE(every_case_behind_is_a_miss_that_hits_when_turned_round) {
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    require_truths("behind", shape, is_miss);
    const double hits = share(drawn(family_of("behind"), shape, double_format), [](Case question) {
      question.ray.direction = -question.ray.direction;
      return is_hit(oracle::truth(question));
    });
    BOOST_TEST(hits > 0.95, shape_names[shape]);
  }
}

BOOST_AUTO_TEST_CASE(every_ray_from_inside_a_closed_shape_hits_it) {
  for (const auto shape : {sphere, capped_cylinder, capped_cone})
    require_truths("inside", shape, is_hit);
}

BOOST_AUTO_TEST_CASE(every_ray_that_grazes_a_sphere_from_inside_its_radius_hits_it) {
  const Family& family = family_of("grazing");
  for (const int k : {1, 10, 20}) {
    const double hits = share(drawn(family, sphere, float_format, k),
                              [](const Case& question) { return is_hit(oracle::truth(question)); });
    BOOST_TEST(hits > 0.4);
    BOOST_TEST(hits < 0.6);
  }
}

BOOST_AUTO_TEST_CASE(near_cases_fall_on_both_sides) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    if (family.strength != Strength::near) return;
    const bool rarely = family.id == "within-near" || family.id == "surface-near";
    BOOST_TEST_CONTEXT(family.id << ' ' << shape_names[shape] << ' ' << format.name) {
      BOOST_TEST(share_of_truths(family, shape, format, is_hit) > (rarely ? 0.005 : 0.25));
      BOOST_TEST(share_of_truths(family, shape, format, is_miss) > 0.2);
    }
  });
}

BOOST_AUTO_TEST_CASE(near_half_of_the_rays_anywhere_hit) {
  each_drawing([](const Family& family, std::size_t shape, const Format& format) {
    const bool general = family.strength == Strength::anywhere;
    if (!general || family.id == "behind" || family.id == "invalid" || family.id == "inside")
      return;
    const double hits = share_of_truths(family, shape, format, is_hit);
    const bool narrow = family.id == "anywhere";
    BOOST_TEST_CONTEXT(family.id << ' ' << shape_names[shape] << ' ' << format.name) {
      BOOST_TEST(hits > (narrow ? 0.35 : 0.2));
      BOOST_TEST(hits < (narrow ? 0.65 : 0.85));
    }
  });
}

BOOST_AUTO_TEST_CASE(the_lattice_has_touches_of_every_kind_and_hits_at_the_world_origin) {
  std::map<Kind, int> kinds;
  int at_origin = 0;
  for (std::size_t shape = 0; shape < shape_count; ++shape)
    for (const Case& question : drawn(family_of("lattice"), shape, float_format)) {
      const Truth truth = oracle::truth(question);
      for (const auto& crossing : truth.crossings()) ++kinds[crossing.kind];
      if (!truth.hit()) continue;
      const double t = oracle::rounded<double>(question, *truth.hit());
      at_origin += question.ray.origin + t * question.ray.direction == Vec3<double>{0, 0, 0};
    }
  BOOST_TEST(kinds.size() == 7u);
  BOOST_TEST(at_origin > 600);
}
