#include "scenes/scene_audit.hpp"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>
#include <utility>

#include "tests/audit/named.hpp"
#include "tests/scenes/account_text.hpp"

using namespace rayaudit;

namespace {

constexpr std::size_t disk = 0, sphere = 1, cylinder = 2;

const Subject& routine() { return *subject_of("textbook/double"); }

Scene scene_of(const std::vector<Shape>& shapes, const std::vector<Seam>& seams = {}) {
  Scene scene;
  for (const Shape& shape : shapes) scene.primitives.push_back({.shape = shape});
  scene.seams = seams;
  return scene;
}

std::vector<std::uint32_t> all_of(const Scene& scene) {
  std::vector<std::uint32_t> all(scene.primitives.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

/// An audit in which every ray is asked for every shape.
SceneAuditing auditing(const Scene& scene, const Subject& subject,
                       std::span<const Offset> offsets = {}) {
  return {scene, subject, [&scene](const Ray<double>&) { return all_of(scene); }, offsets};
}

/// A ray that leaves a primitive at a point, by no offset.
SceneRay leaving(std::int32_t from, const Vec3<double>& point, const Vec3<double>& normal,
                 const Vec3<double>& direction) {
  return {.ray = {point, direction},
          .from = from,
          .departure = {point, normal, std::numeric_limits<double>::quiet_NaN()}};
}

/// A wave in which every ray was asked for every shape, and the subject answered.
Wave wave_of(const Scene& scene, const Subject& subject, const std::vector<SceneRay>& rays,
             Effect effect = Effect::primary, int bounce = 0) {
  Wave wave = {.effect = effect, .bounce = bounce, .rays = rays};
  for (std::uint32_t ray = 0; ray < rays.size(); ++ray)
    for (std::uint32_t i = 0; i < scene.primitives.size(); ++i) {
      const Shape& shape = scene.primitives[i].shape;
      wave.pairs[shape.index()].push_back({ray, i});
      wave.cases[shape.index()].push_back({rays[ray].ray, shape});
    }
  for (std::size_t shape = 0; shape < shape_count; ++shape) {
    wave.answers[shape].resize(wave.cases[shape].size());
    subject.answer[shape](wave.cases[shape], wave.answers[shape]);
  }
  return wave;
}

/// What a wave comes to, and what is to be seen in four pixels.
struct Told {
  SceneAccount account = {};
  std::vector<Sight> sights = std::vector<Sight>(4);
};
Told told(const SceneAuditing& auditing, const Wave& wave, std::uint32_t first_pixel = 0) {
  Told told;
  audit_wave(auditing, wave, told.account, first_pixel, told.sights);
  return told;
}

/// Has a subject answer a shape by a function of the case.
template <class Say>
Subject saying(std::size_t shape, const Say& say) {
  Subject subject = routine();
  subject.name = "planted/double";
  subject.answer[shape] = [say](std::span<const Case> cases, std::span<Answer> answers) {
    for (std::size_t i = 0; i < cases.size(); ++i) answers[i] = say(cases[i]);
  };
  return subject;
}

Offset t_min_of(double amount) {
  return {.kind = Offset::Kind::t_min, .amount = amount, .name = "t_min"};
}
Offset normal_of(double ulps) {
  return {.kind = Offset::Kind::normal, .amount = ulps, .name = "normal"};
}
const Offset no_offset = {.kind = Offset::Kind::none, .amount = 0, .name = "none"};

const Sphere<double> ball = {{0, 0, 0}, 1};
const SceneRay from_below = {.ray = {{0, 0, -3}, {0, 0, 1}}};
const SceneRay beside = {.ray = {{0, 2, -3}, {0, 0, 1}}};

/// A can: a cylinder with a lid, the seam between them at height 1.
const Scene can = scene_of(
    {Disk<double>{{0, 0, 1}, {0, 0, 1}, 1}, Cylinder<double>{{0, 0, 0}, {0, 0, 1}, 1}}, {{0, 1}});
/// Down through the lid, just inside its rim.
const SceneRay into_lid = {.ray = {{0.999, 0, 2}, {0, 0, -1}}};

}  // namespace

BOOST_AUTO_TEST_CASE(a_trouble_keeps_the_first_of_its_severest_cases) {
  const auto at = [](double x) { return Case{{{x, 0, 0}, {0, 0, 1}}, ball}; };
  const auto trouble = [&](const std::vector<std::pair<double, double>>& all) {
    Trouble made;
    for (const auto& [severity, x] : all) made.add(severity, at(x));
    return made;
  };
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  const Trouble low = trouble({{unknown, 1}, {0, 2}}),
                high = trouble({{1, 3}, {3, 4}, {3, 5}, {2, 6}});
  BOOST_TEST((low.severity == 0 && low.example == at(1)));
  BOOST_TEST((high.count == 4U && high.severity == 3 && high.example == at(4)));
  Trouble merged = low;
  merged.merge(high), merged.merge(trouble({{3, 7}})), merged.merge({});
  BOOST_TEST((merged.count == 7U && merged.severity == 3 && merged.example == at(4)));
}

BOOST_AUTO_TEST_CASE(questions_are_counted_by_effect_and_bounce_and_judged) {
  const Scene scene = scene_of({ball});
  const Told seen = told(auditing(scene, routine()),
                         wave_of(scene, routine(), {from_below, beside}, Effect::reflection, 2));
  BOOST_REQUIRE(seen.account.waves.size() == 1U);
  const WaveAccount& wave = seen.account.waves[0];
  BOOST_TEST((wave.effect == Effect::reflection && wave.bounce == 2));
  BOOST_TEST((wave.rays == 2U && wave.questions == 2U));
  BOOST_TEST(wave.tally.of(Verdict::right) == 2U);
  BOOST_TEST(seen.account.wrong() == 0U);
  BOOST_TEST(wave.tally.ulps.count() == 1U);
}

BOOST_AUTO_TEST_CASE(a_pixel_shows_the_worst_of_its_verdicts) {
  const Scene scene = scene_of({ball, Sphere<double>{{0, 0, 8}, 1}});
  SceneRay ray = from_below;
  ray.pixel = 12;
  Wave wave = wave_of(scene, routine(), {ray});
  wave.answers[sphere][0] = Answer::miss();
  const Told seen = told(auditing(scene, routine()), wave, 10);
  BOOST_TEST((seen.sights == std::vector<Sight>{{}, {}, {Verdict::false_miss}, {}}));
  BOOST_TEST(seen.account.wrong() == 1U);
  const Worst* worst = seen.account.waves[0].tally.worst(Verdict::false_miss);
  BOOST_REQUIRE(worst != nullptr);
  BOOST_TEST(worst->severity > 0x1p40);
}

BOOST_AUTO_TEST_CASE(verdicts_have_an_order_to_be_seen_in) {
  BOOST_TEST(is_worse_to_see(Verdict::touch, Verdict::right));
  BOOST_TEST(is_worse_to_see(Verdict::false_miss, Verdict::touch));
  for (std::size_t i = 0; i < verdict_count; ++i) {
    const auto verdict = static_cast<Verdict>(i);
    BOOST_TEST(is_worse_to_see(verdict, Verdict::right) == (verdict != Verdict::right));
    BOOST_TEST(is_worse_to_see(Verdict::crashed, verdict) == (verdict != Verdict::crashed));
  }
}

BOOST_AUTO_TEST_CASE(what_was_not_asked_is_counted_and_not_judged) {
  const Scene scene = scene_of({ball});
  Wave wave = wave_of(scene, routine(), {from_below});
  wave.answers[sphere][0] = Answer::unasked();
  const Told seen = told(auditing(scene, routine()), wave);
  BOOST_TEST(seen.account.waves[0].tally.unasked == 1U);
  BOOST_TEST(seen.account.waves[0].tally.cases == 0U);
}

BOOST_AUTO_TEST_CASE(a_ray_that_is_told_to_meet_its_surface_where_it_leaves_it_intersects_itself) {
  const Scene scene = scene_of({ball});
  // It leaves from a point within the ball, and so meets it again.
  const SceneRay ray = leaving(0, {0, 0, 1 - 0x1p-20}, {0, 0, 1}, {0, 0, 2});
  const Told seen = told(auditing(scene, routine()), wave_of(scene, routine(), {ray}));
  BOOST_TEST(seen.sights[0].met_again);
  const Trouble& troubles = seen.account.waves[0].self_intersections;
  BOOST_TEST(troubles.count == 1U);
  BOOST_TEST(troubles.severity == 0x1p-20, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((troubles.example == Case{ray.ray, ball}));
}

BOOST_AUTO_TEST_CASE(the_other_side_of_its_surface_is_no_self_intersection) {
  const Scene scene = scene_of({ball});
  const SceneRay inward = leaving(0, {0, 0, 1 - 0x1p-20}, {0, 0, 1}, {0, 0, -1});
  const SceneRay from_elsewhere = {.ray = {{0, 0, -1 - 0x1p-20}, {0, 0, 1}}};
  const Told seen =
      told(auditing(scene, routine()), wave_of(scene, routine(), {inward, from_elsewhere}));
  BOOST_TEST(seen.account.waves[0].tally.of(Verdict::right) == 2U);
  BOOST_TEST(!seen.sights[0].met_again);
  BOOST_TEST(seen.account.waves[0].self_intersections.count == 0U);
}

BOOST_AUTO_TEST_CASE(of_two_roots_near_a_grazing_departure_the_nearer_one_is_its_own) {
  const Scene scene = scene_of({ball});
  // Just above the ball and along it: it is left at t = 2^-20 and met again at 3 2^-20.
  const SceneRay ray = leaving(0, {-0x1p-19, 0, 1 - 0x1p-41}, {0, 0, 1}, {1, 0, 0});
  for (const bool is_nearer : {true, false}) {
    Wave wave = wave_of(scene, routine(), {ray});
    const oracle::Roots roots = oracle::roots(wave.cases[sphere][0]);
    BOOST_REQUIRE((roots.count == 2 && nearest<double>(roots.listed[0].t) > 0));
    wave.answers[sphere][0] = Answer::hit(roots.listed[is_nearer ? 0 : 1].t);
    const Told seen = told(auditing(scene, routine()), wave);
    BOOST_TEST(seen.account.waves[0].self_intersections.count == (is_nearer ? 1U : 0U));
  }
}

BOOST_AUTO_TEST_CASE(a_missed_lid_is_a_leak) {
  const Subject flawed = saying(disk, [](const Case&) { return Answer::miss(); });
  const Told seen = told(auditing(can, flawed), wave_of(can, flawed, {into_lid}));
  const Trouble& leaks = seen.account.waves[0].leaks;
  BOOST_TEST(leaks.count == 1U);
  BOOST_TEST(leaks.severity > 0x1p40);
  BOOST_TEST((leaks.example == Case{into_lid.ray, can.primitives[0].shape}));
  const Told right = told(auditing(can, routine()), wave_of(can, routine(), {into_lid}));
  BOOST_TEST(right.account.waves[0].leaks.count == 0U);
}

BOOST_AUTO_TEST_CASE(a_lid_that_was_not_asked_for_is_missed) {
  Wave wave = wave_of(can, routine(), {{.ray = {{2, 0, 0.5}, {-1, 0, 0}}}});
  wave.answers[cylinder][0] = Answer::miss();
  wave.pairs[disk].clear(), wave.cases[disk].clear(), wave.answers[disk].clear();
  BOOST_TEST(told(auditing(can, routine()), wave).account.waves[0].leaks.count == 1U);
}

BOOST_AUTO_TEST_CASE(what_one_of_two_surfaces_misses_the_other_may_tell) {
  // Both are missed where it enters; the wall is told where it leaves: that is inside.
  Wave wave = wave_of(can, routine(), {{.ray = {{2, 0, 0.999}, {-1, 0, 0}}}});
  wave.answers[cylinder][0] = Answer::hit(real(3.0));
  BOOST_TEST(told(auditing(can, routine()), wave).account.waves[0].leaks.count == 1U);
  // The lid is told just there, though the ray passes under it.
  wave.answers[disk][0] = Answer::hit(real(1.001));
  BOOST_TEST(told(auditing(can, routine()), wave).account.waves[0].leaks.count == 0U);
}

BOOST_AUTO_TEST_CASE(a_rim_that_both_pass_by_is_a_leak_and_one_that_one_passes_is_none) {
  for (const bool is_lid_told : {true, false}) {
    const SceneRay ray = {.ray = {{2, 0, 2}, {-1, 0, -1}}};
    Wave wave = wave_of(can, routine(), {ray});
    wave.answers[disk][0] = is_lid_told ? Answer::hit(real(1.0)) : Answer::miss();
    wave.answers[cylinder][0] = Answer::miss();
    const Told seen = told(auditing(can, routine()), wave);
    BOOST_TEST(seen.account.waves[0].leaks.count == (is_lid_told ? 0U : 1U));
  }
}

BOOST_AUTO_TEST_CASE(a_surface_that_is_left_does_not_leak) {
  const SceneRay upward = leaving(0, {0.5, 0, 1 - 0x1p-30}, {0, 0, 1}, {0, 0, 1});
  Wave wave = wave_of(can, routine(), {upward});
  wave.answers[disk][0] = Answer::miss();
  const Told seen = told(auditing(can, routine()), wave);
  BOOST_TEST(seen.account.waves[0].tally.of(Verdict::false_miss) == 1U);
  BOOST_TEST(seen.account.waves[0].leaks.count == 0U);
}

BOOST_AUTO_TEST_CASE(an_offset_that_skips_a_meeting_loses_contact) {
  const Scene scene =
      scene_of({Disk<double>{{0, 0, 0}, {0, 0, 1}, 9}, Sphere<double>{{0, 0, 1}, 1}});
  // Up from the disk, near where the sphere rests on it.
  const SceneRay ray = leaving(0, {0.25, 0, 0}, {0, 0, 1}, {0, 0, 2});
  const double contact = 1 - std::sqrt(1 - 0.0625);
  const std::vector offsets = {no_offset, t_min_of(1e-3), t_min_of(0.1), normal_of(1)};
  const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
  BOOST_REQUIRE(seen.account.offsets.size() == 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const OffsetAccount& offset = seen.account.offsets[i];
    BOOST_TEST(offset.rays == 1U);
    BOOST_TEST(offset.lost_contact.count == (i == 2 ? 1U : 0U));
  }
  const Trouble& lost = seen.account.offsets[2].lost_contact;
  BOOST_TEST(lost.severity == contact, boost::test_tools::tolerance(1e-12));
  BOOST_TEST((lost.example == Case{ray.ray, scene.primitives[1].shape}));
  BOOST_TEST(seen.account.safe.contact == contact, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(an_offset_beyond_another_surface_loses_contact_with_it) {
  const Scene scene = scene_of(
      {Disk<double>{{0, 0, 4}, {0, 0, 1}, 9}, Disk<double>{{0, 0, 4 + 0x1p-46}, {0, 0, 1}, 9}});
  const SceneRay ray = leaving(0, {0, 0, 4}, {0, 0, 1}, {0, 0, 1});
  const std::vector offsets = {normal_of(8), normal_of(32)};  // of 2^-50
  const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
  BOOST_TEST(seen.account.offsets[0].lost_contact.count == 0U);
  BOOST_TEST(seen.account.offsets[1].lost_contact.count == 1U);
  BOOST_TEST(seen.account.offsets[1].lost_contact.severity == 0x1p-46);
}

BOOST_AUTO_TEST_CASE(another_ray_past_a_silhouette_is_no_lost_contact) {
  const Scene scene =
      scene_of({Disk<double>{{0, 0, 4}, {0, 0, 1}, 9}, Sphere<double>{{64, 0, 3}, 1 + 0x1p-51}});
  // It grazes the sphere's top, and moved up it passes above.
  const SceneRay ray = leaving(0, {0, 0, 4}, {0, 0, 1}, {1, 0, 0x1p-600});
  const std::vector offsets = {normal_of(4)};
  const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
  BOOST_TEST(seen.account.safe.contact == 64, boost::test_tools::tolerance(1e-6));
  BOOST_TEST(seen.account.offsets[0].lost_contact.count == 0U);
}

BOOST_AUTO_TEST_CASE(a_true_second_meeting_with_its_own_surface_may_be_lost) {
  const Scene scene = scene_of({ball});
  // A chord of 2^-6 from the ball's top, into it.
  const double depth = 0x1p-13;
  const SceneRay ray = leaving(0, {-0x1p-7, 0, std::sqrt(1 - 0x1p-14)}, {0, 0, 1}, {1, 0, 0});
  const std::vector offsets = {t_min_of(0x1p-7), t_min_of(0x1p-5)};
  const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
  BOOST_TEST(seen.account.offsets[0].lost_contact.count == 0U);
  BOOST_TEST(seen.account.offsets[1].lost_contact.count == 1U);
  BOOST_TEST(seen.account.offsets[1].lost_contact.severity == 0x1p-6,
             boost::test_tools::tolerance(depth));
  BOOST_TEST(seen.account.safe.contact == 0x1p-6, boost::test_tools::tolerance(depth));
}

BOOST_AUTO_TEST_CASE(a_meeting_with_its_own_surface_is_lost_from_either_side_of_it) {
  const Scene scene = scene_of({ball});
  const std::vector offsets = {t_min_of(0.5), t_min_of(3)};
  for (const double off : {-0x1p-30, 0x1p-30}) {
    const SceneRay ray = leaving(0, {0, 0, 1 + off}, {0, 0, 1}, {0, 0, -1});
    const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
    BOOST_TEST(seen.account.offsets[0].lost_contact.count == 0U);
    BOOST_TEST(seen.account.offsets[1].lost_contact.count == 1U);
    BOOST_TEST(seen.account.offsets[1].lost_contact.severity == 2 + off,
               boost::test_tools::tolerance(1e-12));
  }
}

BOOST_AUTO_TEST_CASE(the_light_that_a_shadow_ray_goes_to_is_no_contact) {
  const Scene scene = scene_of({ball, Sphere<double>{{0, 0, 4}, 1}});
  const std::vector offsets = {t_min_of(3)};
  SceneRay ray = leaving(0, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
  for (const std::int32_t light : {SceneRay::nothing, 1}) {
    ray.light = light;
    const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
    const bool is_met = light == SceneRay::nothing;
    BOOST_TEST(seen.account.offsets[0].lost_contact.count == (is_met ? 1U : 0U));
    BOOST_TEST(std::isinf(seen.account.safe.contact) == !is_met);
  }
}

BOOST_AUTO_TEST_CASE(what_lies_behind_the_end_of_a_shadow_ray_is_no_contact) {
  const Scene scene = scene_of({ball, Sphere<double>{{0, 0, 4}, 1}});
  const std::vector offsets = {t_min_of(9)};
  SceneRay ray = leaving(0, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
  ray.ray.t_max = 1.5;
  const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
  BOOST_TEST(seen.account.offsets[0].lost_contact.count == 0U);
  BOOST_TEST(std::isinf(seen.account.safe.contact));
}

BOOST_AUTO_TEST_CASE(acne_is_told_of_each_offset) {
  const Scene scene = scene_of({ball});
  const SceneRay ray = leaving(0, {0, 0, 1 - 0x1p-40}, {0, 0, 1}, {0, 0, 1});
  const std::vector offsets = {no_offset, t_min_of(1e-3), normal_of(0x1p16)};
  const Told seen = told(auditing(scene, routine(), offsets), wave_of(scene, routine(), {ray}));
  BOOST_TEST(seen.account.offsets[0].acne.count == 1U);
  BOOST_TEST(seen.account.offsets[0].acne.severity == 0x1p-40, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(seen.account.offsets[1].acne.count == 0U);
  BOOST_TEST(seen.account.offsets[2].acne.count == 0U);
  // Who tells t near 0 whatever the case has acne by all but those whose range it is not in.
  const Subject flawed = saying(sphere, [](const Case&) { return Answer::hit(real(0x1p-30)); });
  const Told planted = told(auditing(scene, flawed, offsets), wave_of(scene, flawed, {ray}));
  for (std::size_t i = 0; i < 3; ++i) {
    const Trouble& acne = planted.account.offsets[i].acne;
    BOOST_TEST((acne.count == (i == 1 ? 0U : 1U) && acne.severity == (i == 1 ? 0 : 0x1p-30)));
  }
  // So no t_min below what it tells is safe, wherever the surface is.
  BOOST_TEST(seen.account.safe.t_min == 0x1p-40, boost::test_tools::tolerance(1e-3));
  BOOST_TEST(planted.account.safe.t_min == 0x1p-30);
}

BOOST_AUTO_TEST_CASE(the_safe_offset_brings_every_point_to_its_side) {
  const Scene scene = scene_of({ball});
  const std::vector offsets = {no_offset};
  const SceneRay outward = leaving(0, {0, 0, 1 - 0x1p-50}, {0, 0, -1}, {0, 0, 2});
  const SceneRay inward = leaving(0, {0, 0, 1 + 0x1p-48}, {0, 0, -1}, {0, 0, -1});
  const SceneRay well = leaving(0, {0, 0, 1 + 0x1p-40}, {0, 0, 1}, {0, 0, 1});
  const auto safe_of = [&](const std::vector<SceneRay>& rays) {
    return told(auditing(scene, routine(), offsets), wave_of(scene, routine(), rays)).account.safe;
  };
  BOOST_TEST((safe_of({well}).t_min == 0 && safe_of({well}).ulps == 0));
  const SafeOffset once = safe_of({outward, well});
  BOOST_TEST(once.t_min == 0x1p-50, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(once.ulps == 8, boost::test_tools::tolerance(1e-9));  // below 1 an ulp is 2^-53
  const SafeOffset both = safe_of({outward, inward});
  BOOST_TEST(both.t_min == 0x1p-48, boost::test_tools::tolerance(1e-9));
  BOOST_TEST(both.ulps == 16, boost::test_tools::tolerance(1e-9));
  BOOST_TEST((both.ulps_case == Case{inward.ray, ball}));
}

BOOST_AUTO_TEST_CASE(what_is_culled_wrongly_is_told) {
  const Scene scene = scene_of({ball, Sphere<double>{{0, 4, 0}, 1}});
  const Wave wave = wave_of(scene, routine(), {from_below, beside});
  SceneAuditing careless = auditing(scene, routine());
  careless.candidates = [](const Ray<double>&) { return std::vector<std::uint32_t>{1}; };
  careless.thorough = true;
  const Culling found = told(careless, wave).account.culling;
  BOOST_TEST(found.settled == 2U);
  BOOST_TEST(found.wrong.count == 1U);
  BOOST_TEST((found.wrong.example == Case{from_below.ray, ball}));
  SceneAuditing careful = auditing(scene, routine());
  careful.candidates = [](const Ray<double>&) { return std::vector<std::uint32_t>{0}; };
  careful.thorough = true;
  BOOST_TEST(told(careful, wave).account.culling.settled == 2U);
  BOOST_TEST(told(careful, wave).account.culling.wrong.count == 0U);
}

BOOST_AUTO_TEST_CASE(culled_pairs_are_settled_of_a_share_of_the_rays) {
  const Scene scene = scene_of({ball});
  Wave wave = {.effect = Effect::primary, .bounce = 0};
  for (std::uint32_t pixel = 0; pixel < 1600; ++pixel)
    wave.rays.push_back({.ray = beside.ray, .pixel = pixel});
  SceneAuditing none = auditing(scene, routine());
  none.candidates = [](const Ray<double>&) { return std::vector<std::uint32_t>{}; };
  const Culling found = told(none, wave).account.culling;
  BOOST_TEST((found.asked == 0U && found.culled == 1600U));
  BOOST_TEST((found.settled > 80U && found.settled < 120U));
  none.thorough = true;
  BOOST_TEST(told(none, wave).account.culling.settled == 1600U);
  for (SceneRay& ray : wave.rays) ray.light = 0;  // which is never asked, and so not culled
  BOOST_TEST(told(none, wave).account.culling.settled == 0U);
}

BOOST_AUTO_TEST_CASE(accounts_merge_exactly_whatever_goes_first_together) {
  const Subject& coarse = *subject_of("textbook/float");
  const Scene scene = scene_of(
      {ball, Disk<double>{{0, 0, 1}, {0, 0, 1}, 1}, Cylinder<double>{{0, 0, 0}, {0, 0, 1}, 1}},
      {{1, 2}});
  const std::vector<Offset> offsets(usual_offsets().begin(), usual_offsets().end());
  const auto account = [&](std::uint32_t pixel, Effect effect, double off) {
    SceneRay ray = leaving(0, {0.5, off, 0.875}, {0.5, 0, 0.875}, {0.25, 0.5, 0.75});
    ray.pixel = pixel;
    const Wave wave = wave_of(scene, coarse, {ray, ray}, effect, 1);
    SceneAccount made;
    std::vector<Sight> sights(2);
    audit_wave(auditing(scene, coarse, offsets), wave, made, pixel, sights);
    return made;
  };
  const SceneAccount a = account(0, Effect::refraction, 0.125),
                     b = account(1, Effect::shadow, 0.25),
                     c = account(2, Effect::refraction, 0.125), none;
  SceneAccount ab = a, bc = b, left, right = none;
  ab.merge(b), bc.merge(c);
  left = ab, left.merge(c);
  right.merge(a), right.merge(bc), right.merge(none);
  BOOST_TEST(text_of(left) == text_of(right));
  BOOST_REQUIRE(left.waves.size() == 2U);
  BOOST_TEST((left.waves[0].effect == Effect::shadow && left.waves[1].rays == 4U));
  BOOST_TEST(left.offsets[0].rays == 6U);
}

BOOST_AUTO_TEST_CASE(merging_leaves_nothing_out) {
  const Case question = {from_below.ray, ball};
  const Trouble trouble = {3, 4, question};
  SceneAccount all;
  WaveAccount& wave = all.wave(Effect::reflection, 3);
  wave.rays = 2, wave.questions = 5, wave.nanoseconds = 7;
  wave.self_intersections = wave.leaks = trouble;
  wave.tally.unasked = 2;
  all.offsets = {{no_offset, 6, trouble, trouble}};
  all.safe = {1e-3, 2, question, question, 0.5, question};
  all.culling = {3, 4, trouble, 5};
  SceneAccount merged, twice;
  merged.offsets = twice.offsets = {{.offset = no_offset}};
  merged.merge(all);
  BOOST_TEST(text_of(merged) == text_of(all));
  BOOST_TEST(merged.waves[0].nanoseconds == 7);
  twice.merge(all), twice.merge(all);
  BOOST_TEST((twice.waves[0].leaks.count == 6U && twice.offsets[0].acne.count == 6U));
  BOOST_TEST((twice.culling.asked == 6U && twice.culling.culled == 10U));
  BOOST_TEST((twice.waves[0].questions == 10U && twice.waves[0].tally.unasked == 4U));
}

BOOST_AUTO_TEST_CASE(the_worst_of_each_outcome_has_a_cause_in_the_end) {
  const Subject& coarse = *subject_of("textbook/float");
  const Scene scene = scene_of({Sphere<double>{{0, 0, 4096}, 1}});
  // Beyond the sphere's edge by less than the routine can tell.
  std::vector<SceneRay> rays;
  for (int i = 0; i < 64; ++i) rays.push_back({.ray = {{1 + 0x1p-12 * i, 0, 0}, {0, 0, 1}}});
  const SceneAuditing audit = auditing(scene, coarse);
  Told seen = told(audit, wave_of(scene, coarse, rays));
  BOOST_REQUIRE(seen.account.wrong() > 0U);
  conclude(audit, seen.account);
  for (const Outcome& outcome : seen.account.waves[0].tally.outcomes)
    if (is_wrong(outcome.verdict)) BOOST_TEST(told(outcome.worst->diagnosis) != "unknown");
}
