#include "scenes/picture_run.hpp"

#include <algorithm>
#include <boost/test/unit_test.hpp>
#include <chrono>
#include <mutex>
#include <thread>

#include "tests/audit/named.hpp"
#include "tests/scenes/account_text.hpp"

using namespace rayaudit;

namespace {

/// A glass sphere, a can and a light above a disk, in floats.
Scene small_scene() {
  Scene scene;
  scene.film = {60, 72};
  scene.camera = {.eye = {0, 1.5F, -6}, .half_width = 0.5F, .half_height = 0.6F};
  scene.primitives = {{.shape = Disk<double>{{0, 0, 0}, {0, 1, 0}, 20}},
                      {.shape = Sphere<double>{{-1, 1, 0}, 1}},
                      {.shape = Cylinder<double>{{1, 0, 0}, {1, 1.5, 0}, 0.5}},
                      {.shape = Disk<double>{{1, 1.5, 0}, {0, 1, 0}, 0.5}}};
  scene.primitives[1].material.finish = Finish::dielectric;
  scene.lights = {{.kind = Light::Kind::point, .where = {4, 6, -4}, .colour = {60, 60, 60}}};
  scene.seams = {{3, 2}};
  return scene;
}

const Subject& coarse() { return *subject_of("textbook/float"); }

PicturePlan plan_of(const Scene& scene, const Subject& subject) {
  PicturePlan plan = {scene, subject, effects(scene)};
  plan.offsets.assign(usual_offsets().begin(), usual_offsets().end());
  return plan;
}

struct Run {
  Picture picture;
  std::vector<Band> bands;
  std::vector<Progress> progress;
};
Run run(const PicturePlan& plan) {
  Run run;
  run.picture = run_picture(
      plan, [&](const Band& band) { run.bands.push_back(band); },
      [&](Progress progress) { run.progress.push_back(progress); });
  return run;
}

std::string text_of(const std::vector<Band>& bands) {
  std::string text;
  for (const auto& [first, last, pixels, exact, sights] : bands) {
    text += std::to_string(first) + ' ' + std::to_string(last);
    for (const auto* picture : {&pixels, &exact})
      for (const Colour& colour : *picture)
        for (const double part : {colour.x, colour.y, colour.z})
          text += ' ' + rayaudit::text_of(part);
    for (const Sight& sight : sights)
      text += ' ' + std::string(name(sight.worst)) + (sight.met_again ? " met again" : "");
  }
  return text;
}

}  // namespace

BOOST_AUTO_TEST_CASE(pictures_and_accounts_are_the_same_on_any_number_of_threads) {
  const Scene scene = small_scene();
  PicturePlan plan = plan_of(scene, coarse());
  plan.threads = 1;
  const Run alone = run(plan);
  plan.threads = 3;
  const Run together = run(plan);
  BOOST_TEST(alone.picture.account.waves.size() > 5U);
  BOOST_TEST(alone.picture.account.wrong() > 0U);
  BOOST_TEST(
      (rayaudit::text_of(alone.picture.account) == rayaudit::text_of(together.picture.account)));
  BOOST_TEST((text_of(alone.bands) == text_of(together.bands)));
}

BOOST_AUTO_TEST_CASE(bands_come_whole_and_in_order_and_progress_reaches_the_end) {
  const Scene scene = small_scene();
  PicturePlan plan = plan_of(scene, coarse());
  plan.threads = 3;
  const Run made = run(plan);
  BOOST_TEST(made.picture.whole);
  int row = 0;
  for (const Band& band : made.bands) {
    BOOST_TEST(band.first == row);
    row = band.last;
    const auto pixels = static_cast<std::size_t>(60 * (band.last - band.first));
    BOOST_TEST((band.pixels.size() == pixels && band.exact.size() == pixels &&
                band.sights.size() == pixels));
  }
  BOOST_TEST(row == 72);
  BOOST_REQUIRE(made.progress.size() == made.bands.size());
  BOOST_TEST((made.progress.front().done == 60U * 16 && made.progress.front().all == 60U * 72));
  BOOST_TEST(made.progress.back().done == 60U * 72);
}

BOOST_AUTO_TEST_CASE(what_is_not_asked_for_is_not_made) {
  const Scene scene = small_scene();
  PicturePlan plan = plan_of(scene, coarse());
  const Run all = run(plan);
  plan.audited = plan.exact = false;
  const Run plain = run(plan);
  BOOST_TEST((plain.bands[0].exact.empty() && plain.bands[0].sights.empty()));
  BOOST_TEST(plain.picture.account.waves.empty());
  for (std::size_t i = 0; i < all.bands.size(); ++i)
    BOOST_TEST((all.bands[i].pixels == plain.bands[i].pixels));
}

BOOST_AUTO_TEST_CASE(the_exact_picture_is_that_of_the_exact_subject) {
  const Scene scene = small_scene();
  const Run made = run(plan_of(scene, exact_subject(float_format)));
  for (const Band& band : made.bands) BOOST_TEST((band.pixels == band.exact));
  BOOST_TEST(made.picture.account.wrong() == 0U);
  const Run other = run(plan_of(scene, coarse()));
  for (std::size_t i = 0; i < made.bands.size(); ++i)
    BOOST_TEST((other.bands[i].exact == made.bands[i].exact));
}

BOOST_AUTO_TEST_CASE(a_stopped_picture_has_its_first_bands_and_says_so) {
  const Scene scene = small_scene();
  for (const int threads : {1, 3}) {
    PicturePlan plan = plan_of(scene, coarse());
    plan.threads = threads;
    std::atomic<bool> stop = false;
    int row = 0;
    const auto keep = [&](const Band& band) {
      BOOST_TEST(band.first == row);
      row = band.last;
      stop = true;
    };
    const Picture picture = run_picture(plan, keep, {}, &stop);
    BOOST_TEST(!picture.whole);
    BOOST_TEST((row >= 16 && row < 72));
  }
}

BOOST_AUTO_TEST_CASE(a_subject_that_cannot_answer_ends_the_run) {
  const Scene scene = small_scene();
  Subject missing = coarse();
  missing.answer[1] = [](std::span<const Case>, std::span<Answer>) {
    throw NoAnswer("its plugin is missing");
  };
  PicturePlan plan = plan_of(scene, missing);
  plan.threads = 3;
  BOOST_CHECK_THROW(run(plan), NoAnswer);
}

BOOST_AUTO_TEST_CASE(a_band_that_fails_leaves_no_thread_waiting_for_it) {
  Scene scene = small_scene();
  scene.film = {4, 16 * 64};
  Subject failing = coarse();
  std::atomic<bool> has_failed = false;
  failing.answer[0] = [&, here = failing.answer[0]](std::span<const Case> cases,
                                                    std::span<Answer> answers) {
    if (!has_failed.exchange(true)) {
      std::this_thread::sleep_for(
          std::chrono::milliseconds(300));  // others get ahead as far as may be
      throw NoAnswer("it broke off");
    }
    here(cases, answers);
  };
  PicturePlan plan = plan_of(scene, failing);
  plan.threads = 3;
  BOOST_CHECK_THROW(run(plan), NoAnswer);
}

BOOST_AUTO_TEST_CASE(a_subject_elsewhere_is_asked_by_one_thread_alone) {
  const Scene scene = small_scene();
  Subject elsewhere = coarse();
  elsewhere.is_elsewhere = true;
  std::mutex mutex;
  std::vector<std::thread::id> askers;
  for (auto& answer : elsewhere.answer)
    answer = [&, here = answer](std::span<const Case> cases, std::span<Answer> answers) {
      std::unique_lock lock(mutex);
      if (std::find(askers.begin(), askers.end(), std::this_thread::get_id()) == askers.end())
        askers.push_back(std::this_thread::get_id());
      lock.unlock();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // for others to come
      here(cases, answers);
    };
  PicturePlan plan = plan_of(scene, elsewhere);
  plan.threads = 3, plan.exact = false;
  BOOST_TEST(run(plan).picture.whole);
  BOOST_TEST(askers.size() == 1U);
}
